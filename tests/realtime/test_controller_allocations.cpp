#include <random>
#include <rme/control/barriers.hpp>
#include <rme/control/cpic.hpp>
#include <rme/control/energy_tank.hpp>
#include <rme/control/limit_cycle.hpp>
#include <rme/control/linear_attractor.hpp>
#include <rme/control/orientation_attractor.hpp>
#include <rme/control/passive_controller.hpp>
#include <rme/control/passivity_monitor.hpp>
#include <rme/control/posture.hpp>
#include <rme/core/compensation.hpp>
#include <rme/sensing/momentum_observer.hpp>
#include <vector>

#include "control/random_arm.hpp"
#include "realtime/allocations_of.hpp"
#include "support/catch.hpp"

#ifdef RME_COUNTS_ALLOCATIONS

namespace {

using rme::Status;
using rme::testing::allocations_of;
using Vector7 = rme::JointVector<double, 7>;

constexpr double kPeriod = 1e-3;  // [s]

TEST_CASE("Allocations: none in the controller, feasible or not", "[realtime]") {
  const unsigned seed = 304;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::vector<oracle::RandomArm<7, 28>> arms;
  arms.reserve(300);
  for (int i = 0; i < 300; ++i) arms.emplace_back(random, i % 2 == 0 ? 7 : 0, i % 12, i % 5 == 0 ? 2 : 40);

  rme::CpicConfig<double, 7> config;
  config.torque_limit = arms.front().torque_limit;
  rme::Cpic<double, 7> cpic(config);
  rme::NullSpace<double, 7> null_space;
  rme::MomentumObserver<double, 7> observer(kPeriod);
  rme::PassiveController<double> passive;
  const rme::LinearAttractor<double> attractor({Eigen::Vector3d::Ones(), 1, 0.5});
  const rme::LimitCycle<double> cycle({});
  const rme::OrientationAttractor<double> turning({});
  const rme::Posture<double, 7> posture({});
  const rme::JointLimits<double, 7> limits({Vector7::Constant(-2), Vector7::Constant(2)});
  rme::CompensationRamp<double, 7> ramp(kPeriod);
  rme::EnergyTank<double, 7> tank(kPeriod);
  rme::PassivityMonitor<double> monitor(kPeriod);
  rme::Cpic<double, 7>::Rows rows;
  int ok = 0, infeasible = 0, active = 0, refused = 0;
  const int count = allocations_of([&] {
    for (std::size_t i = 0; i < arms.size(); ++i) {
      const auto& arm = arms[i];
      rme::CpicInput<double, 7> input = arm.input;
      const Vector7 q = 0.1 * input.null_torque, dq = 0.05 * input.bias;
      const rme::PointMotion<double, 7> point = {Eigen::Vector3d(0.4, 0, 0.4), input.jacobian.topRows<3>() * dq,
                                                 input.jacobian.topRows<3>(), Eigen::Vector3d::Zero()};
      const auto twist = rme::Twist<double>::from_vector(input.jacobian * dq);
      refused += observer.update(input.null_torque, dq, input.mass_matrix, input.bias, input.bias) != Status::Ok;
      const auto flow = i % 2 == 0 ? rme::flow_at(attractor, point.position) : rme::flow_at(cycle, point.position);
      refused += passive.update(flow, turning(Eigen::Matrix3d::Identity()), twist) != Status::Ok;

      // The random arm's own rows can be kept; those of walls and limits beside them make some sets contradictory.
      rows = arm.rows;
      if (i % 3 == 0) {
        const rme::BarrierPoles<double> poles(8, 40);
        refused += limits.append(q, dq, rows) != Status::Ok;
        const auto wall = rme::half_space_barrier<double, 7>(point, Eigen::Vector3d::UnitZ(), 0.39);
        const auto ball =
            rme::sphere_barrier<double, 7>(point, Eigen::Vector3d::UnitX(), 0.5, rme::SphereSide::Outside);
        refused += rme::add_barrier(wall, dq, poles, rows) != Status::Ok;
        refused += rme::add_barrier(ball, dq, poles, rows, 100.0) != Status::Ok;
        input.wrench = passive.wrench();
      }
      input.null_torque = posture.torque(q, dq);
      refused += null_space.update(input.jacobian) != Status::Ok;
      const auto carried =
          rme::compensation_torque<double>({1.1, {0, 0, 0.1}}, input.jacobian, Eigen::Matrix3d::Identity());
      refused += ramp.update(carried) != Status::Ok;
      input.other_torque = ramp.torque() / (1 + ramp.torque().norm());
      const Status status = cpic.update(input, rows);
      ok += status == Status::Ok;
      infeasible += status == Status::Infeasible;
      active += cpic.active_count();
      refused += tank.update(q, ramp.torque()) != Status::Ok;
      refused += monitor.update(rme::kinetic_energy(input.mass_matrix, dq) + passive.potential_energy(),
                                dq.dot(observer.tau_ext())) != Status::Ok;
    }
    cpic.reset();
    observer.reset();
    monitor.reset();
  });
  CHECK(count == 0);
  CHECK(ok > 100);
  CHECK(infeasible > 10);
  CHECK(active > 300);
  CHECK(refused == 0);
  CHECK(null_space.clearance() > 0);
}

}  // namespace

#endif
