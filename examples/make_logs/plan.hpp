#pragma once
/// The events of a recording, drawn at random: the arm's pose, its payloads, its motion and the pushes.
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <vector>

namespace rme::examples {

/// A payload is attached, becomes heavier, or is removed.
struct PayloadEvent {
  double t;  // [s]
  bool attach;
  char slot;        // which payload, "A" or "B"
  RigidBody body;   // all that the slot holds after the event, flange axes
  double ramp = 0;  // time over which the weight comes on [s]
};

/// A person pushes at the flange origin.
struct PushEvent {
  double t, duration;     // [s]
  Eigen::Vector3d force;  // world axes [N]
};

/// A path of the flange around its start: sines in each direction, and turns about two axes of the flange.
struct Motion {
  double start = 0, rise = 1.5;  // from rest into the full motion [s]
  Eigen::Vector3d amplitude = Eigen::Vector3d::Zero(), rate = amplitude, phase = amplitude;  // [m], [rad/s], [rad]
  Eigen::Matrix<double, 3, 2> axes = Eigen::Matrix<double, 3, 2>::Zero();                    // flange axes
  Eigen::Vector2d turn = Eigen::Vector2d::Zero(), turn_rate = turn, turn_phase = turn;       // [rad], [rad/s], [rad]

  /// Target pose and velocity of the flange at `t`.
  PoseTarget at(double t, const PoseTarget& home) const;

 private:
  PoseTarget pose(double t, const PoseTarget& home) const;
};

/// The plan of one recording.
struct Plan {
  char scenario = 'A';
  double duration = 3;  // [s]
  JointVector<double, 7> q0;
  PoseImpedanceConfig gains;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  // of the pose to hold, from the pose at q0 [m]
  std::vector<PayloadEvent> events;
  std::vector<PushEvent> pushes;
  std::optional<Motion> motion;
  bool feed_forward = false;  // the controller compensates the true payload from soon after the attachment on
  double singular = 0.1;      // least singular value of J that is allowed
};

/// All scenarios: "ABDEFHM".
extern const std::string kScenarios;

/// Draws a recording of a scenario.
Plan draw_plan(char scenario, std::mt19937_64& random);

}  // namespace rme::examples
