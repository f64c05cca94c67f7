#pragma once
/// Random arms, poses and payloads, and the loop of a host around them.
#include <cstdint>
#include <random>
#include <rme/control/compensation.hpp>
#include <rme/event_estimator.hpp>
#include <stdexcept>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

namespace rme::examples {

using Torque = JointVector<double, 7>;
constexpr double kPeriod = 1e-3;  // of the control loop [s]

/// Where random payloads come from.
enum class Truth {
  Uniform,  ///< 0.2 to 2 kg, centre of mass within 8 cm across the flange's axis and 0 to 20 cm along it
  Prior,    ///< the prior of the estimator, masses below 50 g left out
};

/// What the arm's torque sensors see of the joint friction.
enum class Sensing { LinkSide, JointFriction, Mixed };

/// Everything that chance decides about one run.
struct Draw {
  bool friction_shows = false;
  SyntheticArmConfig<7> arm;
  Torque start, target;  ///< joint angles at which the arm starts, and those that it is to hold [rad]
  RigidBody payload;
  int skipped = 0;  ///< draws before this one that the arm could not have held
};

/// Draws runs from a seed; run k is the same whatever was drawn before.
class RandomHost {
 public:
  RandomHost(std::uint64_t seed, std::uint64_t run)
      : random_([seed, run] {
          std::seed_seq sequence{seed, run};
          return std::mt19937_64(sequence);
        }()) {}

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  double normal(double mean, double deviation) { return mean + deviation * standard_(random_); }
  Eigen::Vector3d direction() { return Eigen::Vector3d(normal(0, 1), normal(0, 1), normal(0, 1)).normalized(); }

  /// @param with_payload  whether the arm must be able to hold the payload
  Draw draw(Sensing sensing, Truth truth, bool with_payload = true);

 private:
  SyntheticArmConfig<7> faults(bool friction_shows);
  void pose(Torque& q);
  RigidBody payload(Truth truth);

  std::mt19937_64 random_;
  std::normal_distribution<double> standard_;
};

/// An estimate, or the refusal of one, at the tick it was made.
struct Answer {
  double t = 0;            ///< [s]
  double detected_at = 0;  ///< [s]
  bool rejected = false;
  bool empty = false;
  PayloadGaussian<double> posterior;
};

/// The loop of a host: arm, impedance controller, compensation by the first estimator. The others listen without a say.
/// @tparam PriorSource  of the estimators
template <typename PriorSource = FixedPrior<double>>
class Host {
 public:
  Host(const Draw& draw, const std::vector<EventEstimatorConfig<double, 7>>& configs)
      : Host(draw, configs, std::vector<PriorSource>(configs.size())) {}
  /// @param priors  one for each estimator
  Host(const Draw& draw, const std::vector<EventEstimatorConfig<double, 7>>& configs,
       const std::vector<PriorSource>& priors)
      : arm_(panda(), draw.arm, draw.start),
        controller_(panda(), draw.target),
        ramp_(kPeriod),
        answers_(configs.size()) {
    for (std::size_t k = 0; k < configs.size(); ++k) estimators_.emplace_back(kPeriod, configs[k], priors[k]);
  }

  SyntheticArm<7>& arm() { return arm_; }
  /// Moves the target.
  void hold(const Torque& q) { controller_ = PoseImpedance<7>(panda(), q); }
  /// What the k-th estimator has said so far.
  const std::vector<Answer>& answers(std::size_t k) const { return answers_[k]; }

  /// One control period.
  void tick() {
    const auto& [position, rotation, jacobian] = arm_.kinematics();
    for (std::size_t k = 0; k < estimators_.size(); ++k) {
      auto& estimator = estimators_[k];
      const Status status = estimator.update({arm_.tau_ext(), jacobian, rotation, arm_.dq()});
      if (status != Status::Ok) throw std::runtime_error(to_string(status));
      if (!estimator.estimated() && !estimator.rejected()) continue;
      // The estimator counts from its first tick, which was at time 0 of the arm.
      answers_[k].push_back({arm_.time(), estimator.detected_at() - kPeriod, estimator.rejected(),
                             estimator.estimate().empty, estimator.estimate().posterior});
    }
    if (ramp_.update(estimators_.front().compensation(jacobian, rotation)) != Status::Ok)
      throw std::runtime_error("the compensation is not finite");
    arm_.step(controller_.torque(arm_.q(), arm_.dq(), arm_.kinematics(), arm_.dynamics()) + ramp_.torque());
  }

 private:
  SyntheticArm<7> arm_;
  PoseImpedance<7> controller_;
  CompensationRamp<double, 7> ramp_;
  std::vector<EventEstimator<double, 7, PriorSource>> estimators_;
  std::vector<std::vector<Answer>> answers_;
};

}  // namespace rme::examples
