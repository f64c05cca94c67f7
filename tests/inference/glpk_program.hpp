#pragma once
/// Linear programs solved by GLPK, whose simplex method is another one.
#include <Eigen/Core>
#include <memory>
#include <string>

struct glp_prob;

namespace rme::testing {

enum class GlpkAnswer { Optimal, Infeasible, Unbounded };

/// max c.x subject to rows lower <= a.x <= upper; a side may be infinite.
class GlpkProgram {
 public:
  /// @param unknowns  number of free unknowns
  explicit GlpkProgram(int unknowns);
  void add_row(const Eigen::VectorXd& a, double lower, double upper);
  void bound(int unknown, double lower, double upper);
  /// Maximises, from the basis where the last call stopped.
  /// @param[out] value  of the maximum, if there is one
  /// @throws std::runtime_error if GLPK gives no answer
  GlpkAnswer maximise(const Eigen::VectorXd& c, double& value);

 private:
  struct Delete {
    void operator()(glp_prob* problem) const;
  };
  std::unique_ptr<glp_prob, Delete> problem_;
};

}  // namespace rme::testing
