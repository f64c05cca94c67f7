#pragma once
/// One run of an experiment: an arm under CPIC whose host runs the estimator, tick after tick.
#include <cpic_host/host.hpp>
#include <rme/event_estimator.hpp>
#include <synthetic_arm/panda.hpp>

#include "paper/experiment/setup.hpp"

namespace rme::examples {

class Trial {
 public:
  using Vector = JointVector<double, 7>;
  using Estimator = rme::EventEstimator<double, 7>;

  /// @param compensate  whether the estimate reaches the controller
  Trial(const SyntheticArmConfig<7>& arm_config, const HostConfig& host_config, const Vector& start, bool compensate,
        const Estimator::Config& config = {})
      : arm(panda(), arm_config, start),
        host(panda(), host_config),
        estimator(kPeriod, config),
        config_(host_config),
        compensate_(compensate) {}

  /// Estimator, then controller, at the present time.
  /// @return the torque to command [N m]
  /// @throws std::runtime_error if the estimator or the controller refuses a sample: here that is a bug
  const Vector& command();
  /// The same, then the arm's next millisecond. What the members say afterwards belongs to the new time but for the
  /// host's, which is of the tick before.
  void tick() { arm.step(command()); }

  Eigen::Vector3d position_error() const { return arm.kinematics().position - config_.target; }  // world axes [m]
  /// [rad]
  double orientation_error() const {
    return config_.orientation.angularDistance(Eigen::Quaterniond(arm.kinematics().rotation));
  }

  SyntheticArm<7> arm;
  Host host;
  Estimator estimator;

 private:
  HostConfig config_;
  bool compensate_;
};

}  // namespace rme::examples
