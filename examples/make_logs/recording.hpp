#pragma once
/// Simulates a plan with a Panda, and writes the recording to files.
#include <functional>
#include <string>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

#include "make_logs/plan.hpp"

namespace rme::examples {

/// One row of a log: the state, the torque commanded for the next period, the observer's output from the measurements
/// so far, and the truth.
struct RecordedRow {
  double t;                                      // [s]
  JointVector<double, 7> q, dq, tau_c, tau_ext;  // [rad], [rad/s], [N m], [N m]
  Eigen::Vector4d truth;                         // m, r_x, r_y, r_z, flange axes [kg, m, m, m]
  Eigen::Vector3d push;                          // force, world axes [N]
};

struct Recording {
  std::vector<RecordedRow> rows;
  std::string refusal;  // why the arm cannot carry out the plan; empty if it can
};

/// Simulates a plan; lost rows are missing. Ends early, with a refusal, if the arm comes near a joint limit or a
/// singular pose, or a joint's speed or torque limit is exceeded.
Recording record(const Plan& plan, const SyntheticArmConfig<7>& config);

/// Writes a log, gzip-compressed if the path ends in ".gz".
/// @throws std::runtime_error if that cannot be done
void write_log(const std::string& path, const Recording& recording);

/// The description of one recording in a manifest.
struct ManifestEntry {
  std::string name, file;
  std::uint64_t seed;
  Plan plan;
  SyntheticArmConfig<7> config;
};

/// The manifest of a folder of recordings, as JSON.
/// @param kind     value of --kind
/// @param physics  value of --physics
std::string manifest(const std::string& kind, const std::string& physics, const std::vector<ManifestEntry>& entries);

}  // namespace rme::examples
