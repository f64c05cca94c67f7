#pragma once
/// The arm of a recording: the built-in Panda, or the arm of --urdf, and how its recordings are to be read.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <rme/estimator_config.hpp>
#include <rme/sensing/torque_sign.hpp>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <vector>

#include "io/arguments.hpp"
#include "urdf_arm/urdf_chain.hpp"

namespace rme::examples {

constexpr const char* kArmUsage =
    "  --urdf FILE         the arm (default: the built-in Panda, link 8 as end effector); needs --base and --tip\n"
    "  --base LINK         the link that does not move; its axes are the world axes\n"
    "  --tip LINK          the end effector\n"
    "  --rated-payload M   heaviest payload that the arm is made for [kg] (3; with --urdf from its effort limits)\n"
    "  --torque-sign S     of the log's torque: external (default) or reaction\n"
    "  --gains K1,K2,...   tau1.. are motor currents [A]; torque per ampere of each joint, gear included [N m/A]\n"
    "  --rotor-inertia I1,I2,...  inertia of each joint's rotor, gear included, which tau1.. accelerates [kg m^2] (0)\n"
    "  --gravity X,Y,Z     gravity vector in world axes [m/s^2] (0,0,-9.81)\n"
    "  --tool M,X,Y,Z      a tool that the model lacks: its mass [kg] and centre of mass in the end effector's axes "
    "[m]\n"
    "  --tau-lacks-gravity gravity was subtracted from tau1..: it is added again\n";

/// The values of the options above.
struct ArmRequest {
  std::optional<UrdfChain> chain;  ///< nothing: the built-in Panda
  std::optional<double> rated_payload;
  std::optional<TorqueSign> torque_sign;
  std::vector<double> gains;          ///< none, or one for each joint [N m/A]
  std::vector<double> rotor_inertia;  ///< none, or one for each joint [kg m^2]
  std::vector<double> load_friction;  ///< none, or one for each joint
  std::optional<Eigen::Vector3d> gravity;
  RigidBody tool;              ///< on the end effector, in its axes; of mass 0: none
  bool lacks_gravity = false;  ///< gravity was subtracted from measured torque

  int dofs() const noexcept { return chain ? chain->dofs() : 7; }
};

/// Takes the options above out of `arguments`.
/// @throws ArgumentError naming what is wrong; UrdfError
ArmRequest parse_arm(Arguments& arguments);

/// Names of the arm's joints, from the base on.
std::vector<std::string> joint_names(const ArmRequest& request);

/// An arm, and how its recordings are to be read.
template <int Dofs>
struct RecordedArm {
  ArmModel<Dofs> model;
  JointVector<double, Dofs> gains = JointVector<double, Dofs>::Ones();          ///< [N m] per unit of the log's `tau`
  JointVector<double, Dofs> rotor_inertia = JointVector<double, Dofs>::Zero();  ///< gear included [kg m^2]
  /// Increase of a moving joint's friction in `tau` per N m of the arm's own gravity torque on the joint.
  JointVector<double, Dofs> load_friction = JointVector<double, Dofs>::Zero();
  bool lacks_gravity = false;  ///< the log's `tau` is without the model's gravity torque
  bool is_panda = false;       ///< the built-in one, whose friction is known: it is subtracted from measured torque
};

/// A guess of the rated payload [kg]: 0.4 times the mass, 10 cm ahead of the tip, that the effort limits can hold in
/// half of all poses. It is 2.9 for a Panda (data sheet: 3), 10.6 for a UR10e (12.5), 5.3 for an arm of the size of a
/// UR5 (5).
/// @throws UrdfError if the URDF does not bound the torques
template <int Dofs>
double likely_rated_payload(const ArmModel<Dofs>& model) {
  if (!model.tau_max.allFinite())
    throw UrdfError(model.name +
                    ": not every joint has an effort limit, so that --rated-payload has to say what the "
                    "arm is made for");
  constexpr int kPoses = 1000;
  constexpr double kPi = 3.141592653589793;
  const std::array<double, 8> irrational = {std::sqrt(2.),  std::sqrt(3.),  std::sqrt(5.),  std::sqrt(7.),
                                            std::sqrt(11.), std::sqrt(13.), std::sqrt(17.), std::sqrt(19.)};
  std::vector<double> heaviest;
  for (int k = 1; k <= kPoses; ++k) {
    JointVector<double, Dofs> q;
    for (int j = 0; j < Dofs; ++j) {
      const double low = std::max(model.q_min[j], -kPi), high = std::min(model.q_max[j], kPi);
      q[j] = low + std::fmod(k * irrational[static_cast<std::size_t>(j)], 1.0) * (high - low);
    }
    const JointVector<double, Dofs> rest = JointVector<double, Dofs>::Zero();
    const JointVector<double, Dofs> own = model.dynamics(q, rest).gravity;
    const JointVector<double, Dofs> each =
        model.dynamics(q, rest, {1, Eigen::Vector3d(0, 0, 0.1), Eigen::Matrix3d::Zero()}).gravity - own;
    double mass = 1e4;
    for (int j = 0; j < Dofs; ++j)
      if (std::abs(each[j]) > 1e-6)
        mass = std::min(mass, (model.tau_max[j] - std::copysign(1.0, each[j]) * own[j]) / std::abs(each[j]));
    heaviest.push_back(mass);
  }
  std::nth_element(heaviest.begin(), heaviest.begin() + kPoses / 2, heaviest.end());
  const double rated = 0.4 * heaviest[kPoses / 2];
  if (!(rated > 0))
    throw UrdfError(model.name +
                    ": the effort limits cannot hold the arm itself; --rated-payload has to say what it "
                    "is made for");
  return rated;
}

/// The part of each joint's friction torque that grows with the arm's own weight, to subtract from measured torque
/// [N m].
template <int Dofs>
JointVector<double, Dofs> load_friction(const RecordedArm<Dofs>& arm, const JointVector<double, Dofs>& q,
                                        const JointVector<double, Dofs>& dq) {
  constexpr double kSlow = 0.02;  // [rad/s]: at lower speeds it is uncertain whether a joint moves
  if (arm.load_friction.isZero(0)) return JointVector<double, Dofs>::Zero();
  const JointVector<double, Dofs> rest = JointVector<double, Dofs>::Zero();
  const JointVector<double, Dofs> load = arm.model.dynamics(q, rest).gravity.cwiseAbs();
  return arm.load_friction.cwiseProduct(load).cwiseProduct((dq / kSlow).array().tanh().matrix());
}

/// The arm of the request. Writes the options for gravity, torque sign and rated payload to `config`.
/// @param rated  whether `config` has the arm's rated payload
/// @throws UrdfError as likely_rated_payload(), if the rated payload is in neither
template <int Dofs>
RecordedArm<Dofs> recorded_arm(const ArmRequest& request, bool rated, EstimatorConfig<double, Dofs>& config) {
  RecordedArm<Dofs> arm;
  if (request.chain) {
    arm.model = arm_model<Dofs>(*request.chain);
  } else if constexpr (Dofs == 7) {
    arm.model = panda();
    arm.is_panda = true;
    RigidBody& last = arm.model.links.back().body;
    if (request.tool.mass > 0) last = last + moved(request.tool, arm.model.flange, arm.model.flange_rotation);
  }
  arm.lacks_gravity = request.lacks_gravity;
  if (!request.gains.empty()) arm.gains = Eigen::Map<const JointVector<double, Dofs>>(request.gains.data());
  if (!request.rotor_inertia.empty())
    arm.rotor_inertia = Eigen::Map<const JointVector<double, Dofs>>(request.rotor_inertia.data());
  if (!request.load_friction.empty())
    arm.load_friction = Eigen::Map<const JointVector<double, Dofs>>(request.load_friction.data());
  if (request.gravity) config.gravity = *request.gravity;
  if (request.torque_sign) config.torque_sign = *request.torque_sign;
  if (request.rated_payload)
    config.rated_payload = *request.rated_payload;
  else if (request.chain && !rated)
    config.rated_payload = likely_rated_payload(arm.model);
  arm.model.gravity_vector = config.gravity;
  return arm;
}

}  // namespace rme::examples
