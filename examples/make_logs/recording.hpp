#pragma once
/// A plan carried out by a simulated Panda, and the files that it becomes.
#include <functional>
#include <string>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

#include "make_logs/plan.hpp"

namespace rme::examples {

/// What is written down at each tick: the state, the torque commanded for the next period, the observer's output from
/// what was measured up to now, and the truth.
struct RecordedRow {
  double t;                                      // [s]
  JointVector<double, 7> q, dq, tau_c, tau_ext;  // [rad], [rad/s], [N m]
  Eigen::Vector4d truth;                         // m, r
  Eigen::Vector3d push;                          // [N]
};

struct Recording {
  std::vector<RecordedRow> rows;
  std::string refusal;  // why the arm should not have been asked to do this; empty if all is well
};

/// Carries out a plan; rows that get lost are missing. Ends early where the arm comes near a joint limit, a singular
/// pose, or asks too much of a joint.
Recording record(const Plan& plan, const SyntheticArmConfig<7>& config);

/// Writes a log, gzip-compressed if the path ends in ".gz".
/// @throws std::runtime_error if that cannot be done
void write_log(const std::string& path, const Recording& recording);

/// What a manifest says of one recording.
struct ManifestEntry {
  std::string name, file;
  std::uint64_t seed;
  Plan plan;
  SyntheticArmConfig<7> config;
};

/// The manifest of a folder of recordings, as JSON.
/// @param kind     what is wrong with the arm
/// @param physics  whose
std::string manifest(const std::string& kind, const std::string& physics, const std::vector<ManifestEntry>& entries);

}  // namespace rme::examples
