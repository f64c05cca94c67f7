#pragma once
/// The energy books of a host, which only a simulation can keep exactly.
#include <cpic_host/host.hpp>
#include <rme/control/passivity_monitor.hpp>

namespace rme::examples {

/// Stored against supplied energy, from what only a simulation knows: the payload and the push.
///
/// Stored is the kinetic energy, payload included, and lambda_1 V. Supplied is the power of the push, of the payload's
/// weight as far as it is not compensated (the wrench error of [RME, Eq. 35]), of the flow's driven part, and of every
/// torque that CPIC adds to J^T F_c: null space and constraints.
class EnergyBooks {
 public:
  explicit EnergyBooks(double period) : monitor_(period), period_(period) {}

  void update(const SyntheticArm<7>& arm, const Host& host, const Eigen::Vector3d& push) noexcept {
    const JointVector<double, 7>& dq = arm.dq();
    const Dynamics<7> actual = arm.model().dynamics(arm.q(), dq, arm.payload());
    const auto& J = arm.kinematics().jacobian;
    const JointVector<double, 7> passive = J.transpose() * host.passive().wrench().vector();
    const JointVector<double, 7> mismatch = host.compensation() - (actual.gravity - arm.dynamics().gravity);
    power_ = dq.dot(J.topRows<3>().transpose() * push + mismatch + host.cpic().torque() - passive) +
             host.passive().injected_power();
    (void)monitor_.update(
        kinetic_energy<double, 7>(actual.mass_matrix, dq) + host.passive().potential_energy() - brought_, power_);
    const double dissipated = host.passive().dissipated_power();
    if (open_) dissipated_ += period_ * (dissipated + last_dissipated_) / 2;
    last_dissipated_ = dissipated;
    open_ = true;
  }
  /// An object came or went between the last update and this one, in full motion. The kinetic energy that it brought or
  /// took along is not the arm's; and the power of the tick before is that of what was held until now.
  /// @param before  what was held until now
  void exchange(const SyntheticArm<7>& arm, const RigidBody& before) noexcept {
    const JointVector<double, 7>& dq = arm.dq();
    const Dynamics<7> then = arm.model().dynamics(arm.q(), dq, before),
                      now = arm.model().dynamics(arm.q(), dq, arm.payload());
    brought_ += kinetic_energy<double, 7>(now.mass_matrix, dq) - kinetic_energy<double, 7>(then.mass_matrix, dq) +
                period_ / 2 * dq.dot(now.gravity - then.gravity);
  }
  void reset() noexcept {
    monitor_.reset();
    open_ = false;
    dissipated_ = brought_ = 0;
  }

  double stored() const noexcept { return monitor_.storage(); }     // less what objects brought along [J]
  double power() const noexcept { return power_; }                  // supplied [W]
  double supplied() const noexcept { return monitor_.supplied(); }  // [J]
  /// Stored minus supplied [J]: never rises for a passive system.
  double residual() const noexcept { return monitor_.residual(); }
  /// Stored minus supplied plus dissipated [J]: zero in continuous time, so all of it is the error of the step.
  double imbalance() const noexcept { return monitor_.residual() + dissipated_; }

 private:
  PassivityMonitor<double> monitor_;
  double period_;
  double power_ = 0, brought_ = 0;
  double dissipated_ = 0, last_dissipated_ = 0;
  bool open_ = false;
};

}  // namespace rme::examples
