// rme_02_payload_scenarios: an object is attached to, or dropped by, an arm that moves next to a joint limit or a wall.
// Do the constraints hold while the object's mass is not yet known?
//
// Random poses of a simulated Panda with one joint 5 to 50 mrad from a limit, or the flange 5 to 50 mm from a wall, and
// a target beyond it. An object of 0.5 to 3 kg is attached in mid-motion and dropped later, both in a single tick. The
// estimator is in the loop, and its compensation is added. Each scenario runs with the rows of three hosts:
//
//   published   continuous time, nominal dynamics; the compensation is added after CPIC and taken to be right
//   observer    the same, with the external torque of a fast observer in the bias
//   sampled     the observer's, for sampled time, tightened by the prediction error seen just before
//
// Exit code 0 if the sampled rows were crossed by more than 1 mrad or 1 mm in no scenario, and the torque limits held.
#include <cmath>
#include <cpic_host/host.hpp>
#include <cstdio>
#include <limits>
#include <random>
#include <rme/estimator.hpp>
#include <stdexcept>
#include <synthetic_arm/panda.hpp>

#include "io/program.hpp"

namespace {

using namespace rme::examples;
using Vector = Host::Vector;

constexpr double kPeriod = 1e-3;  // [s]
constexpr double kEnd = 3;        // of a scenario [s]

constexpr const char* kUsage =
    R"(usage: rme_02_payload_scenarios [options]

Attaches and drops objects next to joint limits and walls, under three kinds of rows, and prints how far they were crossed.

  --count N         how many scenarios (default 1000)
  --seed N          of the first scenario (default 1)
  --help            this text

Exit codes: 0 the sampled rows held in all scenarios; 1 they did not; 2 unusable arguments.
)";

struct Scenario {
  Vector start;
  HostConfig host;
  RigidBody payload;
  double attach, drop;  // [s]
};

struct Outcome {
  int crossings = 0;     // scenarios beyond 1 mrad or 1 mm
  double joint = 0;      // largest distance beyond a joint limit [rad]
  double wall = 0;       // largest distance beyond the wall [m]
  double short_of = 0;   // sum over scenarios of the least distance to a limit or the wall [rad or m]
  long infeasible = 0;   // ticks with the status Infeasible
  double excess = -1e9;  // largest |tau| - limit [N m]

  void merge(const Outcome& o) {
    crossings += o.crossings;
    joint = std::max(joint, o.joint);
    wall = std::max(wall, o.wall);
    short_of += o.short_of;
    infeasible += o.infeasible;
    excess = std::max(excess, o.excess);
  }
};

Scenario draw(const ArmModel<7>& model, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::normal_distribution<double> normal;
  Scenario s;
  Vector goal;
  for (bool fits = false; !fits;) {
    for (int j = 0; j < 7; ++j)
      s.start[j] = model.q_min[j] + (0.15 + 0.7 * uniform(random)) * (model.q_max[j] - model.q_min[j]);
    goal = s.start;
    for (int j = 0; j < 7; ++j) goal[j] += 0.2 * normal(random);
    const bool wall = uniform(random) < 0.4;
    if (wall) {
      const Eigen::Vector3d from = model.kinematics(s.start).position, way = model.kinematics(goal).position - from;
      const Eigen::Vector3d n = -way.normalized();
      const double room = 0.005 + 0.045 * uniform(random);
      s.host.wall = Wall{n, n.dot(from) - room};
      fits = way.norm() > room + 0.02;
    } else {
      s.host.wall.reset();
      const int joint = 1 + static_cast<int>(random() % 6);
      const bool upper = random() % 2 == 0;
      const double room = 0.005 + 0.045 * uniform(random);
      s.start[joint] = upper ? model.q_max[joint] - room : model.q_min[joint] + room;
      goal[joint] = s.start[joint] + (upper ? 1 : -1) * (room + 0.1 + 0.2 * uniform(random));
      fits = true;
    }
    const double z = 0.12 * uniform(random), y = 0.1 * uniform(random) - 0.05, x = 0.1 * uniform(random) - 0.05;
    s.payload = box(0.5 + 2.5 * uniform(random), {x, y, z}, {0.08, 0.08, 0.1});
    for (const Vector& q : {s.start, goal}) {
      const Vector hold = model.dynamics(q, Vector::Zero(), s.payload).gravity;
      fits = fits && hold.cwiseAbs().cwiseQuotient(model.tau_max).maxCoeff() < 0.7;
    }
  }
  const auto at = model.kinematics(goal);
  s.host.target = at.position;
  s.host.orientation = Eigen::Quaterniond(at.rotation);
  s.host.posture = goal;
  s.host.wall_weight = std::numeric_limits<double>::infinity();
  s.host.margin = 0;
  s.attach = 0.2 + 0.6 * uniform(random);
  s.drop = s.attach + 0.5 + uniform(random);
  return s;
}

enum class Rows { Published, Observer, Sampled };
constexpr const char* kNames[] = {"published", "observer", "sampled"};

Outcome run(const ArmModel<7>& model, const Scenario& s, Rows rows) {
  HostConfig config = s.host;
  config.prediction = rows == Rows::Published ? Prediction::Nominal : Prediction::Observer;
  config.sampled = rows == Rows::Sampled;
  SyntheticArmConfig<7> arm_config;
  arm_config.dt = kPeriod;
  SyntheticArm<7> arm(model, arm_config, s.start);
  Host host(model, config);
  rme::Estimator<double, 7> estimator(kPeriod);
  Outcome out;
  double nearest = 1;
  int handle = -1;
  const auto tick = [](double t) { return static_cast<int>(std::lround(t / kPeriod)); };
  for (int k = 0; k < tick(kEnd); ++k) {
    if (k == tick(s.attach)) handle = arm.attach(s.payload);
    if (k == tick(s.drop)) arm.detach(handle);
    const Kinematics<7>& kinematics = arm.kinematics();
    const rme::Status status = estimator.update({arm.tau_ext(), kinematics.jacobian, kinematics.rotation, arm.dq()});
    if (status != rme::Status::Ok) throw std::runtime_error(to_string(status));
    const Vector torque = host.update(arm, estimator.compensation(kinematics.jacobian, kinematics.rotation));
    out.infeasible += host.status() == rme::Status::Infeasible ? 1 : 0;
    out.excess = std::max(out.excess, (torque.cwiseAbs() - model.tau_max).maxCoeff());
    arm.step(torque);
    const double room = std::min((model.q_max - arm.q()).minCoeff(), (arm.q() - model.q_min).minCoeff());
    out.joint = std::max(out.joint, -room);
    nearest = std::min(nearest, room);
    if (s.host.wall) {
      const double h = s.host.wall->normal.dot(arm.kinematics().position) - s.host.wall->offset;
      out.wall = std::max(out.wall, -h);
      nearest = std::min(nearest, h);
    }
  }
  out.crossings = out.joint > 1e-3 || out.wall > 1e-3 ? 1 : 0;
  out.short_of = std::max(nearest, 0.0);
  return out;
}

int run(Arguments& arguments) {
  const int count = static_cast<int>(arguments.whole("--count", 1, 1000000).value_or(1000));
  const std::uint64_t seed = arguments.whole("--seed", 0).value_or(1);
  arguments.finish();
  const ArmModel<7>& model = panda();
  Outcome all[3];
  for (int i = 0; i < count; ++i) {
    const Scenario s = draw(model, seed + static_cast<std::uint64_t>(i));
    for (int r = 0; r < 3; ++r) all[r].merge(run(model, s, static_cast<Rows>(r)));
    if ((i + 1) % 100 == 0) {
      std::fprintf(stderr, "\r%d of %d", i + 1, count);
      std::fflush(stderr);
    }
  }
  std::printf("\n%d scenarios, seeds from %llu; 0.5 to 3 kg attached and dropped in mid-motion\n\n", count,
              static_cast<unsigned long long>(seed));
  std::printf(
      "| rows      | crossed by more than 1 mrad or 1 mm | joint limit, most | wall, most | nearest, mean | ticks "
      "infeasible | torque beyond limits |\n");
  std::printf(
      "|-----------|------------------------------------:|------------------:|-----------:|--------------:|-----"
      "-------------:|---------------------:|\n");
  for (int r = 0; r < 3; ++r) {
    std::printf("| %-9s | %35d | %12.2f mrad | %7.2f mm | %7.2f mm, mrad | %16ld | %18.1g N m |\n", kNames[r],
                all[r].crossings, 1e3 * all[r].joint, 1e3 * all[r].wall, 1e3 * all[r].short_of / count,
                all[r].infeasible, std::max(all[r].excess, 0.0));
  }
  const Outcome& sampled = all[static_cast<int>(Rows::Sampled)];
  return sampled.crossings == 0 && sampled.excess <= 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_02_payload_scenarios", kUsage, argc, argv, run);
}
