#pragma once
/// Makes an estimator's samples from joint positions, velocities and torques, with Pinocchio's model of the arm.
#include <algorithm>
#include <cstddef>
#include <pinocchio/algorithm/compute-all-terms.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/model.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <rme/rme.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace hosts {

// <snippet pinocchio>
/// "a, b, c", for messages.
inline std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

/// The arm alone: all other joints of a robot's model, such as a gripper's fingers, are locked at zero. The masses that
/// they carry stay in the model.
/// @param joints  names of the arm's joints, from the base
inline pinocchio::Model arm_of(const pinocchio::Model& robot, const std::vector<std::string>& joints) {
  const std::vector<std::string> known(robot.names.begin() + 1, robot.names.end());  // 0 is the universe
  for (const std::string& joint : joints)
    if (std::find(known.begin(), known.end(), joint) == known.end())
      throw std::invalid_argument("the model has no joint " + joint + "; it has " + listed(known));
  std::vector<pinocchio::JointIndex> others;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (std::find(joints.begin(), joints.end(), known[i]) == joints.end()) others.push_back(i + 1);
  pinocchio::Model arm = pinocchio::buildReducedModel(robot, others, pinocchio::neutral(robot));
  const std::vector<std::string> left(arm.names.begin() + 1, arm.names.end());
  if (left != joints)
    throw std::invalid_argument("joints: expected, in the model's order, " + listed(left) + "; got " + listed(joints));
  return arm;
}

/// Makes an estimator's sample from joint positions, velocities and torques.
template <int Dofs>
class PinocchioSensing {
 public:
  using Vector = rme::JointVector<double, Dofs>;

  /// @param arm           Dofs joints of one position and one velocity each
  /// @param end_effector  name of a frame
  /// @param period        nominal, of the control loop [s]
  /// @param config        the estimator's: its bandwidth is the observer's gain, its sign that of the arm's torque
  /// @param gains         torque per ampere of each joint, where the arm reports motor current [N m/A]
  /// @param rotors        inertia of each joint's rotor, gear included, where the torque accelerates the rotors as well
  ///                      [kg m^2]
  /// @param load_friction share of the gravity torque on each joint that friction takes while the joint moves. No URDF
  ///                      has this or `rotors`; check_arm writes both into its settings, under "model"
  /// @throws std::invalid_argument saying what was expected and what came
  PinocchioSensing(const pinocchio::Model& arm, const std::string& end_effector, double period,
                   const rme::EstimatorConfig<double, Dofs>& config = {}, const Vector& gains = Vector::Ones(),
                   const Vector& rotors = Vector::Zero(), const Vector& load_friction = Vector::Zero())
      : model_(checked(arm, end_effector)),
        data_(model_),
        end_effector_(model_.getFrameId(end_effector)),
        period_(period),
        sign_(static_cast<double>(config.torque_sign)),
        gains_(gains),
        rotors_(rotors),
        load_friction_(load_friction),
        observer_(kFilterPeriod, {Vector::Constant(config.observer_bandwidth)}) {
    model_.gravity.linear(config.gravity);
  }

  void reset() noexcept { observer_.reset(); }

  /// @param tau     joint torque over the period that ends now, gravity and compensation included [N m]; or current [A]
  /// @param period  measured [s], or 0 for the nominal one; lost ticks count as time that passed
  /// @param sample  as it was unless the status is Ok
  rme::Status update(const Vector& q, const Vector& dq, const Vector& tau, double period,
                     rme::Proprioception<double, Dofs>& sample) {
    pinocchio::computeAllTerms(model_, data_, q, dq);
    pinocchio::computeCoriolisMatrix(model_, data_, q, dq);
    mass_matrix_ = data_.M.template selfadjointView<Eigen::Upper>();  // Pinocchio fills the upper triangle alone
    mass_matrix_.diagonal() += rotors_;
    coriolis_transpose_.noalias() = data_.C.transpose() * dq;
    const Vector friction =
        load_friction_.cwiseProduct(data_.g.cwiseAbs()).cwiseProduct((dq / kSlow).array().tanh().matrix());
    const Vector torque = sign_ * gains_.cwiseProduct(tau) - friction;
    const rme::Status status =
        observer_.update(torque, dq, mass_matrix_, coriolis_transpose_, data_.g, period > 0 ? period : period_);
    if (status != rme::Status::Ok) return status;
    sample.tau_ext = sign_ * observer_.tau_ext();  // the estimator takes the same sign off again
    sample.jacobian.setZero();
    pinocchio::getFrameJacobian(model_, data_, end_effector_, pinocchio::LOCAL_WORLD_ALIGNED, sample.jacobian);
    sample.rotation = pinocchio::updateFramePlacement(model_, data_, end_effector_).rotation();
    sample.dq = dq;
    sample.period = period;
    return rme::Status::Ok;
  }
  /// Gravity torque at the last update(), for a controller that has no model of its own [N m].
  Vector gravity() const { return data_.g; }

  /// Adds a body to the model, in addition to those that it has: see "Into the robot's own load".
  void carry(const rme::InertialParameters<double>& body) {
    const auto& frame = model_.frames[end_effector_];
    model_.appendBodyToJoint(frame.parentJoint,  // Pinocchio 2: frame.parent
                             pinocchio::Inertia(body.mass, body.payload().com, body.inertia_about_com()),
                             frame.placement);
    reset();
  }

 private:
  static const pinocchio::Model& checked(const pinocchio::Model& arm, const std::string& end_effector) {
    const std::vector<std::string> joints(arm.names.begin() + 1, arm.names.end());
    if (arm.nv != Dofs)
      throw std::invalid_argument("the model: expected " + std::to_string(Dofs) + " joints (nv), got nv = " +
                                  std::to_string(arm.nv) + ": " + listed(joints) + "; arm_of() locks what is too much");
    for (std::size_t i = 0; i < joints.size(); ++i)
      if (arm.nqs[i + 1] != 1)
        throw std::invalid_argument("the model: expected one position for each joint (nq = " + std::to_string(Dofs) +
                                    "), got nq = " + std::to_string(arm.nq) + ": " + joints[i] + " has " +
                                    std::to_string(arm.nqs[i + 1]) +
                                    "; make a continuous joint revolute, with limits, in the URDF");
    if (!arm.existFrame(end_effector)) {
      std::vector<std::string> frames;
      for (const pinocchio::Frame& frame : arm.frames) frames.push_back(frame.name);
      throw std::invalid_argument("the model has no frame " + end_effector + "; it has " + listed(frames));
    }
    return arm;
  }

  // The estimator expects a filter that advances each millisecond, however often the host looks [s].
  static constexpr double kFilterPeriod = 0.001;
  static constexpr double kSlow = 0.02;  // rad/s: below it a joint is not sure to move

  pinocchio::Model model_;
  pinocchio::Data data_;
  pinocchio::FrameIndex end_effector_;
  double period_, sign_;
  Vector gains_, rotors_, load_friction_;
  rme::MomentumObserver<double, Dofs> observer_;
  rme::JointMatrix<double, Dofs> mass_matrix_;
  Vector coriolis_transpose_;
};
// </snippet>

}  // namespace hosts
