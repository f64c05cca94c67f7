// pick_check: did the gripper pick the right object? Did the object slip? Was it dropped?
//
// A Panda picks objects of a catalogue, one after the other, lifts each and lets it fall. The estimator's compensation
// moves the arm, and the program asks an ObjectCatalogue 0.3 s after each pick what is in the hand. Prints which object
// was taken for which, and how soon it was noticed that the hand had lost its object.
// With --once: one pick, one slip and one drop, and a sentence about each.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>
#include <random>
#include <rme/core/compensation.hpp>
#include <rme/estimator.hpp>
#include <rme/host/object_catalogue.hpp>
#include <stdexcept>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

#include "io/program.hpp"
#include "paper/experiment/report.hpp"

namespace {

using namespace rme::examples;
using Eigen::Vector3d;
using Vector = rme::JointVector<double, 7>;
using State = rme::EstimatorState<double>;

constexpr double kPeriod = 1e-3;  // of the control loop [s]
// One cycle: the hand comes down to the object, rests, picks it, lifts it, and lets it fall [s].
constexpr double kDown = 0.8, kPick = 1.0, kLift = 0.6, kDrop = 2.0, kCycle = 2.3;
constexpr double kSoon = 0.05, kNever = 1e9;  // a drop is noticed soon, or not at all [s]
constexpr double kHeight = 0.1;               // to which an object is lifted [m]
constexpr double kWeighsIn = 0.05;            // longest time in which an object's weight comes on [s]
constexpr double kApart = 0.06;  // objects whose masses differ by less are not told apart by their mass alone [kg]

constexpr const char* kUsage = R"(usage: rme_pick_check [options]

Picks objects with a simulated Panda, and asks the catalogue after each pick what is in the hand.

  --once            one pick that is checked, one slip and one drop, with a sentence about each
  --object NAME     of --once: what is picked (default drill); an unknown name lists all
  --sensing NAME    link_side, joint_friction (the torque contains the friction of the joints), or both (default)
  --runs N          picks of each object, on one arm for each ten of them (default 200)
  --after T         when the catalogue is asked, after the pick [s], 0.05 to 0.9 (default 0.3)
  --certain P       probability from which the catalogue gives an answer, 0.5 to below 1 (default 0.98)
  --by-mass         of the objects only the masses are known, not where they are gripped
  --told            the host says expect_change() when the gripper closes or opens
  --seed N          of everything random (default 1)
  --help            this text

Exit codes: 0 at least 98 % of the picks are recognised, of those whose mass is 60 g or more from all others' (--once: pick,
slip and drop are recognised); 1 fewer are; 2 unusable arguments; 3 any other failure.
)";

/// An object that the cell handles.
struct Item {
  const char* name;
  double mass;   // [kg]
  Vector3d com;  // where it is when gripped as planned, flange axes [m]
};
// The two cans differ by less than kApart.
const std::array<Item, 10> kItems = {{{"sponge", 0.05, {0.00, 0.00, 0.13}},
                                      {"pen case", 0.11, {0.03, 0.00, 0.12}},
                                      {"screwdriver", 0.18, {-0.03, 0.00, 0.12}},
                                      {"cup", 0.25, {0.00, 0.02, 0.13}},
                                      {"pliers", 0.33, {0.04, 0.00, 0.12}},
                                      {"can of peas", 0.42, {0.00, 0.00, 0.14}},
                                      {"can of beans", 0.45, {0.00, 0.00, 0.14}},
                                      {"hammer", 0.70, {0.07, 0.00, 0.12}},
                                      {"bottle", 1.00, {0.00, 0.00, 0.16}},
                                      {"drill", 1.50, {0.05, -0.02, 0.14}}}};
constexpr int kOther = static_cast<int>(kItems.size());  // a pick of something that is none of them
constexpr int kNothing = kOther + 1;                     // and one that missed
constexpr int kPicks = kNothing + 1;

using Catalogue = rme::ObjectCatalogue<double, static_cast<int>(kItems.size())>;

// How well an object and its place in the hand are known, standard deviations.
constexpr double kOfMass = 0.01, kOfGrip = 0.01;  // share of the mass; [m], each direction

struct Options {
  bool once = false, by_mass = false, told = false;
  std::size_t object = kItems.size() - 1;
  std::vector<bool> friction = {false, true};
  std::size_t runs = 200;
  double after = 0.3;  // [s]
  double certain = 0.98;
  std::uint64_t seed = 1;
};

Options parse(Arguments& arguments) {
  Options options;
  options.once = arguments.flag("--once");
  std::vector<std::pair<std::string, std::size_t>> names;
  for (std::size_t i = 0; i < kItems.size(); ++i) names.emplace_back(kItems[i].name, i);
  options.object = arguments.choice("--object", names).value_or(options.object);
  options.friction = arguments
                         .choice<std::vector<bool>>(
                             "--sensing", {{"link_side", {false}}, {"joint_friction", {true}}, {"both", {false, true}}})
                         .value_or(options.friction);
  options.runs = arguments.whole("--runs", 1, 100000).value_or(options.runs);
  options.after = arguments.number("--after").value_or(options.after);
  options.certain = arguments.number("--certain").value_or(options.certain);
  options.by_mass = arguments.flag("--by-mass");
  options.told = arguments.flag("--told");
  options.seed = arguments.whole("--seed", 0).value_or(options.seed);
  arguments.finish();
  if (!(options.after >= 0.05 && options.after <= 0.9)) throw ArgumentError("--after: must be from 0.05 to 0.9 s");
  if (!(options.certain >= 0.5 && options.certain < 1)) throw ArgumentError("--certain: must be from 0.5 to below 1");
  return options;
}

// <snippet catalogue>
Catalogue catalogue_of(double certain, bool by_mass) {
  rme::ObjectCatalogueConfig<double> config;
  config.certain = certain;  // probability from which it gives an answer
  Catalogue catalogue(config);
  for (const Item& item : kItems) {
    const double doubt = kOfMass * item.mass;
    if (by_mass) {
      catalogue.add(item.name, item.mass, doubt);
    } else {
      const Eigen::Vector4d mean(item.mass, item.com[0], item.com[1], item.com[2]);
      catalogue.add(item.name, rme::PayloadGaussian<double>::independent(mean, {doubt, kOfGrip, kOfGrip, kOfGrip}));
    }
  }
  return catalogue;
}
// </snippet>

// <snippet held>
std::string sentence(const Catalogue& catalogue, const rme::EstimatorState<double>& state) {
  const auto held = catalogue.identify(state);
  switch (held.holding) {
    case rme::Holding::Known:
      return std::string("the ") + catalogue.name(held.index) + " is in the hand";
    case rme::Holding::Unknown:
      return "something is in the hand that is none of the objects";
    case rme::Holding::Nothing:
      return "the hand is empty";
    case rme::Holding::CannotTell:
      break;
  }
  return "cannot tell what is in the hand";
}
// </snippet>

/// The arm, the host's controller, and what the host adds to it.
class Cell {
 public:
  Cell(bool friction, std::uint64_t seed)
      : random_(seed), arm_(panda(), faults(friction, seed), start()), law_(panda(), arm_.q()) {
    home_ = {arm_.kinematics().position, arm_.kinematics().rotation};
  }

  void tick() {
    const auto& [position, rotation, jacobian] = arm_.kinematics();
    const rme::Status status = estimator_.update({arm_.tau_ext(), jacobian, rotation, arm_.dq()});
    if (status != rme::Status::Ok) throw std::runtime_error(rme::to_string(status));
    if (state().event.number != events_ && state().event.kind == rme::EventKind::Moved) ++moves_;
    events_ = state().event.number;
    if (ramp_.update(estimator_.compensation(jacobian, rotation)) != rme::Status::Ok)
      throw std::runtime_error("the compensation is not finite");
    law_.follow(target());
    arm_.step(law_.torque(arm_.q(), arm_.dq(), arm_.kinematics(), arm_.dynamics()) + ramp_.torque());
  }
  void run(double seconds) {
    for (long k = std::lround(seconds / kPeriod); k > 0; --k) tick();
  }
  /// The hand goes to a height above the place of the pick [m].
  void go(double height, double seconds) {
    from_ = height_of(arm_.time());
    to_ = height;
    begin_ = arm_.time();
    seconds_ = seconds;
  }
  int attach(const RigidBody& body, double ramp) { return arm_.attach(body, ramp); }
  void detach(int handle, double ramp = 0) { arm_.detach(handle, ramp); }
  void expect_change() { estimator_.expect_change(); }
  const State& state() const { return estimator_.state(); }
  double time() const { return arm_.time(); }
  int moves() const { return moves_; }  // events "moved in the hand"
  std::mt19937_64& random() { return random_; }

 private:
  static SyntheticArmConfig<7> faults(bool friction, std::uint64_t seed) {
    auto config = with_typical_faults(panda(), seed);
    if (!friction) config.friction = {};
    config.torque_noise.setConstant(0.05);
    config.dq_noise.setConstant(2e-3);
    return config;
  }
  Vector start() {
    Vector q = panda().ready;
    for (int j = 0; j < 7; ++j) q[j] += std::uniform_real_distribution(-0.2, 0.2)(random_);
    return q;
  }
  double height_of(double t) const {
    const double x = std::clamp((t - begin_) / seconds_, 0.0, 1.0);
    return from_ + x * x * x * (10 + x * (6 * x - 15)) * (to_ - from_);
  }
  PoseTarget target() const {
    PoseTarget out = home_;
    out.position.z() += height_of(arm_.time());
    out.velocity.z() = (height_of(arm_.time() + kPeriod) - height_of(arm_.time() - kPeriod)) / (2 * kPeriod);
    return out;
  }

  std::mt19937_64 random_;
  SyntheticArm<7> arm_;
  PoseImpedance<7> law_;
  rme::Estimator<double, 7> estimator_{kPeriod};
  rme::CompensationRamp<double, 7> ramp_{kPeriod};
  PoseTarget home_;
  double from_ = 0, to_ = 0, begin_ = 0, seconds_ = 1;
  int events_ = 0, moves_ = 0;
};

/// An object as it is this time, in the hand as it was gripped this time; nothing for kNothing.
RigidBody draw(int pick, std::mt19937_64& random) {
  std::normal_distribution<double> n;
  double mass = 0;
  Vector3d com(0, 0, 0.13);
  if (pick == kNothing) return {};
  if (pick < kOther) {
    const Item& item = kItems[static_cast<std::size_t>(pick)];
    mass = item.mass * (1 + kOfMass * n(random));
    com = item.com;
  } else {
    const auto near = [&](const Item& item) { return std::abs(item.mass - mass) < kApart; };
    do mass = std::uniform_real_distribution(0.05, 1.5)(random);
    while (std::any_of(kItems.begin(), kItems.end(), near));
  }
  for (double& c : com) c += kOfGrip * n(random);
  return box(mass, com, {0.06, 0.06, 0.1});
}

/// What a program of the cell's makes of an answer: the index of an item, kOther, kNothing, or none of these.
std::optional<int> said(const rme::HeldObject<double, static_cast<int>(kItems.size())>& answer) {
  switch (answer.holding) {
    case rme::Holding::Known:
      return answer.index;
    case rme::Holding::Unknown:
      return kOther;
    case rme::Holding::Nothing:
      return kNothing;
    case rme::Holding::CannotTell:
      break;
  }
  return std::nullopt;
}

/// How often each pick was taken for what; the last column is "cannot tell".
struct Counts {
  std::array<std::array<int, kPicks + 1>, kPicks> taken{};
  // Time from a drop until an event began, and until the hand was known to be empty [s]; kNever: not before the next pick.
  std::array<std::vector<double>, kPicks> noticed, empty;
  int moves = 0;  // events "moved in the hand", though nothing slipped

  int row(std::size_t pick) const { return std::accumulate(taken[pick].begin(), taken[pick].end(), 0); }
};

void pick_and_drop(const Options& options, const Catalogue& catalogue, Cell& cell, int pick, Counts& counts) {
  const auto row = static_cast<std::size_t>(pick);
  cell.go(0, kDown);
  cell.run(kPick);
  const RigidBody body = draw(pick, cell.random());
  const double weighs_in = std::uniform_real_distribution(0.0, kWeighsIn)(cell.random());
  const int handle = body.mass > 0 ? cell.attach(body, weighs_in) : 0;
  cell.go(kHeight, kLift);
  if (options.told) cell.expect_change();
  cell.run(options.after);
  const auto answer = said(catalogue.identify(cell.state()));
  ++counts.taken[row][static_cast<std::size_t>(answer.value_or(kPicks))];
  cell.run(kDrop - kPick - options.after);
  const State& state = cell.state();
  const bool held = !state.empty() && !state.changing;
  cell.detach(handle);
  if (options.told) cell.expect_change();
  const double dropped = cell.time();
  double noticed = kNever, empty = kNever;
  while (cell.time() < dropped + kCycle - kDrop) {
    cell.tick();
    const double since = cell.time() - dropped;
    if (state.changing || state.empty()) noticed = std::min(noticed, since);
    if (state.empty()) empty = std::min(empty, since);
  }
  if (!held || body.mass <= 0) return;
  counts.noticed[row].push_back(noticed);
  counts.empty[row].push_back(empty);
}

Counts run_picks(const Options& options, const Catalogue& catalogue, bool friction) {
  constexpr std::size_t kOnOneArm = 10;
  Counts counts;
  const std::size_t all = options.runs * kPicks;
  std::size_t done = 0;
  for (std::size_t first = 0, arm = 0; first < options.runs; first += kOnOneArm, ++arm) {
    Cell cell(friction, options.seed * 1000003 + arm);
    std::vector<int> order;
    for (int pick = 0; pick < kPicks; ++pick)
      order.insert(order.end(), std::min(kOnOneArm, options.runs - first), pick);
    std::shuffle(order.begin(), order.end(), cell.random());
    cell.go(kHeight, kDown);
    cell.run(1);
    for (const int pick : order) {
      pick_and_drop(options, catalogue, cell, pick, counts);
      progress(friction ? "picks, joint friction" : "picks, link side", ++done, all);
    }
    counts.moves += cell.moves();
  }
  return counts;
}

const char* name_of(std::size_t pick) {
  return pick < kItems.size()                       ? kItems[pick].name
         : pick == static_cast<std::size_t>(kOther) ? "something else"
                                                    : "nothing";
}
bool alike(std::size_t a, std::size_t b) {
  return a < kItems.size() && b < kItems.size() && std::abs(kItems[a].mass - kItems[b].mass) < kApart - 1e-9;
}

void print_drops(const char* what, const std::array<std::vector<double>, kPicks>& counts) {
  std::vector<double> times;
  std::string slow;
  const auto late = [](double t) { return t > kSoon + 1e-9; };
  for (std::size_t row = 0; row < kPicks; ++row) {
    times.insert(times.end(), counts[row].begin(), counts[row].end());
    const auto n = std::count_if(counts[row].begin(), counts[row].end(), late);
    if (n > 0)
      slow +=
          text("%s%ld of %zu: ", slow.empty() ? " (" : ", ", static_cast<long>(n), counts[row].size()) + name_of(row);
  }
  if (times.empty()) return;
  std::sort(times.begin(), times.end());
  std::printf("%s after %.0f ms (median of %zu); later than %.0f ms in %ld%s%s.\n", what, 1e3 * times[times.size() / 2],
              times.size(), 1e3 * kSoon, static_cast<long>(std::count_if(times.begin(), times.end(), late)),
              slow.c_str(), slow.empty() ? "" : ")");
}

/// @return share of the picks that are recognised, of those whose mass no other object has
double print(const Counts& counts, bool friction) {
  std::printf("%s: what was in the hand, and how often it was taken for what [%%]\n\n",
              friction ? "Joint friction" : "Link side");
  std::vector<std::string> head = {"in the hand", "mass [g]"};
  for (std::size_t k = 0; k < kItems.size(); ++k) head.push_back(text("%.0f", 1e3 * kItems[k].mass));
  for (const char* name : {"else", "nothing", "cannot tell"}) head.emplace_back(name);
  MarkdownTable table(head);
  int right = 0, wrong = 0, unsure = 0, all = 0;
  for (std::size_t row = 0; row < kPicks; ++row) {
    std::vector<std::string> cells = {name_of(row),
                                      row < kItems.size() ? text("%.0f", 1e3 * kItems[row].mass) : std::string()};
    for (const int count : counts.taken[row])
      cells.push_back(count ? text("%.1f", 100.0 * count / counts.row(row)) : "");
    table.row(cells);
    bool alone = true;
    for (std::size_t k = 0; k < kItems.size(); ++k) alone = alone && (k == row || !alike(row, k));
    if (!alone) continue;
    all += counts.row(row);
    right += counts.taken[row][row];
    unsure += counts.taken[row].back();
  }
  wrong = all - right - unsure;
  table.print();
  std::printf("Masses 60 g apart or more: %.2f %% right, %.2f %% cannot tell, %.2f %% wrong, of %d picks.\n",
              100.0 * right / all, 100.0 * unsure / all, 100.0 * wrong / all, all);
  print_drops("Drops: an event began", counts.noticed);
  print_drops("Drops: the hand was known to be empty", counts.empty);
  std::printf("Events \"moved in the hand\", though nothing slipped: %d.\n", counts.moves);
  std::printf("\n");
  return static_cast<double>(right) / all;
}

/// One pick that slips and falls; what a program would say of it.
bool tell(const Options& options, const Catalogue& catalogue, bool friction) {
  std::printf("%s:\n", friction ? "Joint friction" : "Link side");
  Cell cell(friction, options.seed);
  const auto wait_for = [&](const auto& happened, double most) {
    const double begin = cell.time();
    while (!happened() && cell.time() < begin + most) cell.tick();
    return cell.time() - begin;
  };
  cell.go(kHeight, kDown);
  cell.run(1);
  cell.go(0, kDown);
  cell.run(kPick);
  RigidBody body = draw(static_cast<int>(options.object), cell.random());
  int handle = cell.attach(body, 0.03);
  cell.go(kHeight, kLift);
  cell.run(options.after);
  const State& state = cell.state();
  const bool right = said(catalogue.identify(state)) == static_cast<int>(options.object);
  std::printf("  %.2f s after the pick: %s, %.0f +- %.0f g; heavier than 100 g with a probability of %.3f.\n",
              options.after, sentence(catalogue, state).c_str(), 1e3 * state.payload.mean[0],
              1e3 * state.payload.standard_deviation()[0], state.heavier_than(0.1));

  cell.run(2);
  const double now = cell.time();
  const int events = state.event.number;
  const Vector3d before = state.payload.mean.tail<3>();
  // It slides through the fingers, across the hand, in 50 ms.
  cell.detach(handle, 0.05);
  body = box(body.mass, body.com + Vector3d(0.03, 0.04, 0), {0.06, 0.06, 0.1});
  handle = cell.attach(body, 0.05);
  wait_for([&] { return state.event.number > events; }, 2);
  const bool moved = state.event.number > events && state.event.kind == rme::EventKind::Moved;
  const Vector3d way = state.payload.mean.tail<3>() - before;
  if (state.event.number > events)
    std::printf(
        "  It slips by 5.0 cm: event \"%s\", noticed after %.0f ms, over after %.0f ms; by %.1f cm across the hand.\n",
        rme::to_string(state.event.kind), 1e3 * (state.event.noticed - now), 1e3 * (state.event.over - now),
        1e2 * way.head<2>().norm());
  else
    std::printf("  It slips by 5.0 cm: no event; by %.1f cm across the hand.\n", 1e2 * way.head<2>().norm());

  cell.run(1);
  cell.detach(handle);
  const double noticed = wait_for([&] { return state.changing || state.empty(); }, 1);
  cell.run(0.3);
  std::printf("  It is dropped: noticed after %.0f ms; 0.3 s later: %s.\n", 1e3 * noticed,
              sentence(catalogue, state).c_str());
  return right && moved && said(catalogue.identify(state)) == kNothing;
}

int run(Arguments& arguments) {
  const Options options = parse(arguments);
  const Catalogue catalogue = catalogue_of(options.certain, options.by_mass);
  std::printf("seed %llu; %s, asked %.2f s after the pick.\n\n", static_cast<unsigned long long>(options.seed),
              options.by_mass ? "masses known to 1 %" : "masses known to 1 %, grips to 1 cm", options.after);
  bool good = true;
  for (const bool friction : options.friction)
    good = (options.once ? tell(options, catalogue, friction)
                         : print(run_picks(options, catalogue, friction), friction) >= 0.98) &&
           good;
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_pick_check", kUsage, argc, argv, run);
}
