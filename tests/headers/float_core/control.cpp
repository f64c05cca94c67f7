#include <cmath>
#include <rme/rme.hpp>

#include "headers/float_core/float_core.hpp"
#include "support/random_events.hpp"

namespace float_core {
namespace {

bool compensation_carries_a_kilogram_and_the_ramp_lets_it_in() {
  Random random(7);
  const auto pose = rme::testing::random_pose(random);
  const auto tau =
      rme::compensation_torque<float>({1, {0.1F, 0, 0}}, pose.jacobian.cast<float>(), pose.rotation.cast<float>());
  const Eigen::Vector3d weight(0, 0, -9.81);
  const rme::Vector6<double> w =
      (rme::Vector6<double>() << weight, (0.1 * pose.rotation.col(0)).cross(weight)).finished();
  if (!near(tau, -pose.jacobian.transpose() * w, 1e-5 * w.norm())) return false;
  rme::CompensationRamp<float, 7> ramp(kPeriod);
  for (int k = 0; k < 40; ++k) {
    const Vector7 before = ramp.torque();
    if (ramp.update(tau) != Status::Ok || (ramp.torque() - before).cwiseAbs().maxCoeff() > 0.5001F) return false;
  }
  return ramp.torque() == tau;
}

bool passive_force_spends_what_it_books() {
  Random random(8);
  rme::PassiveController<float> passive;
  const rme::LinearAttractor<float> attractor({Vector3(0.4F, 0, 0.5F), 1, 0.5F});
  const rme::LimitCycle<float> cycle({});
  for (int k = 0; k < 200; ++k) {
    const Vector3 x = gaussian<Vector3>(random, 0.3F);
    const auto twist = rme::Twist<float>::from_vector(gaussian<Vector6>(random, 0.3F));
    const auto flow = k % 2 == 0 ? attractor(x) : cycle(x);
    if (passive.update(flow, {}, twist) != Status::Ok) return false;
    // F . xdot = lambda_1 (-grad V . xdot) + injected - dissipated
    const double power = passive.wrench().vector().dot(twist.vector());
    const double books =
        60.0 * flow.conservative.dot(twist.linear) + passive.injected_power() - passive.dissipated_power();
    if (!near(power, books, 1e-4 * (1 + std::abs(power) + passive.dissipated_power()))) return false;
  }
  return true;
}

bool flows_keep_their_speed_and_their_circle() {
  const rme::LinearAttractor<float> attractor({Vector3::Zero(), 1, 0.5F});
  if (!(attractor(Vector3(100, 0, 0)).velocity.norm() <= 0.5F)) return false;
  const rme::LimitCycle<float> cycle({});  // radius 0.1 m in the y-z plane, 1 rad/s
  const auto on = cycle(Vector3(0, 0.1F, 0));
  return near(on.velocity, Vector3(0, 0, 0.1F), 1e-7) && near(on.potential, 0, 1e-7);
}

bool orientation_turns_with_the_sine_of_the_angle() {
  const rme::OrientationAttractor<float> turning({});
  const rme::Matrix3<float> R = Eigen::AngleAxisf(0.5F, Vector3::UnitZ()).toRotationMatrix();
  return near(turning(R).velocity, Vector3(0, 0, -2 * std::sin(0.5F)), 1e-6);
}

bool null_space_makes_no_wrench() {
  Random random(9);
  rme::NullSpace<float, 7> null_space;
  for (int k = 0; k < 100; ++k) {
    const Jacobian7 J = gaussian<Jacobian7>(random);
    if (null_space.update(J) != Status::Ok) return false;
    const rme::JointMatrix<float, 7>& N = null_space.projector();
    if (!((J * N).norm() <= 1e-5F * J.norm() + 0.5F * null_space.damping())) return false;
    if (null_space.damping() == 0 && !near(N * N, N, 1e-5)) return false;
  }
  return true;
}

/// J = M = 1: the accelerations that are asked for are the torques, and the nearest ones in a box are those cut off.
bool cpic_cuts_off_what_a_box_does_not_allow() {
  Random random(10);
  rme::CpicConfig<float, 6> config;
  config.torque_limit.setConstant(20);
  rme::Cpic<float, 6> cpic(config);
  rme::CpicInput<float, 6> input;
  input.jacobian.setIdentity();
  input.mass_matrix.setIdentity();
  input.bias.setZero();
  for (int k = 0; k < 200; ++k) {
    const Vector6 wrench = gaussian<Vector6>(random, 15);
    input.wrench = rme::Wrench<float>::from_vector(wrench);
    rme::Cpic<float, 6>::Rows rows;
    for (int j = 0; j < 3; ++j)
      if (rows.add_axis(j, -10, 10) != Status::Ok) return false;
    if (cpic.update(input, rows) != Status::Ok) return false;
    Vector6 expected = wrench.cwiseMax(-20).cwiseMin(20);
    expected.head<3>() = expected.head<3>().cwiseMax(-10).cwiseMin(10);
    if (!near(cpic.torque(), expected, 1e-4)) return false;
  }
  return true;
}

/// x + y >= 1 and -x + y >= 2 are 1e-6 apart in the metric of P, which a product of them would lose in float.
bool solver_tells_rows_apart_that_the_metric_brings_together() {
  using Vector2 = Eigen::Vector2f;
  rme::ActiveSetSolver<float, 2, 2> solver;
  rme::ActiveSetSolver<float, 2, 2>::Rows rows;
  if (rows.add({1, 1}, 1) != Status::Ok || rows.add({-1, 1}, 2) != Status::Ok) return false;
  const Eigen::Matrix2f P = Vector2(500, 5e-4F).asDiagonal();
  if (solver.solve(P, Vector2::Zero(), rows, Vector2::Constant(-100), Vector2::Constant(100)) != Status::Ok)
    return false;
  return (solver.solution() - Vector2(-0.5F, 1.5F)).norm() < 1e-5F;
}

bool barriers_ask_for_what_their_poles_say() {
  rme::PointMotion<float, 7> point;
  point.position = Vector3(0, 0, 0.5F);
  point.velocity = Vector3(0, 0, -0.2F);
  point.jacobian.setZero();
  point.jacobian(2, 0) = 1;
  point.velocity_product.setZero();
  Vector7 dq = Vector7::Zero();
  dq[0] = -0.2F;
  rme::ConstraintRows<float, 7, 28> rows;
  const auto wall = rme::half_space_barrier<float, 7>(point, Vector3::UnitZ(), 0.4F);
  if (rme::add_barrier(wall, dq, {8.0F, 40.0F}, rows) != Status::Ok) return false;
  // -k_1 h - k_2 h' = -320 * 0.1 + 48 * 0.2
  if (!near(rows[0].lower, -22.4, 1e-4) || rows[0].a != Vector7::Unit(0)) return false;
  const rme::JointLimits<float, 7> limits({Vector7::Constant(-1), Vector7::Constant(1)});
  if (limits.append(Vector7::Zero(), Vector7::Zero(), rows) != Status::Ok) return false;
  return rows.size() == 8 && near(rows[1].lower, -320, 1e-3) && near(rows[7].upper, 320, 1e-3);
}

bool tank_and_monitor_keep_their_books() {
  rme::EnergyTank<float, 7> tank(kPeriod);
  Vector7 q = Vector7::Zero();
  rme::PassivityMonitor<float> monitor(kPeriod);
  float out = 0;
  for (int k = 0; k < 20000; ++k) {
    if (tank.update(q, Vector7::Constant(10)) != Status::Ok) return false;
    q[2] += 0x1p-10F;  // exact
    out += tank.torque()[2] * 0x1p-10F;
  }
  if (!(out <= 12.01F && tank.energy() >= 0)) return false;
  for (int k = 0; k <= 1000; ++k)  // a storage that takes all of a constant power
    if (monitor.update(2 * kPeriod * float(k), 2) != Status::Ok) return false;
  return near(monitor.residual(), 0, 1e-3) && monitor.update(kNan, 0) == Status::NonFiniteInput;
}

}  // namespace

const std::vector<Case> kControl = {
    {"compensation_torque, CompensationRamp: a kilogram let in",
     compensation_carries_a_kilogram_and_the_ramp_lets_it_in},
    {"PassiveController: spends what it books", passive_force_spends_what_it_books},
    {"LinearAttractor, LimitCycle: speed and circle", flows_keep_their_speed_and_their_circle},
    {"OrientationAttractor: the sine of the angle", orientation_turns_with_the_sine_of_the_angle},
    {"NullSpace: makes no wrench", null_space_makes_no_wrench},
    {"Cpic: cuts off what a box does not allow", cpic_cuts_off_what_a_box_does_not_allow},
    {"ActiveSetSolver: rows that the metric brings together", solver_tells_rows_apart_that_the_metric_brings_together},
    {"add_barrier, JointLimits: what their poles say", barriers_ask_for_what_their_poles_say},
    {"EnergyTank, PassivityMonitor: their books", tank_and_monitor_keep_their_books},
};

}  // namespace float_core
