#pragma once
/// For controllers with Pinocchio (2.6 or newer): the estimator's input from joint positions, velocities and torques,
/// with Pinocchio's model of the arm. Needs Pinocchio; rme.hpp does not include it.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <pinocchio/algorithm/compute-all-terms.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/model.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/estimator_config.hpp>
#include <rme/sensing/momentum_observer.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/tracking/inertial_parameters.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace rme {

namespace detail {

/// "a, b, c", for messages.
inline std::string listed(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

/// Index of the joint that moves a frame: parentJoint in Pinocchio 3, parent in Pinocchio 2.
template <typename Frame>
auto joint_of(const Frame& frame, int /*preferred*/) -> decltype(frame.parentJoint) {
  return frame.parentJoint;
}
template <typename Frame>
pinocchio::JointIndex joint_of(const Frame& frame, long /*otherwise*/) {
  return frame.parent;
}
/// Index of a frame that the model has. Some URDFs give a link and a joint the same name: then it is the link's.
inline pinocchio::FrameIndex frame_of(const pinocchio::Model& model, const std::string& name) {
  return model.existFrame(name, pinocchio::BODY) ? model.getFrameId(name, pinocchio::BODY) : model.getFrameId(name);
}

}  // namespace detail

/// The arm alone: all other joints of a robot's model, such as a gripper's fingers, are locked at zero. The masses that
/// they carry stay in the model.
/// @param robot   the whole model
/// @param joints  names of the arm's joints, from the base
/// @throws std::invalid_argument naming a joint that the model lacks, or the model's order
inline pinocchio::Model pinocchio_arm(const pinocchio::Model& robot, const std::vector<std::string>& joints) {
  const std::vector<std::string> known(robot.names.begin() + 1, robot.names.end());  // 0 is the universe
  for (const std::string& joint : joints)
    if (std::find(known.begin(), known.end(), joint) == known.end())
      throw std::invalid_argument("the model has no joint " + joint + "; it has " + detail::listed(known));
  std::vector<pinocchio::JointIndex> others;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (std::find(joints.begin(), joints.end(), known[i]) == joints.end()) others.push_back(i + 1);
  pinocchio::Model arm = pinocchio::buildReducedModel(robot, others, pinocchio::neutral(robot));
  const std::vector<std::string> left(arm.names.begin() + 1, arm.names.end());
  if (left != joints)
    throw std::invalid_argument("joints: expected, in the model's order, " + detail::listed(left) + "; got " +
                                detail::listed(joints));
  return arm;
}

/// Makes an estimator's sample from joint positions, velocities and torques. J and R are in the axes of the model's
/// root, "world" for rme, which must not move. They may be tilted in any way: gravity is then a vector in these axes,
/// EstimatorConfig::gravity. No call but the constructor and carry() allocates or throws.
template <int Dofs>
class PinocchioSensing {
 public:
  using Vector = JointVector<double, Dofs>;  ///< one number per joint

  /// @param arm            Dofs joints of one velocity each; a continuous joint may have two positions, its cosine and
  ///                       sine. Some mass moves with each joint
  /// @param end_effector   name of a frame that a joint moves; of a link and a joint with the same name, the link's
  /// @param period         nominal, of the control loop [s]
  /// @param config         the estimator's: its bandwidth, not 0, is the observer's gain; its sign is that of the arm's
  ///                       torque; its gravity is the model's
  /// @param gains          torque per ampere of each joint, where the arm reports motor current [N m/A]
  /// @param rotors         inertia of each joint's rotor, gear included, where the torque accelerates the rotors as well
  ///                       [kg m^2]; in addition to the model's armature, which Pinocchio counts from version 3 on
  /// @param load_friction  share of the gravity torque on each joint that friction takes while the joint moves. No URDF
  ///                       has this or `rotors`; check_arm writes both into its settings, under "model"
  /// @throws std::invalid_argument saying what was expected and what came
  PinocchioSensing(const pinocchio::Model& arm, const std::string& end_effector, double period,
                   const EstimatorConfig<double, Dofs>& config = {}, const Vector& gains = Vector::Ones(),
                   const Vector& rotors = Vector::Zero(), const Vector& load_friction = Vector::Zero())
      : model_(checked(arm, end_effector)),
        data_(model_),
        end_effector_(detail::frame_of(model_, end_effector)),
        q_(pinocchio::neutral(model_)),
        period_(period),
        sign_(static_cast<double>(config.torque_sign)),
        gains_(gains),
        rotors_(rotors),
        load_friction_(load_friction),
        observer_(kFilterPeriod, {Vector::Constant(config.observer_bandwidth)}) {
    detail::require_positive(period, "PinocchioSensing::period", "> 0 s");
    model_.gravity.linear(config.gravity);
  }

  /// As after construction: for a break in the samples.
  void reset() noexcept { observer_.reset(); }

  /// Advances by one tick.
  /// @param q            joint positions [rad], one for each joint
  /// @param dq           joint velocities [rad/s]
  /// @param tau          joint torque over the period that ends now, gravity and compensation included [N m]; or current
  ///                     [A]
  /// @param period       measured [s], or 0 for the nominal one; lost ticks count as time that passed
  /// @param[out] sample  as it was unless the status is Ok
  /// @return Ok; NonFiniteInput: the observer is then as it was
  Status update(const Vector& q, const Vector& dq, const Vector& tau, double period,
                Proprioception<double, Dofs>& sample) {
    if (!plausible(q) || !plausible(dq)) return Status::NonFiniteInput;
    set_positions(q);
    pinocchio::computeAllTerms(model_, data_, q_, dq);
    pinocchio::computeCoriolisMatrix(model_, data_, q_, dq);
    mass_matrix_ = data_.M.template selfadjointView<Eigen::Upper>();  // Pinocchio fills the upper triangle alone
    mass_matrix_.diagonal() += rotors_;
    coriolis_transpose_.noalias() = data_.C.transpose() * dq;
    const Vector friction =
        load_friction_.cwiseProduct(data_.g.cwiseAbs()).cwiseProduct((dq / kSlow).array().tanh().matrix());
    const Vector torque = sign_ * gains_.cwiseProduct(tau) - friction;
    const Status status =
        observer_.update(torque, dq, mass_matrix_, coriolis_transpose_, data_.g, period > 0 ? period : period_);
    if (status != Status::Ok) return status;
    sample.tau_ext = sign_ * observer_.tau_ext();  // the estimator takes the same sign off again
    describe(dq, period, sample);
    return Status::Ok;
  }
  /// The same for a robot that reports its external torque itself, such as a KUKA iiwa: no observer runs, and
  /// config.observer_bandwidth is that of the robot's filter.
  /// @param q            joint positions [rad], one for each joint
  /// @param dq           joint velocities [rad/s]
  /// @param tau_ext      external joint torque, as the robot reports it [N m]
  /// @param period       measured [s], or 0 for the nominal one
  /// @param[out] sample  as it was unless the status is Ok
  /// @return Ok or NonFiniteInput
  Status update_external(const Vector& q, const Vector& dq, const Vector& tau_ext, double period,
                         Proprioception<double, Dofs>& sample) {
    if (!plausible(q) || !plausible(dq) || !plausible(tau_ext)) return Status::NonFiniteInput;
    set_positions(q);
    pinocchio::computeAllTerms(model_, data_, q_, dq);
    sample.tau_ext = tau_ext;
    describe(dq, period, sample);
    return Status::Ok;
  }
  /// Gravity torque at the last update(), for a controller that has no model of its own [N m].
  Vector gravity() const { return gravity_; }

  /// Gravity torque in another pose, or before update() [N m]: for robots whose reported torque lacks it (UR).
  /// @param q  joint positions [rad], finite
  Vector gravity(const Vector& q) {
    set_positions(q);
    return pinocchio::computeGeneralizedGravity(model_, data_, q_);
  }

  /// Adds a body to the model, in addition to those that it has, and begins anew: the model then carries the payload.
  /// Outside the loop: it may allocate.
  /// @param body  end-effector axes, about the end-effector origin
  void carry(const InertialParameters<double>& body) {
    const auto& frame = model_.frames[end_effector_];
    model_.appendBodyToJoint(detail::joint_of(frame, 0),
                             pinocchio::Inertia(body.mass, body.payload().com, body.inertia_about_com()),
                             frame.placement);
    reset();
  }

 private:
  /// The part of a sample that does not depend on the torque; after computeAllTerms().
  void describe(const Vector& dq, double period, Proprioception<double, Dofs>& sample) {
    sample.jacobian.setZero();
    pinocchio::getFrameJacobian(model_, data_, end_effector_, pinocchio::LOCAL_WORLD_ALIGNED, sample.jacobian);
    sample.rotation = pinocchio::updateFramePlacement(model_, data_, end_effector_).rotation();
    sample.dq = dq;
    sample.period = period;
    // Gravity pulls at the common centre of mass c: g(q) = -m (dc/dq)^T gravity.
    sample.gravity_torque = -data_.mass[0] * data_.Jcom.transpose();
    gravity_ = data_.g;
  }
  void set_positions(const Vector& q) {
    for (int i = 0; i < Dofs; ++i) {
      const auto joint = static_cast<std::size_t>(i) + 1;
      const int at = model_.idx_qs[joint];
      q_[at] = model_.nqs[joint] == 2 ? std::cos(q[i]) : q[i];
      if (model_.nqs[joint] == 2) q_[at + 1] = std::sin(q[i]);
    }
  }
  static const pinocchio::Model& checked(const pinocchio::Model& arm, const std::string& end_effector) {
    const std::vector<std::string> joints(arm.names.begin() + 1, arm.names.end());
    const bool one_each = std::all_of(arm.nvs.begin() + 1, arm.nvs.end(), [](int nv) { return nv == 1; });
    if (arm.nv != Dofs || !one_each)
      throw std::invalid_argument("the model: expected " + std::to_string(Dofs) +
                                  " joints of one velocity each on a fixed base, got nv = " + std::to_string(arm.nv) +
                                  ": " + detail::listed(joints) + "; pinocchio_arm() locks what is too much");
    std::vector<double> moved;  // mass that moves with each joint: its link's, and those of the links after it
    for (const pinocchio::Inertia& link : arm.inertias) moved.push_back(link.mass());
    for (std::size_t i = joints.size(); i > 0; --i) moved[arm.parents[i]] += moved[i];
    std::vector<std::string> massless;
    for (std::size_t i = 0; i < joints.size(); ++i)
      if (!(moved[i + 1] > 0)) massless.push_back(joints[i]);
    if (!massless.empty())
      throw std::invalid_argument("the model has no inertias: no mass moves with " + detail::listed(massless) +
                                  "; expected <inertial> elements in the URDF");
    if (!arm.existFrame(end_effector)) {
      std::vector<std::string> frames;
      for (const pinocchio::Frame& frame : arm.frames) frames.push_back(frame.name);
      throw std::invalid_argument("the model has no frame " + end_effector + "; it has " + detail::listed(frames));
    }
    if (detail::joint_of(arm.frames[detail::frame_of(arm, end_effector)], 0) == 0)
      throw std::invalid_argument("the frame " + end_effector +
                                  ": expected one that a joint of the arm moves; they are " + detail::listed(joints));
    return arm;
  }

  // The estimator expects a filter that advances each millisecond, however often the host looks [s].
  static constexpr double kFilterPeriod = 0.001;
  static constexpr double kSlow = 0.02;  // below it a joint is not sure to move [rad/s]

  pinocchio::Model model_;
  pinocchio::Data data_;
  pinocchio::FrameIndex end_effector_;
  Eigen::VectorXd q_;  // Pinocchio's: of a continuous joint cosine and sine
  double period_, sign_;
  Vector gains_, rotors_, load_friction_;
  MomentumObserver<double, Dofs> observer_;
  JointMatrix<double, Dofs> mass_matrix_;
  Vector coriolis_transpose_;
  Vector gravity_ = Vector::Zero();  // at the last update() [N m]
};

}  // namespace rme
