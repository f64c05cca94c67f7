#pragma once
/// Random arms, poses and payloads, and the loop of a host around them.
#include <cstdint>
#include <optional>
#include <random>
#include <rme/core/compensation.hpp>
#include <rme/estimator.hpp>
#include <stdexcept>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

namespace rme::examples {

using Torque = JointVector<double, 7>;
constexpr double kPeriod = 1e-3;  // of the control loop [s]

/// Whether the sensed torque contains joint friction: never, always, or in half of the arms at random.
enum class Kind { LinkSide, JointFriction, Mixed };

/// All that is drawn at random for one run.
struct Draw {
  bool friction_shows = false;
  SyntheticArmConfig<7> arm;
  Torque start, target;  ///< joint angles at which the arm starts, and those that it has to hold [rad]
  RigidBody payload;
  int skipped = 0;  ///< draws before this one that the arm could not have held
};

/// Draws the runs of a seed; run k does not depend on the runs drawn before.
class RandomHost {
 public:
  RandomHost(std::uint64_t seed, std::uint64_t run)
      : random_([seed, run] {
          std::seed_seq sequence{seed, run};
          return std::mt19937_64(sequence);
        }()) {}

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  double normal(double mean, double deviation) { return mean + deviation * standard_(random_); }
  Eigen::Vector3d direction() {
    const double z = normal(0, 1), y = normal(0, 1), x = normal(0, 1);
    return Eigen::Vector3d(x, y, z).normalized();
  }

  /// @param prior         distribution of the payload, without masses below 50 g and above 3 kg; none: uniform, 0.2 to
  ///                      2 kg, centre of mass within 8 cm across the flange's axis and 0 to 20 cm along it
  /// @param with_payload  whether the arm must be able to hold the payload
  Draw draw(Kind kind, const std::optional<PayloadGaussian<double>>& prior, bool with_payload = true);

 private:
  SyntheticArmConfig<7> faults(bool friction_shows);
  void pose(Torque& q);
  RigidBody payload(const std::optional<PayloadGaussian<double>>& prior);

  std::mt19937_64 random_;
  std::normal_distribution<double> standard_;
};

/// The loop of a host: arm, impedance controller, compensation by the tracker.
class Host {
 public:
  explicit Host(const Draw& draw, const EstimatorConfig<double, 7>& config = {})
      : arm_(panda(), draw.arm, draw.start), controller_(panda(), draw.target), estimator_(kPeriod, config) {}

  SyntheticArm<7>& arm() { return arm_; }
  const EstimatorState<double>& state() const { return estimator_.state(); }
  /// What the estimator got in the last tick.
  const Proprioception<double, 7>& sample() const { return sample_; }
  /// Moves the target.
  void hold(const Torque& q) { controller_ = PoseImpedance<7>(panda(), q); }

  /// One control period.
  void tick() {
    const auto& [position, rotation, jacobian] = arm_.kinematics();
    sample_ = {arm_.tau_ext(), jacobian, rotation, arm_.dq()};
    const Status status = estimator_.update(sample_);
    if (status != Status::Ok) throw std::runtime_error(to_string(status));
    if (ramp_.update(estimator_.compensation(jacobian, rotation)) != Status::Ok)
      throw std::runtime_error("the compensation is not finite");
    arm_.step(controller_.torque(arm_.q(), arm_.dq(), arm_.kinematics(), arm_.dynamics()) + ramp_.torque());
  }

 private:
  SyntheticArm<7> arm_;
  PoseImpedance<7> controller_;
  CompensationRamp<double, 7> ramp_{kPeriod};
  Estimator<double, 7> estimator_;
  Proprioception<double, 7> sample_;
};

}  // namespace rme::examples
