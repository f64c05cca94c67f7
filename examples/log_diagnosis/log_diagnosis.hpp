#pragma once
/// What is wrong with a log: which single explanation fits it best, and which option mends it.
#include <Eigen/Core>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "log_format/log_format.hpp"

namespace rme::examples {

/// Motion of an arm at some instants: a row for each instant, a column for each joint.
struct Motion {
  Eigen::MatrixXd q;    ///< [rad]
  Eigen::MatrixXd dq;   ///< [rad/s]
  Eigen::MatrixXd ddq;  ///< [rad/s^2]
};

/// The torque that a motion takes by the arm's model, in the shape of the motion.
struct ModelTorque {
  Eigen::MatrixXd inertial;                    ///< M ddq + C dq [N m]
  Eigen::MatrixXd gravity;                     ///< g [N m]
  std::array<Eigen::MatrixXd, 3> per_gravity;  ///< g per component of the gravity vector [N m / (m/s^2)]
  std::array<Eigen::MatrixXd, 4> per_load;     ///< of a load per m, m r_x, m r_y, m r_z [N m / kg, N m / (kg m)]
};

/// An arm, as far as the diagnosis needs it.
struct DiagnosedArm {
  Eigen::VectorXd q_min, q_max;  ///< [rad]; infinite for a joint that turns on and on
  Eigen::VectorXd tau_max;       ///< [N m]; infinite if unknown
  double rated_payload;          ///< [kg]
  Eigen::Vector3d gravity;       ///< axes of the base link [m/s^2]
  /// @param details  whether per_gravity and per_load are needed
  std::function<ModelTorque(const Motion&, bool details)> torque;

  Eigen::Index joints() const noexcept { return q_min.size(); }
};

/// A log, a row for each sample, a column for each joint, as the options given so far make it.
struct DiagnosedLog {
  std::string name;
  std::vector<double> t;  ///< [s]
  Eigen::MatrixXd q;      ///< [rad]
  Eigen::MatrixXd dq;     ///< [rad/s]
  /// Torque [N m]: what is measured, gravity included, positive if it drives the joint forwards; or external torque.
  Eigen::MatrixXd tau;
  bool measured = true;         ///< tau is measured torque
  bool differentiated = false;  ///< dq is the derivative of q
  bool may_hold = false;        ///< the hand may hold something for a part of the log: no load is a fault
};

/// The options that made the log what it is, which the advice adds to.
struct GivenOptions {
  LogFormat format;
  LogColumns columns;
  Eigen::VectorXd gains;      ///< one for each joint
  bool external_sign = true;  ///< --torque-sign external
};

enum class Fault {
  TimeUnit,         ///< t is in ms, us or ns
  Velocity,         ///< dq is not the derivative of q: its unit, a sign, the order of its joints, or anything else
  Degrees,          ///< q, and dq if the log has it, are in degrees
  PositionSign,     ///< a joint of q turns the other way
  PositionOffset,   ///< a joint of q has another zero
  JointOrder,       ///< joints are in another order than in the model
  TorqueOrder,      ///< the torque's joints are in another order than those of q
  TorqueUnit,       ///< all joints: mN m, thousandths or hundredths of the rated torque
  TorqueSign,       ///< all joints have the opposite sign
  Gain,             ///< some joints' torque is too large, too small or of the opposite sign
  Gravity,          ///< gravity points elsewhere, or has another size
  LacksGravity,     ///< measured torque without gravity
  ContainsGravity,  ///< external torque with gravity
  Load,             ///< the hand holds something, or a tool is missing in the model
  Delay,            ///< torque later than q
  PositionLimits,   ///< q beyond the URDF's limits
  TorqueLimits,     ///< torque beyond the URDF's limits
};

/// Something that is wrong.
struct Finding {
  Fault fault;
  std::string sentence;  ///< what is wrong
  std::string option;    ///< the option that mends it; empty if no option does
};

struct Diagnosis {
  std::vector<Finding> findings;     ///< none if the log can be right
  std::vector<std::string> remarks;  ///< what the log does not show, a sentence each

  bool usable() const noexcept { return findings.empty(); }
  /// All findings as one sentence, or that nothing is wrong.
  std::string sentence() const;
  /// The options that mend all findings, as a user types them; empty if one has no option.
  std::string options() const;
};

/// Finds what explains the log best. First dq is compared with the differences of q. Then the torque is explained, joint
/// by joint, by the model's torque, offset, friction that may grow with the load, and a rotor's inertia; and the same
/// with each of the faults in turn. A fault is found if it explains the log better by far (Bayesian information criterion,
/// errors correlated over half a second), and is larger than what rough models of good logs show.
/// @throws LogError if the log has fewer than 10 rows, or lasts less than a second
Diagnosis diagnose(const DiagnosedLog& log, const DiagnosedArm& arm, const GivenOptions& given);

}  // namespace rme::examples
