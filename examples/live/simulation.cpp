#include "live/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace rme::examples {

namespace {

constexpr double kHeaviest = 3;  // [kg]; what a Panda is rated for
constexpr double kMove = 2;      // how long a move takes [s]
constexpr double kTurn = 0.7;    // by which most poses are turned [rad]

const Eigen::Vector3d kContentCentre(0, 0, 0.12), kContentSize(0.08, 0.08, 0.08);  // flange axes [m]

/// The ready pose and three others.
PoseTarget pose(std::size_t n) {
  static const Kinematics<7> ready = panda().kinematics(panda().ready);
  static const std::array<PoseTarget, 4> poses = [] {
    const auto at = [](const Eigen::Vector3d& way, const Eigen::Vector3d& turn) {
      const Eigen::AngleAxisd rotation(turn.norm(), turn.stableNormalized());
      return PoseTarget{ready.position + way, rotation * ready.rotation};
    };
    return std::array<PoseTarget, 4>{at({0, 0, 0}, {0, 0, 0}), at({0.02, 0.16, 0.06}, {kTurn, 0, 0}),
                                     at({-0.05, -0.16, 0.1}, {-kTurn / 2, -kTurn, 0}),
                                     at({0.04, 0, -0.14}, {0, kTurn / 2, 0})};
  }();
  return poses[n];
}

/// From one pose to another in kMove, at rest at both ends.
PoseTarget between(const PoseTarget& from, const PoseTarget& to, double t) {
  const double x = std::clamp(t / kMove, 0.0, 1.0), rest = x * (1 - x);
  const double share = x * x * x * (10 + x * (6 * x - 15)), rate = 30 * rest * rest / kMove;
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(to.rotation * from.rotation.transpose()));
  const Eigen::Vector3d way = to.position - from.position;
  return {from.position + share * way, Eigen::AngleAxisd(share * turn.angle(), turn.axis()) * from.rotation, rate * way,
          rate * turn.angle() * turn.axis()};
}

/// Takes fields in the order in which they are drawn.
class Writer {
 public:
  explicit Writer(Snapshot& out) : out_(out) {}
  std::string prefix;

  void operator()(const char* name, double value) { add(name, &value, 1); }
  template <typename Derived>
  void operator()(const char* name, const Eigen::MatrixBase<Derived>& values) {
    const Eigen::MatrixXd dense = values;  // columns first
    add(name, dense.data(), static_cast<std::size_t>(dense.size()));
  }

 private:
  void add(const char* name, const double* values, std::size_t count) {
    out_.fields.push_back({prefix + name, out_.values.size(), count});
    out_.values.insert(out_.values.end(), values, values + count);
  }

  Snapshot& out_;
};

/// Pose of each link and of the flange: position, and quaternion x y z w; a column for each.
Eigen::Matrix<double, 7, 8> link_poses(const LiveArm& arm) {
  Eigen::Matrix<double, 7, 8> out;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  for (int i = 0; i < 7; ++i) {
    const Link& link = panda().links[static_cast<std::size_t>(i)];
    origin += rotation * link.offset;
    rotation = rotation * link.rotation * Eigen::AngleAxisd(arm.q()[i], Eigen::Vector3d::UnitZ());
    out.col(i) << origin, Eigen::Quaterniond(rotation).coeffs();
  }
  out.col(7) << arm.kinematics().position, Eigen::Quaterniond(arm.kinematics().rotation).coeffs();
  return out;
}

void write(const LiveArm& arm, Writer& out) {
  const EstimatorState<double>& state = arm.state();
  const RigidBody payload = arm.payload();
  const Wrench<double> residual = arm.residual();
  out("links", link_poses(arm));
  out("hand", arm.hand());
  out("error", arm.position_error());
  out("payload", Eigen::Vector4d(payload.mass, payload.com[0], payload.com[1], payload.com[2]));
  out("bag", arm.bag() ? arm.bag()->position : Eigen::Vector3d::Zero());
  out("mean", state.payload.mean);
  out("deviation", state.payload.standard_deviation());
  out("com_covariance", state.payload.covariance.bottomRightCorner<3, 3>());
  out("probability", Eigen::Map<const Eigen::Matrix<double, kModes, 1>>(state.probability.values.data()));
  out("held", state.held);
  out("confidence", state.confidence);
  out("health", state.health);
  out("friction_shows", state.friction_shows());
  out("changing", state.changing);
  out("change_noticed", state.change_noticed);
  out("event", Eigen::Vector4d(state.event.number, static_cast<double>(state.event.kind), state.event.onset,
                               state.event.noticed));
  out("force", residual.force);
  out("moment", residual.moment);
  out("compensation", arm.compensation());
  const Eigen::Array<double, 7, 1> room = (arm.q() - panda().q_min).cwiseMin(panda().q_max - arm.q());
  Eigen::Index joint = 0;
  const double least = room.minCoeff(&joint);
  out("limit", Eigen::Vector2d(static_cast<double>(joint) + 1, least));
  out("wall", kLiveWall.normal.dot(arm.kinematics().position) - kLiveWall.offset);
  out("active", arm.active_constraints());
}

}  // namespace

bool Simulation::command(const std::string& line) {
  std::istringstream words(line);
  std::string name;
  std::vector<double> given;
  words >> name;
  for (double number = 0; words >> number;) given.push_back(number);
  const auto is = [&](const char* known, std::size_t count) {
    return words.eof() && name == known && given.size() == count;
  };
  const double held = with_.payload().mass;
  if (is("attach", 4)) {
    if (!(given[0] > 0 && held + given[0] <= kHeaviest)) return false;
    on_both([&](LiveArm& arm) { arm.attach(box(given[0], {given[1], given[2], given[3]}, {0.08, 0.08, 0.1})); });
  } else if (is("hang", 2)) {
    if (!(given[0] > 0 && given[1] > 0 && held + given[0] <= kHeaviest && !with_.bag())) return false;
    on_both([&](LiveArm& arm) { arm.hang(given[0], given[1]); });
  } else if (is("pour", 1)) {
    pour_rate_ = std::clamp(given[0], 0.0, 1.0);
  } else if (is("push", 3)) {
    push_ = Eigen::Vector3d(given[0], given[1], given[2]);
    on_both([&](LiveArm& arm) { arm.push(push_); });
  } else if (is("drop", 0)) {
    on_both([](LiveArm& arm) { arm.drop(); });
    pour_rate_ = poured_ = 0;
  } else if (is("pose", 1) && given[0] >= 0 && given[0] < 4) {
    from_ = target();
    to_ = pose(static_cast<std::size_t>(given[0]));
    moved_at_ = ticks_;
  } else if (is("wall", 1)) {
    wall_ = given[0] != 0;
    with_.constrain(wall_);
  } else {
    const auto fault = std::find_if(kFaults.begin(), kFaults.end(), [&](const auto& f) { return is(f.first, 1); });
    if (fault == kFaults.end()) return false;
    faults_.*fault->second = given[0] != 0;
    on_both([&](LiveArm& arm) { arm.set_faults(faults_); });
  }
  return true;
}

PoseTarget Simulation::target() const {
  return between(from_, to_, static_cast<double>(ticks_ - moved_at_) * LiveArm::kPeriod);
}

void Simulation::step() {
  if (with_.payload().mass >= kHeaviest) pour_rate_ = 0;
  const PoseTarget at = target();
  on_both([&](LiveArm& arm) {
    arm.follow(at);
    if (pour_rate_ > 0) arm.attach(box(pour_rate_ * LiveArm::kPeriod, kContentCentre, kContentSize));
    arm.step();
  });
  poured_ += pour_rate_ * LiveArm::kPeriod;
  ++ticks_;
}

void Simulation::run(const std::string& session, long end) {
  std::istringstream lines(session);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    std::istringstream words(line);
    long at = -1;
    std::string what;
    if (!(words >> at) || !std::getline(words >> std::ws, what) || at < ticks_)
      throw std::invalid_argument("not \"TICK COMMAND\", or out of order: " + line);
    if (at > end) break;
    while (ticks_ < at) step();
    if (!command(what)) throw std::invalid_argument("no command, or refused: " + line);
  }
  while (ticks_ < end) step();
}

Snapshot Simulation::snapshot() const {
  Snapshot out;
  Writer writer(out);
  writer("ticks", static_cast<double>(ticks_));
  writer("push", push_);
  writer("pour", pour_rate_);
  writer("poured", poured_);
  writer("constrained", wall_);
  writer("hanging", with_.bag().has_value());
  writer("wall_at", kLiveWall.offset / kLiveWall.normal[1]);
  for (const auto& [name, member] : kFaults) writer(name, faults_.*member);
  writer.prefix = "without.";
  write(without_, writer);
  writer.prefix = "with.";
  write(with_, writer);
  return out;
}

Simulation::Simulation(std::uint64_t seed) : without_(seed, false), with_(seed, true), from_(pose(0)), to_(pose(0)) {}

}  // namespace rme::examples
