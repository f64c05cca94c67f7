// rme_02_scenarios: does the constrained controller keep its promises when nobody picked the situations?
//
// Random start poses, targets, payloads up to 2 kg and pushes up to 60 N on a simulated Panda, five seconds each,
// seeded. Printed: how far joint limits were crossed, whether torque limits held, what became of pushes that no
// admissible torque can hold, and the energy books (stored against supplied energy).
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <synthetic_arm/panda.hpp>

#include "host.hpp"

namespace {

using namespace rme::examples;
using Vector = Host::Vector;

constexpr double kEnd = 5;  // [s]

struct Scenario {
  Vector start;
  HostConfig host;
  Push push;
  RigidBody payload;  // attached at 1 s
  bool faults = false;
  std::uint64_t seed = 0;
};

struct Outcome {
  double crossed = 0;           // deepest violation of a joint limit [rad]
  double penetrated = 0;        // deepest violation of the wall [m]
  double speed_excess = 0;      // worst excess of a joint's speed [rad/s]
  double torque_excess = 0;     // worst excess of a torque limit [N m]
  double energy_gain = 0;       // largest rise of stored minus supplied energy, over any stretch of time [J]
  double energy_gain_free = 0;  // the same over stretches without an active constraint [J]
  double largest_step = 0;      // of the compensation torque in a tick [N m]
  double clearance = 1;         // least, of the Jacobian
  int infeasible = 0;           // ticks in which the hard rows could not all be kept
  int active = 0;               // ticks with an active constraint
  int unconverged = 0;          // ticks with NotConverged or a refused input
  int iterations = 0;           // most in a tick
  bool holdable = true;         // a static torque within the limits always existed
  bool finite = true;
  bool recovered = true;  // 1.5 s after an infeasible stretch everything is within limits again
};

/// J^T of everything that hangs and pushes, against the limits.
double static_load(const ArmModel<7>& model, const Vector& q, const RigidBody& payload, const Eigen::Vector3d& push) {
  const Vector hold =
      model.dynamics(q, Vector::Zero(), payload).gravity - model.kinematics(q).jacobian.topRows<3>().transpose() * push;
  return hold.cwiseAbs().cwiseQuotient(model.tau_max).maxCoeff();
}

Scenario draw(const ArmModel<7>& model, std::uint64_t seed, bool payloads) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  const auto direction = [&] { return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized(); };
  const auto pose = [&] {
    Vector q;
    for (int j = 0; j < 7; ++j)
      q[j] = model.q_min[j] + (0.1 + 0.8 * uniform(random)) * (model.q_max[j] - model.q_min[j]);
    return q;
  };
  Scenario s;
  s.seed = seed;
  for (;;) {
    s.start = pose();
    s.push.force = 60 * uniform(random) * direction();
    s.payload = {};
    if (payloads && uniform(random) < 0.7) {
      const Eigen::Vector3d com(0.1 * uniform(random) - 0.05, 0.1 * uniform(random) - 0.05, 0.12 * uniform(random));
      s.payload = box(0.2 + 1.8 * uniform(random), com, {0.08, 0.08, 0.1});
    }
    // As drawn, the limits hold the arm with 40 % to spare.
    if (static_load(model, s.start, s.payload, s.push.force) < 0.6) break;
  }
  const auto goal = model.kinematics(s.start + 0.5 * (pose() - s.start));
  s.host.target = goal.position;
  s.host.orientation = Eigen::Quaterniond(goal.rotation);
  if (uniform(random) < 0.3) s.host.cycle_radius = 0.05 + 0.1 * uniform(random);
  if (uniform(random) < 0.5) {
    Wall wall;
    wall.normal = direction();
    wall.offset = wall.normal.dot(model.kinematics(s.start).position) - 0.05 - 0.2 * uniform(random);
    s.host.wall = wall;
  }
  s.push.start = 0.5 + 2 * uniform(random);
  s.push.rise = 0.1 + 0.2 * uniform(random);
  s.push.hold = uniform(random);
  if (payloads && uniform(random) < 0.5) {
    s.host.estimate = {s.payload.mass * (0.9 + 0.2 * uniform(random)), s.payload.com};
  }
  s.faults = payloads && uniform(random) < 0.5;
  return s;
}

Outcome run(const ArmModel<7>& model, const Scenario& s, double period, int substeps) {
  SyntheticArmConfig<7> config = s.faults ? with_typical_faults(model, s.seed) : SyntheticArmConfig<7>{};
  config.dt = period;
  config.substeps = substeps;
  HostConfig host_config = s.host;
  host_config.period = period;
  const rme::Payload<double> estimate = host_config.estimate;
  host_config.estimate = {};
  SyntheticArm<7> arm(model, config, s.start);
  Host before(model, host_config);
  host_config.estimate = estimate;
  Host after(model, host_config);

  Outcome out;
  double lowest = 0, lowest_free = 0, last_infeasible = -10;
  bool free_books = false;
  Vector compensation = Vector::Zero();
  const int ticks = static_cast<int>(std::lround(kEnd / period));
  for (int k = 0; k < ticks; ++k) {
    const double t = k * period;
    Host& host = t < 1 ? before : after;
    if (k == static_cast<int>(std::lround(1 / period)) && s.payload.mass > 0) arm.attach(s.payload, s.faults ? 0.2 : 0);
    const Eigen::Vector3d push = s.push.at(t + period / 2);  // held over the tick, as the torque is
    arm.push({push, Eigen::Vector3d::Zero()});
    const Vector torque = host.update(arm, push);
    const rme::Status status = host.status();
    if (status == rme::Status::Infeasible) {
      ++out.infeasible;
      last_infeasible = t;
    } else if (status != rme::Status::Ok) {
      ++out.unconverged;
    }
    out.active += host.cpic().active_count() > 0 ? 1 : 0;
    out.iterations = std::max(out.iterations, host.cpic().iterations());
    out.clearance = std::min(out.clearance, host.cpic().null_space().clearance());
    out.torque_excess = std::max(out.torque_excess, (torque.cwiseAbs() - model.tau_max).maxCoeff());
    out.largest_step = std::max(out.largest_step, (host.compensation() - compensation).cwiseAbs().maxCoeff());
    compensation = host.compensation();
    if (static_load(model, arm.q(), arm.payload(), push) > 0.95) out.holdable = false;

    const double residual = host.monitor().residual();
    if (&host == &after && k == static_cast<int>(std::lround(1 / period))) lowest = residual;
    lowest = std::min(lowest, residual);
    out.energy_gain = std::max(out.energy_gain, residual - lowest);
    if (host.cpic().active_count() > 0 || k == static_cast<int>(std::lround(1 / period))) {
      free_books = false;
    } else if (!free_books) {
      free_books = true;
      lowest_free = residual;
    } else {
      lowest_free = std::min(lowest_free, residual);
      out.energy_gain_free = std::max(out.energy_gain_free, residual - lowest_free);
    }

    arm.step(torque);
    if (!torque.allFinite() || !arm.q().allFinite() || !arm.dq().allFinite()) {
      out.finite = false;
      break;
    }
    const double crossed = std::max((arm.q() - model.q_max).maxCoeff(), (model.q_min - arm.q()).maxCoeff());
    out.crossed = std::max(out.crossed, crossed);
    out.speed_excess = std::max(out.speed_excess, (arm.dq().cwiseAbs() - model.dq_max).maxCoeff());
    if (s.host.wall) {
      out.penetrated =
          std::max(out.penetrated, s.host.wall->offset - s.host.wall->normal.dot(arm.kinematics().position));
    }
    if (t > last_infeasible + 1.5 && crossed > 1e-3) out.recovered = false;
  }
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const ArmModel<7>& model = panda();
  for (int i = 0; i < count; ++i) {
    const Scenario s = draw(model, first + static_cast<std::uint64_t>(i), true);
    const Outcome o = run(model, s, 1e-3, 1);
    std::printf(
        "%4d cross %9.2e wall %9.2e speed %9.2e torque %9.2e gain %9.2e free %9.2e act %4d infeas %4d unconv %d it %2d "
        "clear %.3f hold %d rec %d fin %d m %.2f f %.1f faults %d est %.2f cyc %d\n",
        i, o.crossed, o.penetrated, o.speed_excess, o.torque_excess, o.energy_gain, o.energy_gain_free, o.active,
        o.infeasible, o.unconverged, o.iterations, o.clearance, o.holdable, o.recovered, o.finite, s.payload.mass,
        s.push.force.norm(), s.faults, s.host.estimate.mass, s.host.cycle_radius ? 1 : 0);
  }
}
