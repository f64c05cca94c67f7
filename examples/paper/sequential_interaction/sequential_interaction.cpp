// sequential_interaction: a basket is hung on the arm, two objects are put in and taken out again, the basket is taken
// off, and after each of these changes somebody pushes the arm. Is every change of the payload found, is no push taken
// for a payload, and does the arm hold its pose? Without compensation the arm sinks until a joint limit holds it; the
// published pipeline takes pushes for payloads.
//
// The arm holds a low pose near its base, 0.13 rad from the lower limit of joint 4, under CPIC. Two of the changes take
// half a second. Pushes have 5 to 15 N, last 0.5 to 1.5 s and are within 45 degrees of the horizontal, since a push
// straight down on the flange cannot be told from a payload.
#include <algorithm>
#include <cmath>
#include <cpic_host/energy_books.hpp>
#include <cstdio>
#include <random>

#include "paper/experiment/report.hpp"
#include "paper/experiment/trial.hpp"

namespace {

using namespace rme::examples;
using Eigen::Vector3d;

constexpr double kJudged = 1.5;                // the position error is read this long after a change begins [s]
constexpr double kTarget = 0.006;              // largest position error then [m]
constexpr double kFound = 0.1;                 // a change is found if the mass is this near to the truth [kg]
constexpr double kCarried = 0.2;               // how long a push may be taken for a payload [s]
const double kHeld = 2 * HostConfig().margin;  // this near to its limit, a joint is held by its barrier [rad]
constexpr double kSlow = 0.5;                  // hand-over [s]
constexpr double kBetween = 10;                // from one change to the next [s]
const Trial::Vector kPose = (Trial::Vector() << 0, -0.93, 0, -2.94, 0, 2.02, 0.785).finished();  // [rad]

constexpr const char* kUsage = R"(usage: rme_sequential_interaction [options]

A basket and two objects are attached and removed, and a person pushes in between. Compares no compensation with that of
the published pipeline and that of the tracker.

  --runs N          through the whole sequence (default 5; 1 of them, without object 2, with --quick)
)";

constexpr const char* kExitCodes = R"(
Exit codes: 0 with the tracker every change is found, no push is taken for a payload, joint limits are kept, and the
position error 1.5 s after the beginning of each change is at most 6 mm (with --friction, which can stop the arm in any
position, it is only reported); 1 otherwise; 2 unusable arguments.
)";

struct Item {
  double mass;   // [kg]
  Vector3d com;  // flange axes [m]
};
const std::array<Item, 3> kItems = {{
    {0.4, {0.00, 0.00, 0.08}},   // the basket
    {0.6, {0.03, 0.02, 0.12}},   // object 1
    {0.4, {-0.04, 0.01, 0.10}},  // object 2
}};

/// Something comes into the hand or leaves it.
struct Change {
  const char* name;
  std::size_t item;
  bool attach;
  double ramp;       // [s]
  double start = 0;  // [s]
  Push push = {};    // what follows it
};

/// The same changes in each run, at random times and with random pushes; without object 2 with --quick.
std::vector<Change> draw_script(std::mt19937_64& random, bool quick) {
  std::vector<Change> script = {{"basket attached", 0, true, 0},   {"object 1 added, slowly", 1, true, kSlow},
                                {"object 2 added", 2, true, 0},    {"object 2 removed, slowly", 2, false, kSlow},
                                {"object 1 removed", 1, false, 0}, {"basket removed", 0, false, 0}};
  if (quick) script.erase(script.begin() + 2, script.begin() + 4);
  std::uniform_real_distribution<double> uniform;
  double t = 2;
  for (Change& change : script) {
    change.start = t + 0.5 * uniform(random);
    const double heading = 2 * kPi * uniform(random), slope = kPi / 4 * (2 * uniform(random) - 1);
    const Vector3d direction(std::cos(slope) * std::cos(heading), std::cos(slope) * std::sin(heading), std::sin(slope));
    const double force = 5 + 10 * uniform(random), duration = 0.5 + uniform(random);
    change.push = {change.start + 3 + 0.5 * uniform(random), 0.15, duration - 0.3, force * direction};
    t += kBetween;
  }
  return script;
}

/// Distance of the joint that is nearest to its mechanical limit [rad].
double distance_to_limit(const SyntheticArm<7>& arm) {
  return std::min((panda().q_max - arm.q()).minCoeff(), (arm.q() - panda().q_min).minCoeff());
}

/// What a method found of a change, until somebody pushes.
struct Finding {
  double truth = 0;                // mass of all that is in the hand [kg]
  double mass = 0, deviation = 0;  // estimate before the push, and its standard deviation [kg]
  std::optional<double> carried;   // time after the change from which the mass stays within kFound of the truth [s]
  double position = 0;             // position error kJudged after the change began [m]
  double limit = 10;               // least distance of a joint to its limit [rad]

  void update(const Trial& trial, Method method, double t) {
    const auto& belief = trial.belief(method);
    truth = trial.arm.payload().mass;
    mass = belief.mean[0];
    deviation = belief.standard_deviation()[0];
    if (std::abs(mass - truth) >= kFound)
      carried.reset();
    else if (!carried)
      carried = t;
    if (t < kJudged + kPeriod / 2) position = trial.position_error().norm();
    limit = std::min(limit, distance_to_limit(trial.arm));
  }
  bool found() const { return carried.has_value(); }
};

/// What happened in a push, from its start to the next change.
struct Endurance {
  double mistaken = 0;  // longest time for which more than kFound of it was taken for a payload [s]
  double lifted = 0;    // largest mass that the push was taken for [kg]
  double work = 0;      // of the person on the arm [J]
  double gain = 0;      // largest rise of stored minus supplied energy [J]
  double limit = 10;    // least distance of a joint to its limit [rad]

  void update(const Trial& trial, Method method, const Vector3d& force) {
    const double wrong = std::abs(trial.belief(method).mean[0] - trial.arm.payload().mass);
    since_ = wrong >= kFound ? since_ + kPeriod : 0;
    mistaken = std::max(mistaken, since_);
    lifted = std::max(lifted, wrong);
    work += kPeriod * force.dot(trial.arm.kinematics().jacobian.topRows<3>() * trial.arm.dq());
    books_.update(trial.arm, trial.host, force);
    lowest_ = std::min(lowest_, books_.residual());
    gain = std::max(gain, books_.residual() - lowest_);
    limit = std::min(limit, distance_to_limit(trial.arm));
  }

 private:
  EnergyBooks books_{kPeriod};
  double since_ = 0;   // [s]
  double lowest_ = 0;  // of the books' residual [J]
};

/// One run through the script.
struct Outcome {
  std::vector<Finding> findings;
  std::vector<Endurance> endurances;
};

Outcome run_sequence(const Setup& setup, std::uint64_t number, Method method, CsvFile* csv) {
  std::mt19937_64 random(setup.seed * 7919 + number);
  std::normal_distribution<double> spread(0, 0.03);
  Trial::Vector q = kPose;
  for (double& angle : q) angle += spread(random);
  const std::vector<Change> script = draw_script(random, setup.quick);
  Trial trial(setup.arm(number), HostConfig::hold(panda(), q), q, method);
  SyntheticArm<7>& arm = trial.arm;

  const auto tick = [&](const Vector3d& force, const auto& observe) {
    arm.push({force, Vector3d::Zero()});
    const Trial::Vector torque = trial.command();
    observe();
    if (csv && std::lround(arm.time() / kPeriod) % 20 == 0) {
      const auto& belief = trial.belief(method);
      csv->row(arm.time(), arm.payload().mass, belief.mean[0], belief.standard_deviation()[0],
               trial.position_error().norm(), distance_to_limit(arm), force.norm());
    }
    arm.step(torque);
  };
  const auto is_before = [&](double time) { return arm.time() < time - kPeriod / 2; };
  Outcome outcome;
  std::array<int, kItems.size()> handles{};
  while (is_before(script.front().start)) tick(Vector3d::Zero(), [] {});
  for (std::size_t i = 0; i < script.size(); ++i) {
    const Change& change = script[i];
    const Item& item = kItems[change.item];
    int& handle = handles[change.item];
    if (change.attach)
      handle = arm.attach(experiment_payload(item.mass, item.com), change.ramp);
    else
      arm.detach(handle, change.ramp);
    Finding& finding = outcome.findings.emplace_back();
    const auto wait = [&] { finding.update(trial, method, arm.time() - change.start); };
    while (is_before(change.push.start)) tick(Vector3d::Zero(), wait);
    Endurance& endurance = outcome.endurances.emplace_back();
    const double end = i + 1 < script.size() ? script[i + 1].start : change.start + kBetween;
    while (is_before(end)) {
      const Vector3d force = change.push.at(arm.time());
      tick(force, [&] { endurance.update(trial, method, force); });
    }
  }
  return outcome;
}

/// All runs with one method.
struct Summary {
  int runs = 0, changes = 0, found = 0, mistakes = 0;
  int sunk = 0;                           // runs in which a joint came to rest at its barrier, nobody pushing
  double mass_error = 0;                  // mean absolute, of the changes found [kg]
  double position = 0, worst = 0;         // kJudged after a change, mean and worst [m]
  double lifted = 0, work = 0, gain = 0;  // the largest of all pushes
  double resting = 10, pushed = 10;       // least distance to a limit, until somebody pushes and from then on [rad]

  explicit Summary(const std::vector<Outcome>& outcomes) {
    for (const Outcome& outcome : outcomes) {
      ++runs;
      double rest = 10;
      for (const Finding& finding : outcome.findings) {
        ++changes;
        found += finding.found();
        if (finding.found()) mass_error += std::abs(finding.mass - finding.truth);
        position += finding.position;
        worst = std::max(worst, finding.position);
        rest = std::min(rest, finding.limit);
      }
      resting = std::min(resting, rest);
      sunk += rest < kHeld;
      for (const Endurance& endurance : outcome.endurances) {
        mistakes += endurance.mistaken > kCarried;
        lifted = std::max(lifted, endurance.lifted);
        work = std::max(work, endurance.work);
        gain = std::max(gain, endurance.gain);
        pushed = std::min(pushed, endurance.limit);
      }
    }
    mass_error /= std::max(1, found);
    position /= std::max(1, changes);
  }
};

void print_run(const std::array<Outcome, kMethods.size()>& runs, const std::vector<Change>& script) {
  MarkdownTable table({"change", "truth [kg]", "published pipeline [kg]", "after [s]", "tracker ± std. dev. [kg]",
                       "after [s]", "position error: no compensation [mm]", "published pipeline [mm]", "tracker [mm]"});
  const auto after = [](const std::optional<double>& t) { return t ? text("%.2f", *t) : text("never"); };
  for (std::size_t i = 0; i < script.size(); ++i) {
    const Finding &alone = runs[0].findings[i], &published = runs[1].findings[i], &tracker = runs[2].findings[i];
    table.row({script[i].name, text("%.3f", tracker.truth), text("%.3f", published.mass), after(published.carried),
               text("%.3f ± %.3f", tracker.mass, tracker.deviation), after(tracker.carried),
               text("%.1f", 1e3 * alone.position), text("%.1f", 1e3 * published.position),
               text("%.1f", 1e3 * tracker.position)});
  }
  table.print();
}

int run(Arguments& arguments) {
  const Setup setup = Setup::parse(arguments);
  const std::size_t runs = arguments.whole("--runs", 1, 1000).value_or(setup.quick ? 1 : 5);
  arguments.finish();

  constexpr const char* columns = "t,m,mass,mass_std,error,limit,push";
  std::array<CsvFile, kMethods.size()> courses = {CsvFile(setup.output, "alone.csv", columns),
                                                  CsvFile(setup.output, "published.csv", columns),
                                                  CsvFile(setup.output, "tracker.csv", columns)};
  std::array<std::vector<Outcome>, kMethods.size()> outcomes;
  for (std::size_t k = 1; k <= runs; ++k) {
    for (std::size_t i = 0; i < kMethods.size(); ++i)
      outcomes[i].push_back(run_sequence(setup, k, kMethods[i], k == 1 ? &courses[i] : nullptr));
    progress("sequential_interaction", k, runs);
  }

  std::printf(
      "%s, %zu run(s), seed %llu. In the first run: the mass that is estimated before the push, the time after which "
      "the\n"
      "estimate stays within %.1f kg, and the position error %.1f s after the beginning of each change:\n\n",
      setup.name().c_str(), runs, static_cast<unsigned long long>(setup.seed), kFound, kJudged);
  std::mt19937_64 any;
  print_run({outcomes[0].front(), outcomes[1].front(), outcomes[2].front()}, draw_script(any, setup.quick));

  const std::array<Summary, kMethods.size()> all = {Summary(outcomes[0]), Summary(outcomes[1]), Summary(outcomes[2])};
  MarkdownTable summary({"all runs", "CPIC alone", "published pipeline", "tracker"});
  const auto row = [&](const char* what, bool of_alone, const auto& cell) {
    summary.row({what, of_alone ? cell(all[0]) : text(""), cell(all[1]), cell(all[2])});
  };
  const auto number = [&](const char* what, bool of_alone, double Summary::*member) {
    row(what, of_alone, [member](const Summary& s) { return text("%.1f", 1e3 * s.*member); });
  };
  row("changes found, to 0.1 kg", false, [](const Summary& s) { return text("%d of %d", s.found, s.changes); });
  number("mean absolute error of the total mass then [g]", false, &Summary::mass_error);
  number("position error after a change, mean [mm]", true, &Summary::position);
  number("position error after a change, worst [mm]", true, &Summary::worst);
  row("pushes taken for 0.1 kg and more, over 0.2 s", false,
      [](const Summary& s) { return text("%d of %d", s.mistakes, s.changes); });
  number("largest mass that a push was taken for [g]", false, &Summary::lifted);
  row("runs in which the arm sank to a joint limit", true,
      [](const Summary& s) { return text("%d of %d", s.sunk, s.runs); });
  number("least distance to a joint limit, nobody pushing [mrad]", true, &Summary::resting);
  number("least distance to a joint limit, from the push on [mrad]", true, &Summary::pushed);
  number("most work of a push on the arm [mJ]", true, &Summary::work);
  number("largest rise of stored - supplied energy in a push [mJ]", true, &Summary::gain);
  summary.print();
  const Summary& tracker = all[2];
  const bool kept = std::min(tracker.resting, tracker.pushed) >= 0 && (setup.friction || tracker.worst <= kTarget);
  return tracker.found == tracker.changes && tracker.mistakes == 0 && kept ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_sequential_interaction", std::string(kUsage) + Setup::kUsage + kExitCodes, argc, argv, run);
}
