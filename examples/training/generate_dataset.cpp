// generate_dataset FILE: the pseudo-wrenches of a Panda in 200 ms windows after an unknown object is attached to it.
//
// In each event, a simulated arm holds a random pose, and a random box is attached, at once or within 150 ms. The
// sensors have noise and offsets, and most measure joint friction (examples/synthetic_arm). Several windows are taken
// from each event; they start up to 0.6 s after the attachment. Every event has its own seed, so that the file does not
// depend on the number of threads.
//
// FILE: one line of JSON that names the columns, then 32-bit floats, row after row, little-endian; train.py reads it.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <io/program.hpp>
#include <random>
#include <rme/sensing/pseudo_wrench.hpp>
#include <stdexcept>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/random_pose.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <thread>
#include <vector>

namespace {

using namespace rme::examples;

constexpr const char* kUsage =
    R"(usage: generate_dataset FILE [options]

  --events N         simulated payloads (default 1000)
  --windows N        windows of each (default 4)
  --seed N           of everything random (default 1)
  --pose ready|any   N(0, 0.1 rad) around the ready pose, or anywhere (default any)
  --damping X        lambda of the pseudo-wrench (default 1e-2)
  --threads N        (default: all cores)
  --help             this text

Exit codes: 0 done; 2 unusable arguments; 3 the file cannot be written.
)";

using Vector7 = rme::JointVector<double, 7>;
using Vector6 = rme::Vector6<double>;

constexpr int kSamples = 20, kStride = 10;    // the newest sample of each 10 ms
constexpr int kQuiet = 500, kBaseline = 100;  // time before the attachment; its last part is the baseline [ms]
constexpr int kLatestStart = 600;             // latest start of a window after the attachment [ms]
constexpr int kAfter = kLatestStart + kSamples * kStride;

constexpr const char* kColumns =
    R"({"columns": [["world", [20, 6]], ["end_effector", [20, 6]], ["baseline_world", [6]], )"
    R"(["baseline_end_effector", [6]], ["gravity_direction", [3]], ["theta", [4]], ["start", [1]], ["event", [1]], )"
    R"(["friction_shows", [1]]], )";

struct Settings {
  int events, windows;
  std::uint64_t seed;
  bool any_pose;
  double damping = 1e-2;
};

/// Pseudo-wrench at one instant, in both frames.
struct Wrenches {
  Vector6 world, end_effector;
};

Wrenches wrenches(const SyntheticArm<7>& arm, double damping) {
  rme::Wrench<double> world;
  if (rme::pseudo_wrench(arm.kinematics().jacobian, arm.tau_ext(), damping, world) != rme::Status::Ok)
    throw std::runtime_error("the simulated arm reports nonsense");
  return {world.vector(), rme::in_end_effector_axes<double>(world, arm.kinematics().rotation).vector()};
}

class Event {
 public:
  explicit Event(std::uint64_t seed) : random_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double normal(double deviation) { return deviation * normal_(random_); }

  Vector7 pose(bool any) {
    if (any) return random_panda_pose([&](double low, double high) { return uniform(low, high); });
    return panda().ready + Vector7::NullaryExpr([&] { return normal(0.1); });
  }

  /// 0.2 to 2 kg, centre of mass within 8 cm across the flange's axis and up to 20 cm along it.
  RigidBody payload() {
    const double mass = uniform(0.2, 2.0);
    const double angle = uniform(0, 2 * 3.141592653589793), radius = 0.08 * std::sqrt(uniform(0, 1));
    const Eigen::Vector3d com(radius * std::cos(angle), radius * std::sin(angle), uniform(0, 0.2));
    const double height = uniform(0.03, 0.15), width = uniform(0.03, 0.1), length = uniform(0.03, 0.1);
    return box(mass, com, Eigen::Vector3d(length, width, height));
  }

  PoseImpedanceConfig gains() {
    PoseImpedanceConfig config;
    config.rate = uniform(2, 5);
    config.lambda1 = uniform(40, 100);
    config.lambda2 = uniform(60, 120);
    config.rotation_stiffness = uniform(10, 40);
    config.rotation_damping = uniform(1, 4);
    return config;
  }

  /// A row for each window; empty if the arm leaves its pose by more than 0.3 m or exceeds a velocity limit.
  std::vector<float> rows(const Settings& settings, int index);

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

std::vector<float> Event::rows(const Settings& settings, int index) {
  const ArmModel<7>& model = panda();
  SyntheticArmConfig<7> config = with_typical_faults(model, random_());
  // A quarter of the arms sense behind the gears and measure no friction; the network has to serve both kinds.
  if (uniform(0, 1) < 0.25) config.sensing = TorqueSensing::LinkSide;
  const Vector7 target = pose(settings.any_pose);
  const PoseImpedance<7> controller(model, target, gains());
  const RigidBody body = payload();
  const double ramp = uniform(0, 1) < 0.5 ? 0 : uniform(0, 0.15);
  // The arm starts beside the target and moves to it. This leaves some friction in each joint, as on a real arm.
  SyntheticArm<7> arm(model, config, target + Vector7::NullaryExpr([&] { return normal(0.02); }));
  const auto tick = [&] { arm.step(controller.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics())); };

  Wrenches baseline{Vector6::Zero(), Vector6::Zero()};
  for (int k = 0; k < kQuiet; ++k) {
    tick();
    if (k < kQuiet - kBaseline) continue;
    const Wrenches w = wrenches(arm, settings.damping);
    baseline.world += w.world / kBaseline;
    baseline.end_effector += w.end_effector / kBaseline;
  }
  arm.attach(body, ramp);
  std::vector<Wrenches> felt;
  for (int k = 0; k < kAfter; ++k) {
    tick();
    felt.push_back(wrenches(arm, settings.damping));
    if (controller.position_error(arm.kinematics()).norm() > 0.3 ||
        (arm.dq().array().abs() > model.dq_max.array()).any())
      return {};
  }

  std::vector<float> out;
  const auto put = [&](const auto& values) {
    for (const double value : values) out.push_back(static_cast<float>(value));
  };
  const Eigen::Vector3d down = arm.kinematics().rotation.transpose() * Eigen::Vector3d(0, 0, -1);
  for (int w = 0; w < settings.windows; ++w) {
    const int start = static_cast<int>(uniform(0, kLatestStart));
    const auto sample = [&](int i) { return felt[static_cast<std::size_t>(start + kStride * (i + 1) - 1)]; };
    for (int i = 0; i < kSamples; ++i) put(sample(i).world);
    for (int i = 0; i < kSamples; ++i) put(sample(i).end_effector);
    put(baseline.world);
    put(baseline.end_effector);
    put(down);
    put(Eigen::Vector4d(body.mass, body.com[0], body.com[1], body.com[2]));
    put(Eigen::Vector3d(1e-3 * start, index, config.sensing == TorqueSensing::MotorSide ? 1 : 0));
  }
  return out;
}

/// The rows of event `index`, which is drawn again until the arm holds its pose.
std::vector<float> make_rows(const Settings& settings, int index) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    std::seed_seq sequence{settings.seed, static_cast<std::uint64_t>(index), attempt};
    std::mt19937_64 random(sequence);
    std::vector<float> rows = Event(random()).rows(settings, index);
    if (!rows.empty()) return rows;
  }
}

/// @throws std::runtime_error if the file cannot be written
void generate(const Settings& settings, const std::string& path, unsigned threads) {
  std::ofstream file(path, std::ios::binary);  // opened before the simulation, which would be lost otherwise
  if (!file) throw std::runtime_error(path + ": cannot be written");
  std::vector<std::vector<float>> rows(static_cast<std::size_t>(settings.events));
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int i = next++; i < settings.events; i = next++) {
      rows[static_cast<std::size_t>(i)] = make_rows(settings, i);
      if ((i + 1) % 500 == 0) std::fprintf(stderr, "\r%d of %d payloads", i + 1, settings.events);
    }
  };
  std::vector<std::thread> workers;
  for (unsigned t = 0; t < threads; ++t) workers.emplace_back(work);
  for (std::thread& worker : workers) worker.join();
  std::fprintf(stderr, "\n");

  file << kColumns << R"("rows": )" << settings.events * settings.windows << R"(, "events": )" << settings.events
       << R"(, "seed": )" << settings.seed << R"(, "pose": ")" << (settings.any_pose ? "any" : "ready")
       << R"(", "damping": )" << settings.damping << "}\n";
  for (const std::vector<float>& event : rows) {
    file.write(reinterpret_cast<const char*>(event.data()), static_cast<std::streamsize>(event.size() * sizeof(float)));
  }
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

int run(Arguments& arguments) {
  Settings settings;
  settings.events = static_cast<int>(arguments.whole("--events", 1).value_or(1000));
  settings.windows = static_cast<int>(arguments.whole("--windows", 1, 1000).value_or(4));
  settings.seed = arguments.whole("--seed", 0).value_or(1);
  settings.any_pose = arguments.choice<bool>("--pose", {{"any", true}, {"ready", false}}).value_or(true);
  settings.damping = arguments.number("--damping").value_or(settings.damping);
  if (!(settings.damping > 0)) throw ArgumentError("--damping: expected a number > 0");
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  const auto threads = static_cast<unsigned>(arguments.whole("--threads", 1, 1000).value_or(cores));
  const std::string path = arguments.positional("FILE");
  arguments.finish();
  generate(settings, path, threads);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("generate_dataset", kUsage, argc, argv, run);
}
