// 02_passivity: does the arm stay passive while the tracker runs, its estimates change, and objects come and go?
//
// A simulated Panda circles in the y-z plane under the constrained passive controller. Objects of 0.3 to 2.5 kg are
// attached and dropped in mid-motion, unannounced, and somebody pushes. The compensation comes from
//
//   nobody     no compensation
//   tracker    rme::Estimator, without any hint from the host; also with an energy tank
//   liar       the empty hand is said to hold 3 kg whenever it rises, and nothing when it sinks: the worst possible
//              estimator; also with an energy tank
//
// Energies (energy_books.hpp): stored is the kinetic energy plus lambda_1 V. Supplied is the work of the push, of the
// wrench error (payload minus compensation), of the cycle's turning, and of the torques that CPIC adds for posture and
// constraints. Passive means that stored minus supplied energy never rises. The balance is also kept in float, and with
// --hours over a working day. The energy that the passive torque puts in because it is held for a tick is printed
// separately, and so is the remaining error of the balance.
#include <array>
#include <cmath>
#include <cpic_host/energy_books.hpp>
#include <cpic_host/host.hpp>
#include <cstdio>
#include <random>
#include <rme/estimator.hpp>
#include <synthetic_arm/panda.hpp>

#include "io/program.hpp"

namespace {

using namespace rme::examples;
using Vector = Host::Vector;

constexpr double kEnd = 20;                           // of a scenario [s]
constexpr double kShare = 1e-3;                       // allowed error of the balance, as a share of energy turned over
constexpr double kTurn = 2 * 3.14159265358979323846;  // [rad]
constexpr double kRounds = 0.5;                       // least share of the cycle's rounds: with fewer, the arm is stuck
constexpr double kLie = 3;                            // mass that the liar says [kg]
constexpr double kRefill = 5;          // of the long run's tank [W]: objects may be left higher than they were taken
constexpr double kLargestMass = 2.5;   // of an object [kg]
constexpr double kHardestPush = 30;    // [N]
constexpr double kMostOfTorque = 0.7;  // share of the torque limits that holds the heaviest object in the first pose

constexpr const char* kUsage =
    R"(usage: rme_02_passivity [options]

Computes the energy balance of an arm that is compensated for a tracker's estimate, while objects are attached and dropped.

  --count N         how many scenarios of 20 s (default 100); the worst follow, with shorter periods
  --hours H         then one run of so many hours about the arm's usual pose, with a tank, its energies in float as well
                    (default 0.05)
  --seed N          of the first scenario (default 1)
  --help            this text

Exit codes: 0 stored minus supplied energy never rose by more than 0.001 of what was turned over, the imbalance is no more
than that, what holding the torque puts in goes with the period, the tank's bound held, the long run was one of motion; 1 not
so; 2 unusable arguments.
)";

enum class Source { Nobody, Tracker, TrackerAndTank, Liar, LiarAndTank };
constexpr const char* kNames[] = {"nobody", "tracker", "tracker, with a tank", "liar", "liar, with a tank"};

struct Outcome {
  double turned_over = 0;   // sum of |work supplied| over all ticks [J]
  double dissipated = 0;    // [J]
  double rise = 0;          // largest rise of stored minus supplied energy [J]
  double share = 0;         // `rise` divided by `turned_over`
  double held = 0;          // energy put in by holding the passive torque, divided by `turned_over`
  double imbalance = 0;     // largest error of the balance, divided by `turned_over`; on arms without faults
  double stored = 0;        // largest stored energy [J]
  double put_in = 0;        // most that the compensation put in since the hand was empty [J]
  double by_holding = 0;    // largest part of it, in absolute value, that came from holding it for a tick [J]
  double span = 0;          // most that it put in from any tick on, minus the refill of the tank since then [J]
  double beyond = -1e9;     // largest excess of `put_in` and `span` over the tank's bounds [J]
  double let_through = 1;   // least share of the tank
  double in_float = 0;      // largest difference of the balance in float, divided by `turned_over`
  std::uint64_t worst = 0;  // seed of the scenario with the largest rise
  double rounds = 0;        // of the hand about the cycle's centre
  long ticks = 0;
  long limited = 0;    // ticks with an active row or torque limit
  long exchanges = 0;  // objects attached or dropped
  long refused = 0;    // ticks with another status than Ok or Infeasible

  void merge(const Outcome& o) {
    turned_over += o.turned_over;
    dissipated += o.dissipated;
    if (o.rise >= rise) worst = o.worst;
    rise = std::max(rise, o.rise);
    share = std::max(share, o.share);
    held = std::max(held, o.held);
    imbalance = std::max(imbalance, o.imbalance);
    stored = std::max(stored, o.stored);
    put_in = std::max(put_in, o.put_in);
    by_holding = std::max(by_holding, o.by_holding);
    span = std::max(span, o.span);
    beyond = std::max(beyond, o.beyond);
    let_through = std::min(let_through, o.let_through);
    in_float = std::max(in_float, o.in_float);
    rounds += o.rounds;
    ticks += o.ticks;
    limited += o.limited;
    exchanges += o.exchanges;
    refused += o.refused;
  }
};

struct Scenario {
  Source source;
  double period = 1e-3;  // [s]
  double end = kEnd;     // [s]
  bool faults = false;   // an arm with friction and faulty sensors
  double refill = 0;     // of the tank [W]
  bool ready = false;    // starts in the arm's usual pose, well inside its limits, instead of a random one
};

/// A random pose in which the heaviest object can be held.
Vector draw_pose(const ArmModel<7>& model, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform;
  const RigidBody heaviest = box(kLargestMass, {0, 0, 0.1}, {0.08, 0.08, 0.1});
  Vector pose;
  do {
    for (int j = 0; j < 7; ++j)
      pose[j] = model.q_min[j] + (0.2 + 0.6 * uniform(random)) * (model.q_max[j] - model.q_min[j]);
  } while (model.dynamics(pose, Vector::Zero(), heaviest).gravity.cwiseAbs().cwiseQuotient(model.tau_max).maxCoeff() >
           kMostOfTorque);
  return pose;
}

/// A host with a random limit cycle through this pose.
HostConfig draw_host(const ArmModel<7>& model, const Vector& start, std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform;
  HostConfig host = HostConfig::hold(model, start);
  host.cycle_radius = 0.06 + 0.09 * uniform(random);
  host.target.y() += *host.cycle_radius;
  host.margin = 0;
  host.sampled = true;
  return host;
}

Outcome simulate(const ArmModel<7>& model, std::uint64_t seed, const Scenario& scenario) {
  const auto& [source, period, end, faults, refill, ready] = scenario;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  const Vector start = ready ? model.ready : draw_pose(model, random);
  HostConfig config = draw_host(model, start, random);
  config.period = period;
  if (source == Source::TrackerAndTank || source == Source::LiarAndTank) {
    config.tank.emplace();
    config.tank->refill = refill;
  }
  SyntheticArmConfig<7> arm_config = faults ? with_typical_faults(model, seed) : SyntheticArmConfig<7>{};
  arm_config.dt = period;
  SyntheticArm<7> arm(model, arm_config, start);
  Host host(model, config);
  rme::Estimator<double, 7> estimator(period);
  EnergyBooks books(period);
  rme::PassivityMonitor<float> small_books(static_cast<float>(period));

  const bool lies = source == Source::Liar || source == Source::LiarAndTank;
  Outcome out;
  out.worst = seed;
  Push push;
  int handle = -1;
  double next_exchange = 1, next_push = 2, lowest = 0, put_in = 0, by_power = 0, potential = 0, span = 0;
  Eigen::Vector3d from_centre = Eigen::Vector3d::Zero();  // in the cycle's plane, a tick ago
  out.ticks = std::lround(end / period);
  for (long k = 0; k < out.ticks; ++k) {
    const double t = static_cast<double>(k) * period;
    if (t >= next_exchange && !lies) {
      const RigidBody before = arm.payload();
      if (handle < 0) {
        const double z = 0.12 * uniform(random), y = 0.1 * uniform(random) - 0.05, x = 0.1 * uniform(random) - 0.05;
        handle = arm.attach(box(0.3 + (kLargestMass - 0.3) * uniform(random), {x, y, z}, {0.08, 0.08, 0.1}));
      } else {
        arm.detach(handle);
        handle = -1;
      }
      books.exchange(arm, before);
      ++out.exchanges;
      next_exchange = t + 1 + 3 * uniform(random);
    }
    if (t >= next_push) {
      const double z = normal(random), y = normal(random), x = normal(random);
      const Eigen::Vector3d way(x, y, z);
      push = {t, 0.1 + 0.2 * uniform(random), uniform(random), kHardestPush * uniform(random) * way.normalized()};
      next_push = t + 2 + 4 * uniform(random);
    }
    arm.push({push.at(t), Eigen::Vector3d::Zero()});

    const Kinematics<7>& at = arm.kinematics();
    Vector compensation = Vector::Zero();
    rme::PayloadGaussian<double> belief = {Eigen::Vector4d::Zero(), Eigen::Matrix4d::Zero()};
    if (lies) {
      belief.mean[0] = at.jacobian.row(2).dot(arm.dq()) > 0 ? kLie : 0.0;
      compensation = rme::compensation_torque<double>(belief.payload(), at.jacobian, at.rotation);
      host.set_payload(belief.payload());
    } else if (source != Source::Nobody) {
      if (estimator.update({arm.tau_ext(), at.jacobian, at.rotation, arm.dq()}) != rme::Status::Ok) ++out.refused;
      belief = estimator.state().payload;
      compensation = estimator.compensation(at.jacobian, at.rotation);
      host.set_payload(belief.payload());
    }
    const Vector torque = host.update(arm, compensation);
    if (host.status() != rme::Status::Ok && host.status() != rme::Status::Infeasible) ++out.refused;

    Eigen::Vector3d arm_of_cycle = at.position - config.target;
    arm_of_cycle.x() = 0;
    out.rounds += std::atan2(from_centre.cross(arm_of_cycle).x(), from_centre.dot(arm_of_cycle)) / kTurn;
    from_centre = arm_of_cycle;
    out.limited += host.cpic().active_count() > 0 ? 1 : 0;

    books.update(arm, host, push.at(t));
    (void)small_books.update_with_work(static_cast<float>(books.stored()), static_cast<float>(books.work()));
    lowest = std::min(lowest, books.residual());
    out.rise = std::max(out.rise, books.residual() - lowest);
    out.stored = std::max(out.stored, books.stored());
    out.turned_over += std::abs(books.work());
    out.in_float = std::max(out.in_float, std::abs(static_cast<double>(small_books.residual()) - books.residual()));
    out.held = std::max(out.held, std::abs(books.held()));
    if (!faults) out.imbalance = std::max(out.imbalance, std::abs(books.imbalance()));

    // The tank's bound is one on the torque that is commanded.
    by_power += arm.dq().dot(host.compensation()) * period;
    potential = std::max(potential, std::abs(rme::compensation_potential<double>(
                                        belief.payload(), at.position - config.target, at.rotation)));
    out.let_through = std::min(out.let_through, host.tank_share());
    const Vector before = arm.q();
    arm.step(torque);
    const double work = host.compensation().dot(arm.q() - before);
    put_in += work;
    span = std::max(span, 0.0) + work - refill * period;
    out.put_in = std::max(out.put_in, put_in);
    out.span = std::max(out.span, span);
    if (config.tank) {
      // Counted since the hand was empty, and from any tick on: there, the work may already owe max |U|.
      out.beyond = std::max(out.beyond, put_in - refill * (t + period) - (config.tank->initial + potential));
      out.beyond = std::max(out.beyond, span - (config.tank->capacity + 2 * potential));
    }
    out.by_holding = std::max(out.by_holding, std::abs(put_in - by_power));
  }
  out.dissipated = -books.residual();
  out.share = out.rise / out.turned_over;
  out.held /= out.turned_over;
  out.imbalance /= out.turned_over;
  out.in_float /= out.turned_over;
  return out;
}

/// Whether the arm has faults: in every other scenario.
bool faulty(std::uint64_t seed) {
  return seed % 2 == 0;
}

/// Runs the scenarios with the largest rises at shorter periods. The energy that a torque puts in because it is held
/// is proportional to the period; energy that the balance has left out would not be.
/// @return whether it fell with the period, and the balance has no error at any period
bool print_by_period(const ArmModel<7>& model, const std::array<Outcome, 5>& outcomes, std::uint64_t seed, int count) {
  const std::uint64_t worst[] = {outcomes[static_cast<std::size_t>(Source::Tracker)].worst,
                                 outcomes[static_cast<std::size_t>(Source::Liar)].worst};
  std::printf(
      "\n| period  | largest rise, tracker, seed %llu | liar, seed %llu | tracker, put in by holding, share | missing "
      "in "
      "the books, share |\n",
      static_cast<unsigned long long>(worst[0]), static_cast<unsigned long long>(worst[1]));
  std::printf(
      "|--------:|------------------------------:|-------------:|--------------------------------:"
      "|---------------------------:|\n");
  double first = 0, last = 0, missing = 0;
  for (const double period : {1e-3, 5e-4, 2.5e-4}) {
    const Outcome tracker = simulate(model, worst[0], {Source::Tracker, period, kEnd, faulty(worst[0])});
    const Outcome liar = simulate(model, worst[1], {Source::Liar, period, kEnd, faulty(worst[1])});
    Outcome few;
    for (int i = 0; i < std::max(count / 10, 1); ++i)
      few.merge(simulate(model, seed + static_cast<std::uint64_t>(i), {Source::Tracker, period}));
    std::printf("| %.2f ms | %27.2g J | %10.2g J | %31.1e | %26.1e |\n", 1e3 * period, tracker.rise, liar.rise,
                few.held, few.imbalance);
    (period == 1e-3 ? first : last) = few.held;
    missing = std::max(missing, few.imbalance);
  }
  return last <= 0.5 * first && missing <= kShare;
}

int run(Arguments& arguments) {
  const int count = static_cast<int>(arguments.whole("--count", 1, 1000000).value_or(100));
  const double hours = arguments.number("--hours").value_or(0.05);
  const std::uint64_t seed = arguments.whole("--seed", 0).value_or(1);
  arguments.finish();
  if (!(hours > 0 && hours <= 1000)) throw ArgumentError("--hours: expected above 0 to 1000");
  const ArmModel<7>& model = panda();
  bool kept = true;

  std::printf("%d scenarios of %.0f s, seeds from %llu, half of them with friction and faulty sensors\n\n", count, kEnd,
              static_cast<unsigned long long>(seed));
  std::printf(
      "| compensation         | exchanges | turned over | dissipated | largest rise | share of turned over "
      "| most stored | compensation put in, most | over the tank's bound |\n");
  std::printf(
      "|----------------------|----------:|------------:|-----------:|-------------:|---------------------:"
      "|------------:|--------------------------:|----------------------:|\n");
  std::array<Outcome, 5> outcomes;
  for (const Source source :
       {Source::Nobody, Source::Tracker, Source::TrackerAndTank, Source::Liar, Source::LiarAndTank}) {
    Outcome& all = outcomes[static_cast<std::size_t>(source)];
    for (int i = 0; i < count; ++i) {
      const std::uint64_t scenario = seed + static_cast<std::uint64_t>(i);
      all.merge(simulate(model, scenario, {source, 1e-3, kEnd, faulty(scenario)}));
    }
    const bool tank = source == Source::TrackerAndTank || source == Source::LiarAndTank;
    std::printf("| %-20s | %9ld | %9.0f J | %8.0f J | %10.2g J | %20.1e | %9.2f J | %23.1f J | ",
                kNames[static_cast<int>(source)], all.exchanges, all.turned_over, all.dissipated, all.rise, all.share,
                all.stored, all.put_in);
    if (tank) {
      std::printf("%19.1f J |\n", std::max(all.beyond, 0.0));
    } else {
      std::printf("%21s |\n", "");
    }
    kept = kept && all.share <= kShare && all.refused == 0 && !(tank && all.beyond > 0);
  }

  kept = print_by_period(model, outcomes, seed, count) && kept;

  const Outcome day = simulate(model, seed, {Source::TrackerAndTank, 1e-3, 3600 * hours, false, kRefill, true});
  const double asked = 3600 * hours * rme::LimitCycleConfig<double>().angular_speed / kTurn;
  std::printf(
      "\n%.2f hours with the tracker and a tank, %ld exchanges, %.0f rounds of the hand (%.0f asked for), in %.1f %% "
      "of "
      "the time\nat a limit: %.0f J turned over, %.0f J dissipated; of what was turned over\n"
      "  %.1e  largest rise of stored minus supplied\n  %.1e  put in by holding the passive torque\n"
      "  %.1e  imbalance; %.1e more with energies kept in float\n"
      "The compensation put in %.1f J at most from any tick on, less a refill of %.1f W: %.1f J within the tank's "
      "bound.\n"
      "By being held for a tick it put in %.2g J. The tank let through a share of %.2f of it or more.\n",
      hours, day.exchanges, day.rounds, asked,
      100.0 * static_cast<double>(day.limited) / static_cast<double>(day.ticks), day.turned_over, day.dissipated,
      day.share, day.held, day.imbalance, day.in_float, day.span, kRefill, -day.beyond, day.by_holding,
      day.let_through);
  kept = kept && day.share <= kShare && day.imbalance <= kShare && day.in_float <= kShare && day.refused == 0 &&
         day.beyond <= 0 && day.rounds >= kRounds * asked;
  return kept ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_02_passivity", kUsage, argc, argv, run);
}
