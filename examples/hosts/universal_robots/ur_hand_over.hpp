#pragma once
/// Hands a payload over to a UR's own payload, without a step of the torque.
#include <ur_client_library/rtde/data_package.h>
#include <ur_client_library/ur/ur_driver.h>
#include <algorithm>
#include <cmath>
#include <rme/host/payload_compensation.hpp>

namespace hosts {

/// A payload of the robot's, as setTargetPayload() takes it.
struct UrLoad {
  double mass = 0;             ///< [kg]
  urcl::vector3d_t cog{};      ///< centre of mass from the flange, flange axes [m]
  urcl::vector6d_t inertia{};  ///< about the centre of mass, flange axes: Ixx, Iyy, Izz, Ixy, Ixz, Iyz [kg m^2]

  /// The payload that the robot says it has.
  /// @return whether the package has it
  static bool read(const urcl::rtde_interface::DataPackage& data, UrLoad& load) {
    return data.getData("payload", load.mass) && data.getData("payload_cog", load.cog) &&
           data.getData("payload_inertia", load.inertia);
  }
  static UrLoad of(const rme::InertialParameters<double>& body) {
    const rme::Vector3<double> com = body.payload().com;
    const rme::Matrix3<double> I = body.inertia_about_com();
    return {body.mass, {com[0], com[1], com[2]}, {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)}};
  }
  /// About the flange's origin, flange axes.
  rme::InertialParameters<double> body() const {
    rme::Matrix3<double> I;
    I << inertia[0], inertia[3], inertia[4], inertia[3], inertia[1], inertia[5], inertia[4], inertia[5], inertia[2];
    return rme::InertialParameters<double>::of_body({mass, {cog[0], cog[1], cog[2]}}, I);
  }
};

/// A UR takes a payload over within a transition time, in which its own torque grows from nothing to that of the payload.
/// In the same time rme's torque fades out, so that the sum stays. Both are taken for linear in time.
class UrHandOver {
 public:
  using Vector = rme::JointVector<double, 6>;

  /// @param payload  with the fade_time that will be the transition time; the end effector is tool0
  UrHandOver(urcl::UrDriver& driver, rme::PayloadCompensation<double, 6>& payload)
      : driver_(driver), payload_(payload) {}

  /// Asks the robot to carry the payload, in addition to the payload that it has. It writes to a socket: not for a loop
  /// with a deadline. The loop goes on meanwhile.
  /// @param data  from RTDE, with what the robot carries now
  /// @return whether mass and centre of mass are certain enough in all poses, or why not; running() says whether it begins,
  ///         which it does not either if the robot cannot be told
  rme::HandOver<double> begin(const urcl::rtde_interface::DataPackage& data) {
    rme::HandOver<double> judged = payload_.hand_over();
    if (!judged.ready() || running() || clearing() || !UrLoad::read(data, before_)) return judged;
    const rme::InertialVector<double> sum = before_.body().vector() + judged.body.vector();
    if (!set(UrLoad::of(rme::InertialParameters<double>::from_vector(sum)), payload_.config().fade_time)) return judged;
    body_ = judged.body;
    elapsed_ = 0;
    phase_ = Phase::Transition;
    payload_.estimator().in_contact(true);  // nothing is learned meanwhile
    payload_.enable(false);
    return judged;
  }
  bool running() const { return phase_ == Phase::Transition; }
  /// Whether the robot has taken the payload over, until it carries again what it did before.
  bool done() const { return phase_ == Phase::TakenOver || clearing(); }

  /// Torque with which the robot already carries the payload, for the next UrPayload::update() [N m].
  /// @param sample  of the last tick
  Vector carried(const rme::Proprioception<double, 6>& sample) const {
    if (!running()) return Vector::Zero();
    const rme::EstimatorConfig<double, 6>& config = payload_.config().estimator;
    return std::min(1.0, elapsed_ / payload_.config().fade_time) *
           rme::compensation_torque(body_.payload(), sample.jacobian, sample.rotation, config.gravity);
  }
  /// Each tick, after UrPayload::update(). At the end of the transition it looks at what the robot took.
  /// @param data    from RTDE
  /// @param period  measured [s]
  void update(const urcl::rtde_interface::DataPackage& data, double period) {
    if (clearing()) finish_clearing(data);
    if (!running()) return;
    elapsed_ += period;
    if (elapsed_ < payload_.config().fade_time) return;
    UrLoad now;
    const bool known = UrLoad::read(data, now);
    const bool taken = known && std::abs(now.mass - before_.mass) > 0.5 * body_.mass;
    if (!taken && elapsed_ < payload_.config().fade_time + kPatience) return;  // it may still be on its way
    phase_ = taken ? Phase::TakenOver : Phase::NotAsked;
    payload_.estimator().in_contact(false);
    if (taken)
      payload_.handed_over(rme::InertialParameters<double>::from_vector(now.body().vector() - before_.body().vector()));
    payload_.enable(true);  // rme carries on if the robot took nothing
  }
  /// When the object was released, or payload.load_lost(): the robot is to carry again what it did before. At once:
  /// rme's torque against a lost load ends with the tick in which the robot reports that it has done so.
  /// @return whether the robot was told
  bool clear() {
    if (!done() || !set(before_, 0)) return false;
    phase_ = Phase::Clearing;
    return true;
  }

 private:
  /// Who carries the payload: rme; both, in the transition time; the robot; the robot, which was told to stop.
  enum class Phase { NotAsked, Transition, TakenOver, Clearing };
  bool clearing() const { return phase_ == Phase::Clearing; }
  bool set(const UrLoad& load, double transition_time) {
    return driver_.setTargetPayload(static_cast<float>(load.mass), load.cog, load.inertia, transition_time);
  }
  void finish_clearing(const urcl::rtde_interface::DataPackage& data) {
    UrLoad now;
    if (!UrLoad::read(data, now) || std::abs(now.mass - before_.mass) > 0.5 * body_.mass) return;
    phase_ = Phase::NotAsked;
    payload_.load_cleared();
  }
  static constexpr double kPatience = 0.1;  // how much later than its transition time the robot may be ready [s]

  urcl::UrDriver& driver_;
  rme::PayloadCompensation<double, 6>& payload_;
  UrLoad before_;
  rme::InertialParameters<double> body_;
  double elapsed_ = 0;
  Phase phase_ = Phase::NotAsked;
};

}  // namespace hosts
