#pragma once
/// The options that mend a log, written as the user may type them.
#include <Eigen/Core>
#include <string>
#include <vector>

#include "log_diagnosis/log_diagnosis.hpp"

namespace rme::examples {

/// Writes options that go beyond those given. Joints count from 0, keys are q, dq, tau and tau_ext.
class Advice {
 public:
  explicit Advice(const GivenOptions& given) : given_(given) {}

  /// All columns of the key times `factor`; the key may be t.
  std::string scaled(const std::string& key, double factor) const;
  /// The key's columns are not used.
  std::string none(const std::string& key) const;
  /// Columns of these joints with the opposite sign.
  std::string turned(const std::string& key, const std::vector<Eigen::Index>& joints) const;
  /// Columns of q, and of dq if the log has it, with the opposite sign.
  std::string turned_joints(const std::vector<Eigen::Index>& joints) const;
  /// Joint j's columns are those that joint order[j] has now. Keys that the log does not have are left out.
  std::string reordered(const std::vector<std::string>& keys, const std::vector<Eigen::Index>& order) const;
  /// A joint of q plus an offset [rad].
  std::string shifted(Eigen::Index joint, double offset) const;
  /// The columns of one key become those of another.
  std::string moved(const std::string& from, const std::string& to) const;
  std::string gains(const Eigen::VectorXd& gains) const;

 private:
  const std::vector<LogColumn>& columns(const std::string& key) const;
  std::string option(const std::string& items) const;
  std::string flipped(const std::string& key, const std::vector<Eigen::Index>& joints) const;

  const GivenOptions& given_;
};

}  // namespace rme::examples
