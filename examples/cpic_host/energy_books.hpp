#pragma once
/// The energy balance ("books") of a host. Only a simulation can compute it exactly.
#include <cpic_host/host.hpp>
#include <rme/control/passivity_monitor.hpp>

namespace rme::examples {

/// Stored against supplied energy, with what only a simulation knows: the payload and the push.
///
/// Stored is the kinetic energy, payload included, and lambda_1 V. Supplied is the work of the push, of the payload's
/// weight less the compensation (the wrench error of [RME, Eq. 35]), of the part of the flow that is no gradient, and
/// of every torque that CPIC adds to J^T F_c: null space and constraints. The work of torques and pushes is exact,
/// since they are held for a tick: a torque does the work torque^T (change of q) (docs/theory_control.md (C17)). Weight
/// has a potential.
///
/// The passive torque J^T F_c is held too. Its work differs from -lambda_1 dV + injected - dissipated of the moving
/// arm. held() is the sum of these differences. It is in proportion to the period, and is no error of the balance: the
/// torque does put this energy into the arm.
class EnergyBooks {
 public:
  explicit EnergyBooks(double period) : monitor_(period), period_(period) {}

  /// Adds a tick: `host` has just been updated with `arm`, and its torque is held until the next tick. The payload
  /// changes at ticks only.
  /// @param push  force on the end-effector origin [N], world axes, held until the next tick as well
  void update(const SyntheticArm<7>& arm, const Host& host, const Eigen::Vector3d& push) noexcept {
    const JointVector<double, 7>&q = arm.q(), &dq = arm.dq();
    const RigidBody payload = arm.payload();
    const double kinetic = kinetic_energy<double, 7>(arm.model().dynamics(q, dq, payload).mass_matrix, dq);
    const PassiveController<double>& passive = host.passive();
    work_ = 0;
    if (open_) {
      const JointVector<double, 7> moved = q - last_.q;
      const Eigen::Vector3d way = arm.kinematics().position - last_.position;
      const double by_passive = moved.dot(last_.passive_torque);
      const double injected = period_ * (last_.injected + passive.injected_power()) / 2;
      const double dissipated = period_ * (last_.dissipated + passive.dissipated_power()) / 2;
      work_ = last_.push.dot(way) + moved.dot(last_.torque) - by_passive -
              (potential(arm, last_.payload) - last_.weight) + injected;
      held_ += by_passive + passive.potential_energy() - last_.potential - injected + dissipated;
      dissipated_ += dissipated;
    }
    (void)monitor_.update_with_work(kinetic + passive.potential_energy() - brought_, work_);
    last_ = {q,
             arm.kinematics().position,
             host.torque(),
             arm.kinematics().jacobian.transpose() * passive.wrench().vector(),
             push,
             payload,
             potential(arm, payload),
             passive.potential_energy(),
             passive.injected_power(),
             passive.dissipated_power()};
    open_ = true;
  }
  /// An object came or went between the last update and the next one, while the arm moved. The kinetic energy that it
  /// brought or took away is not the arm's, and is left out.
  /// @param before  what the hand held until now
  void exchange(const SyntheticArm<7>& arm, const RigidBody& before) noexcept {
    const JointVector<double, 7>& dq = arm.dq();
    brought_ += kinetic_energy<double, 7>(arm.model().dynamics(arm.q(), dq, arm.payload()).mass_matrix, dq) -
                kinetic_energy<double, 7>(arm.model().dynamics(arm.q(), dq, before).mass_matrix, dq);
  }
  void reset() noexcept {
    monitor_.reset();
    open_ = false;
    dissipated_ = held_ = brought_ = 0;
  }

  double stored() const noexcept { return monitor_.storage(); }     // without what objects brought [J]
  double work() const noexcept { return work_; }                    // supplied between the last two updates [J]
  double supplied() const noexcept { return monitor_.supplied(); }  // [J]
  double dissipated() const noexcept { return dissipated_; }        // by the passive controller's damping [J]
  double held() const noexcept { return held_; }                    // put in because J^T F_c is held for a tick [J]
  /// Stored minus supplied, since the start [J]: never rises for a passive system.
  double residual() const noexcept { return monitor_.residual(); }
  /// What is missing in the balance: stored minus supplied, plus dissipated, minus held [J]. With friction, this is
  /// mostly the work of friction; without, it is the error of the simulation.
  double imbalance() const noexcept { return monitor_.residual() + dissipated_ - held_; }

 private:
  /// The quantities of one tick that the next update needs.
  struct Tick {
    JointVector<double, 7> q;
    Eigen::Vector3d position;
    JointVector<double, 7> torque, passive_torque;
    Eigen::Vector3d push;
    RigidBody payload;
    double weight, potential, injected, dissipated;  // potential energy of arm and payload, lambda_1 V [J], powers [W]
  };
  /// Potential energy of the weight of arm and payload [J].
  static double potential(const SyntheticArm<7>& arm, const RigidBody& payload) noexcept {
    return arm.model().energy(arm.q(), JointVector<double, 7>::Zero(), payload);
  }

  PassivityMonitor<double> monitor_;
  double period_;
  Tick last_;
  double work_ = 0, brought_ = 0, dissipated_ = 0, held_ = 0;
  bool open_ = false;
};

}  // namespace rme::examples
