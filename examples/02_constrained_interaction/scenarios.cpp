// rme_02_scenarios: does the constrained controller keep its limits in random situations?
//
// Seeded random scenarios of five seconds on a simulated Panda: start poses, targets, walls, payloads of up to 2 kg and
// pushes of up to 60 N. Half of the arms have friction and faulty sensors; half of the payloads are compensated, with a
// mass error of up to 10 %. Prints how far joint limits were crossed, whether the torque limits held, what happened
// under pushes that no admissible torque can hold, and the energies. Exit code 0 if every promise was kept.
#include <cmath>
#include <cpic_host/energy_books.hpp>
#include <cpic_host/host.hpp>
#include <cstdio>
#include <random>
#include <string>
#include <synthetic_arm/panda.hpp>

#include "io/program.hpp"

namespace {

using namespace rme::examples;
using Vector = Host::Vector;

constexpr double kEnd = 5;         // of a scenario [s]
constexpr double kAttach = 1;      // when the payload is attached [s]
constexpr double kHandOver = 0.2;  // time in which its weight rises to the full value, on arms with faults [s]
constexpr double kRecovery = 1.5;  // time after push and last infeasible tick until limits must hold again [s]

constexpr const char* kUsage =
    R"(usage: rme_02_scenarios [options]

Runs random scenarios of five seconds under the constrained passive controller and prints how far each bound was exceeded.

  --count N         how many scenarios (default 1000); a fifth as many with pushes beyond the torque limits follow
  --seed N          of the first scenario (default 1)
  --continuous      rows for continuous time, as the paper's; otherwise those for sampled time
  --margin RAD      how far inside the joint limits the barriers stand (default 0; continuous: 0.005)
  --help            this text

Exit codes: 0 every promise kept; 1 one broken; 2 unusable arguments.
)";

struct Scenario {
  std::uint64_t seed = 0;
  Vector start;
  HostConfig host;
  Push push;
  RigidBody payload;
  rme::Payload<double> estimate;
  bool faults = false;
};

/// What happened in one scenario, or, merged, the worst of many.
struct Outcome {
  int scenarios = 0;
  long ticks = 0;
  double crossed = 0;            // deepest violation of a joint limit [rad]
  int crossings = 0;             // scenarios in which it exceeded 1e-3 rad
  double short_of = 0;           // sum of the distances to the limit, over ticks with a joint at rest at it [rad]
  double shortest = 0;           // largest of these distances [rad]
  long at_rest = 0;              // number of these distances
  double penetrated = 0;         // deepest violation of the wall [m]
  double too_fast = 0;           // worst excess over a joint's speed limit [rad/s]
  double torque_excess = -1e9;   // largest |tau| - limit [N m]
  double energy_gain = 0;        // largest rise of stored minus supplied energy while no constraint is active [J]
  double held = 0;               // largest energy put in by holding the passive torque in the same ticks [J]
  double imbalance = 0;          // largest error of the energy balance there, on arms without faults [J]
  double compensation_step = 0;  // largest change of the compensation in a tick [N m]
  long active = 0;               // ticks with an active constraint
  int infeasible = 0;            // scenarios with a tick in which the hard rows could not all be kept
  long infeasible_ticks = 0;
  int refused = 0;     // ticks with any other status than Ok
  int iterations = 0;  // most in a tick
  int nonfinite = 0;   // scenarios with a NaN or an infinity
  int lost = 0;        // scenarios still beyond a joint limit after kRecovery

  void merge(const Outcome& o) {
    scenarios += o.scenarios;
    ticks += o.ticks;
    crossings += o.crossings;
    active += o.active;
    infeasible += o.infeasible;
    infeasible_ticks += o.infeasible_ticks;
    refused += o.refused;
    nonfinite += o.nonfinite;
    lost += o.lost;
    crossed = std::max(crossed, o.crossed);
    short_of += o.short_of;
    shortest = std::max(shortest, o.shortest);
    at_rest += o.at_rest;
    penetrated = std::max(penetrated, o.penetrated);
    too_fast = std::max(too_fast, o.too_fast);
    torque_excess = std::max(torque_excess, o.torque_excess);
    energy_gain = std::max(energy_gain, o.energy_gain);
    held = std::max(held, o.held);
    imbalance = std::max(imbalance, o.imbalance);
    compensation_step = std::max(compensation_step, o.compensation_step);
    iterations = std::max(iterations, o.iterations);
  }
};

/// The torque that holds arm, payload and push still, as a share of the limits.
double static_load(const ArmModel<7>& model, const Vector& q, const RigidBody& payload, const Eigen::Vector3d& push) {
  const Vector hold =
      model.dynamics(q, Vector::Zero(), payload).gravity - model.kinematics(q).jacobian.topRows<3>().transpose() * push;
  return hold.cwiseAbs().cwiseQuotient(model.tau_max).maxCoeff();
}

/// @param overload  false: holding the start pose takes at most 60 % of the torque limits; true: more than the limits
Scenario draw(const ArmModel<7>& model, std::uint64_t seed, double margin, bool sampled, bool overload) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    const double z = normal(random), y = normal(random), x = normal(random);
    return Eigen::Vector3d(x, y, z).normalized();
  };
  const auto pose = [&] {
    Vector q;
    for (int j = 0; j < 7; ++j) {
      q[j] = model.q_min[j] + (0.1 + 0.8 * uniform(random)) * (model.q_max[j] - model.q_min[j]);
    }
    return q;
  };
  Scenario s;
  s.seed = seed;
  for (bool fits = false; !fits;) {
    s.start = pose();
    const Eigen::Vector3d way = direction();
    s.push.force = (overload ? 60 + 60 * uniform(random) : 60 * uniform(random)) * way;
    s.payload = {};
    if (uniform(random) < 0.7) {
      const double z = 0.12 * uniform(random), y = 0.1 * uniform(random) - 0.05, x = 0.1 * uniform(random) - 0.05;
      s.payload = box(0.2 + 1.8 * uniform(random), {x, y, z}, {0.08, 0.08, 0.1});
    }
    const double load = static_load(model, s.start, s.payload, s.push.force);
    fits = overload ? load > 1 && load < 2 && static_load(model, s.start, s.payload, {0, 0, 0}) < 0.6 : load < 0.6;
  }
  const auto goal = model.kinematics(s.start + 0.5 * (pose() - s.start));
  s.host.target = goal.position;
  s.host.orientation = Eigen::Quaterniond(goal.rotation);
  s.host.posture = model.ready;
  s.host.margin = margin;
  s.host.sampled = sampled;
  if (uniform(random) < 0.3) s.host.cycle_radius = 0.05 + 0.1 * uniform(random);
  if (uniform(random) < 0.5) {
    const Eigen::Vector3d n = direction();
    s.host.wall = Wall{n, n.dot(model.kinematics(s.start).position) - 0.05 - 0.2 * uniform(random)};
  }
  s.push.start = 0.5 + 2 * uniform(random);
  s.push.rise = 0.1 + 0.2 * uniform(random);
  s.push.hold = uniform(random);
  if (uniform(random) < 0.5) s.estimate = {s.payload.mass * (0.9 + 0.2 * uniform(random)), s.payload.com};
  s.faults = uniform(random) < 0.5;
  return s;
}

Outcome run(const ArmModel<7>& model, const Scenario& s, double period) {
  SyntheticArmConfig<7> config = s.faults ? with_typical_faults(model, s.seed) : SyntheticArmConfig<7>{};
  config.dt = period;
  HostConfig host_config = s.host;
  host_config.period = period;
  SyntheticArm<7> arm(model, config, s.start);
  Host host(model, host_config);
  EnergyBooks books(period);

  Outcome out;
  out.scenarios = 1;
  double lowest = 0;  // least stored minus supplied energy since the balance was started [J]
  double last_excuse = s.push.start + 2 * s.push.rise + s.push.hold;
  Vector compensation = Vector::Zero();
  rme::Payload<double> estimate;
  const int attach = static_cast<int>(std::lround(kAttach / period));
  const int ticks = static_cast<int>(std::lround(kEnd / period));
  for (int k = 0; k < ticks; ++k, ++out.ticks) {
    const double t = k * period;
    if (k == attach && s.payload.mass > 0) {
      arm.attach(s.payload, s.faults ? kHandOver : 0);
      estimate = s.estimate;
    }
    const Eigen::Vector3d push = s.push.at(t);
    arm.push({push, Eigen::Vector3d::Zero()});
    const Vector torque = host.update(
        arm, rme::compensation_torque<double>(estimate, arm.kinematics().jacobian, arm.kinematics().rotation));
    if (host.status() == rme::Status::Infeasible) {
      ++out.infeasible_ticks;
      last_excuse = std::max(last_excuse, t);
    } else if (host.status() != rme::Status::Ok) {
      ++out.refused;
    }
    out.active += host.cpic().active_count() > 0 ? 1 : 0;
    out.iterations = std::max(out.iterations, host.cpic().iterations());
    out.torque_excess = std::max(out.torque_excess, (torque.cwiseAbs() - model.tau_max).maxCoeff());
    out.compensation_step = std::max(out.compensation_step, (host.compensation() - compensation).cwiseAbs().maxCoeff());
    compensation = host.compensation();
    for (int j = 0; j < 7; ++j) {
      if (host.cpic().multiplier(j) == 0 || std::abs(arm.dq()[j]) > 0.01) continue;
      const double distance = std::min(arm.q()[j] - model.q_min[j], model.q_max[j] - arm.q()[j]);
      if (distance > 0.3) continue;  // the active limit is that of the velocity
      out.short_of += distance;
      out.shortest = std::max(out.shortest, distance);
      ++out.at_rest;
    }

    // A payload that is being attached brings energy of its own, and constraints may put in energy: not counted.
    books.update(arm, host, push);
    const bool handing_over = s.payload.mass > 0 && t > kAttach - 2 * period && t < kAttach + kHandOver + period;
    if (handing_over || host.cpic().active_count() > 0) {
      books.reset();
      lowest = 0;
    } else {
      lowest = std::min(lowest, books.residual());
      out.energy_gain = std::max(out.energy_gain, books.residual() - lowest);
      out.held = std::max(out.held, books.held());
      if (!s.faults) out.imbalance = std::max(out.imbalance, std::abs(books.imbalance()));
    }

    arm.step(torque);
    if (!torque.allFinite() || !arm.q().allFinite() || !arm.dq().allFinite()) {
      out.nonfinite = 1;
      break;
    }
    const double crossed = std::max((arm.q() - model.q_max).maxCoeff(), (model.q_min - arm.q()).maxCoeff());
    out.crossed = std::max(out.crossed, crossed);
    out.too_fast = std::max(out.too_fast, (arm.dq().cwiseAbs() - model.dq_max).maxCoeff());
    if (s.host.wall) {
      const double h = s.host.wall->normal.dot(arm.kinematics().position) - s.host.wall->offset;
      out.penetrated = std::max(out.penetrated, -h);
    }
    if (t > last_excuse + kRecovery && crossed > 1e-3) out.lost = 1;
  }
  out.crossings = out.crossed > 1e-3 ? 1 : 0;
  out.infeasible = out.infeasible_ticks > 0 ? 1 : 0;
  return out;
}

int run(Arguments& arguments) {
  const int count = static_cast<int>(arguments.whole("--count", 5, 1000000).value_or(1000));
  const std::uint64_t seed = arguments.whole("--seed", 0).value_or(1);
  const bool sampled = !arguments.flag("--continuous");
  const double margin = arguments.number("--margin").value_or(sampled ? 0 : 0.005);
  arguments.finish();

  const ArmModel<7>& model = panda();
  Outcome all, overloaded, empty_handed, loaded;
  for (int i = 0; i < count; ++i) {
    const Scenario s = draw(model, seed + static_cast<std::uint64_t>(i), margin, sampled, false);
    const Outcome outcome = run(model, s, 1e-3);
    all.merge(outcome);
    (s.payload.mass > 0 ? loaded : empty_handed).merge(outcome);
    if (outcome.crossings > 0)
      std::printf("seed %llu crosses a joint limit by %.1e rad\n", static_cast<unsigned long long>(s.seed),
                  outcome.crossed);
  }
  for (int i = 0; i < count / 5; ++i) {
    overloaded.merge(
        run(model, draw(model, seed + static_cast<std::uint64_t>(count + i), margin, sampled, true), 1e-3));
  }
  Outcome by_period[3];
  const double periods[3] = {1e-3, 5e-4, 2.5e-4};
  for (int i = 0; i < count / 10; ++i) {
    Scenario s = draw(model, seed + static_cast<std::uint64_t>(i), margin, sampled, false);
    s.faults = false;
    for (int p = 0; p < 3; ++p) by_period[p].merge(run(model, s, periods[p]));
  }

  bool kept = true;
  const auto promise = [&kept](const char* what, double value, const char* unit, double limit) {
    const bool good = value <= limit;
    kept = kept && good;
    std::printf("  %-66s %11.3g %-5s <= %-6g %s\n", what, value, unit, limit, good ? "kept" : "BROKEN");
  };
  const auto fact = [](const char* what, double value, const char* unit) {
    std::printf("  %-66s %11.3g %s\n", what, value, unit);
  };
  std::printf("%d scenarios that the torque limits can hold, seeds from %llu (%ld ticks, %.0f %% with an active row)\n",
              all.scenarios, static_cast<unsigned long long>(seed), all.ticks,
              100.0 * static_cast<double>(all.active) / static_cast<double>(all.ticks));
  promise("joint limit crossed by", all.crossed, "rad", 1e-3);
  fact("scenarios beyond 1e-3 rad", all.crossings, "");
  fact("reach: distance to the limit of a joint at rest on its barrier, mean",
       all.short_of / static_cast<double>(std::max(all.at_rest, 1L)), "rad");
  fact("the same, largest", all.shortest, "rad");
  promise("torque beyond its limit by", std::max(all.torque_excess, 0.0), "N m", 0);
  promise("scenarios with a NaN or an infinity", all.nonfinite, "", 0);
  promise("ticks refused or not converged", all.refused, "", 0);
  promise("compensation step in a tick", all.compensation_step, "N m", 1);
  fact("scenarios with a tick without an admissible torque", all.infeasible, "");
  fact("wall (a soft row) passed by", all.penetrated, "m");
  fact("joint speed beyond its limit by", all.too_fast, "rad/s");
  fact("most iterations in a tick", all.iterations, "");
  std::printf("%d scenarios with a push that they cannot hold\n", overloaded.scenarios);
  fact("scenarios, ticks without an admissible torque", overloaded.infeasible, "scenarios");
  fact("", static_cast<double>(overloaded.infeasible_ticks), "ticks");
  fact("joint limit crossed by", overloaded.crossed, "rad");
  promise("torque beyond its limit by", std::max(overloaded.torque_excess, 0.0), "N m", 0);
  promise("scenarios with a NaN or an infinity", overloaded.nonfinite, "", 0);
  fact("scenarios beyond a limit by 1e-3 rad later than 1.5 s after", overloaded.lost, "");
  std::printf("energy: the largest rise of stored minus supplied, away from constraints\n");
  promise("empty hand", empty_handed.energy_gain, "J", 1e-3);
  promise("with a payload, the power of the wrench error counted in", loaded.energy_gain, "J", 1e-3);
  for (int p = 0; p < 3; ++p) {
    std::printf(
        "  period %.2f ms, %4d scenarios without friction: largest rise %8.1e J, put in by holding the torque %8.1e J, "
        "imbalance %8.1e J\n",
        1e3 * periods[p], count / 10, by_period[p].energy_gain, by_period[p].held, by_period[p].imbalance);
  }
  return kept ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_02_scenarios", kUsage, argc, argv, run);
}
