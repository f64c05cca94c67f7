#pragma once
/// What the experiments of the paper have in common: their payloads, the arm they run on, and its options.
#include <array>
#include <cstdint>
#include <mujoco_arm/physics_option.hpp>
#include <optional>
#include <string>
#include <synthetic_arm/synthetic_arm.hpp>

#include "io/program.hpp"

namespace rme::examples {

constexpr double kPeriod = 1e-3;  // of the control loop [s]
constexpr double kPi = 3.14159265358979323846;

/// One row of the paper's Table 2: a payload, and the published estimates of it on the real arm.
struct PublishedTrial {
  double mass;                      // [kg]
  Eigen::Vector3d com;              // flange axes [m]
  Eigen::Vector4d mean, deviation;  // of the estimates: m, r_x, r_y, r_z [kg, m, m, m]
};

/// Table 2 of the paper, as its supplementary text prints it.
const std::array<PublishedTrial, 6>& published_trials();

/// A payload of the experiments: a box of 6 x 6 x 10 cm. Mass [kg] and centre of mass (flange axes, [m]) are given.
RigidBody experiment_payload(double mass, const Eigen::Vector3d& com);

/// The arm on which an experiment runs, and the experiment's options.
struct Setup {
  Engine engine = Engine::Synthetic;
  bool friction = false;  // torque is sensed at the motors: tau_ext contains the joint friction that acts on the arm
  bool quick = false;     // fewer trials, to check that the program works
  std::uint64_t seed = 1;
  std::optional<std::string> output;  // folder of the CSV files

  /// Takes --physics, --friction, --quick, --seed and --output. @throws ArgumentError
  /// @param usual  without --physics
  static Setup parse(Arguments& arguments, Engine usual = Engine::Synthetic);
  static constexpr const char* kUsage =
      R"(  --physics NAME    synthetic (default), or mujoco if this was built with it
  --friction        an arm with joint friction that senses torque at the motors, so that the torque contains the friction.
                    Without this option, torque is sensed behind the gears, as on the arm of the paper
  --seed N          of everything random (default 1)
  --quick           fewer trials, to check that the program works
  --output DIR      write the data there as CSV; the folder is created if it does not exist. plot.py draws the data
  --help            this text
)";

  /// An arm with its own draw of sensor noise, offsets and friction. Without `faults` it is ideal.
  SyntheticArmConfig<7> arm(std::uint64_t trial, bool faults = true) const;
  std::string name() const;  // "synthetic arm, link-side sensing"
};

}  // namespace rme::examples
