#pragma once
/// What the experiments of the paper have in common: their payloads, the arm they run on, and its options.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <synthetic_arm/synthetic_arm.hpp>

#include "io/program.hpp"

namespace rme::examples {

constexpr double kPeriod = 1e-3;  // of the control loop [s]
constexpr double kPi = 3.14159265358979323846;

/// One row of the paper's Table 2: a payload, and what the published system made of it on the real arm.
struct PublishedTrial {
  double mass;          // [kg]
  Eigen::Vector3d com;  // flange axes [m]
  Eigen::Vector4d mean, deviation;
};

/// Table 2 of the paper, as its supplementary text prints it.
const std::array<PublishedTrial, 6>& published_trials();

/// A payload of the experiments: a box, of which only mass and centre are told to anybody.
RigidBody experiment_payload(double mass, const Eigen::Vector3d& com);

/// On what arm an experiment runs.
struct Setup {
  bool mujoco = false;    // MuJoCo's physics in place of our own
  bool friction = false;  // torque sensed before the gears: joint friction holds the arm back and shows in tau_ext
  bool quick = false;     // a tenth of the work, to see that it works
  std::uint64_t seed = 1;
  std::optional<std::string> output;  // folder of the CSV files

  /// Takes --physics, --friction, --quick, --seed and --output. @throws ArgumentError
  static Setup parse(Arguments& arguments);
  static constexpr const char* kUsage =
      R"(  --physics NAME    synthetic (default), or mujoco where this was built with it
  --friction        an arm that senses torque before its gears: joint friction holds it back and shows in the torque.
                    Without it, torque is sensed behind the gears, as on the arm of the paper
  --seed N          of everything random (default 1)
  --quick           less of everything: to see that it works
  --output DIR      write the data there as CSV; the folder is made if need be. plot.py draws them
  --help            this text
)";

  /// An arm with its own draw of sensor noise, offsets and friction. Without `faults` it is ideal.
  SyntheticArmConfig<7> arm(std::uint64_t trial, bool faults = true) const;
  std::string name() const;  // "synthetic arm, link-side sensing"
};

}  // namespace rme::examples
