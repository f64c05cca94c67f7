// guided: a person leads an arm that carries something by the hand. Is the load weightless?
//
// A Panda without stiffness, as in hand guiding: its controller only damps, and carries the arm's own weight. It holds 1 kg
// that it knows nothing of, and a person leads its hand along a path for 20 s, then lets go. tau_ext confirms any
// compensation of such an arm, since the person carries what is missing. Prints how far the believed mass is off while the
// hand is led, and how far the hand sinks in the second after it is let go: without compensation, with that of rme, and with
// that of the true weight, whose rest is the error of the arm's own model.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <mujoco_arm/physics_option.hpp>
#include <rme/estimator.hpp>
#include <stdexcept>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

#include "io/program.hpp"

namespace {

using namespace rme::examples;
using Eigen::Vector3d;

const Vector3d kCenter(0.02, 0.01, 0.10);  // of the payload [m], end-effector axes

constexpr double kPeriod = 1e-3, kMass = 1;                              // [s], [kg]
constexpr double kAttach = 1, kLed = 3, kLetGo = 23, kEnd = kLetGo + 1;  // [s]
constexpr double kHand = 400, kHandDamping = 40;                         // of the person's hand [N/m, N s/m]
constexpr double kWrist = 10, kTwist = 2;                                // of the person's wrist [N m/rad, N m s/rad]
constexpr double kOff = 0.1;  // largest error of the mass that is accepted [kg]

constexpr const char* kUsage = R"(usage: rme_guided [options]

Prints what an arm without stiffness believes to hold while a person leads it by the hand, and how far it moves by itself
when the person lets go.

  --runs N        how many, each with another arm and another path (default 36)
  --seed N        of the first run (default 1)
  --smooth        the person's hand does not tremble
  --physics NAME  synthetic (default), or mujoco if this was built with it
  --help          this text

Exit codes: 0 done; 1 the mass was off by more than 0.1 kg in a run with rme; 2 unusable arguments.
)";

enum class Carries { Nothing, Estimate, Truth };

/// Torque that carries the true payload.
rme::JointVector<double, 7> true_weight(const Kinematics<7>& now) {
  const Vector3d weight(0, 0, -9.81 * kMass), center = now.rotation * kCenter;
  rme::Vector6<double> wrench;
  wrench << weight, center.cross(weight);
  return -now.jacobian.transpose() * wrench;
}

struct Result {
  double off = 0;    ///< largest error of the mass while the hand is led [kg]
  double sinks = 0;  ///< how far the hand goes down by itself within a second [m]
};

Result run_arm(std::uint64_t seed, Carries carries, bool smooth, Engine engine) {
  SyntheticArmConfig<7> faults = with_typical_faults(panda(), seed);
  faults.friction = {};
  faults.noisy_observer = true;
  faults.dq_noise.setConstant(0.002);
  use_engine(engine, faults);
  SyntheticArm<7> arm(panda(), faults, panda().ready);
  const Kinematics<7> home = panda().kinematics(panda().ready);
  PoseImpedance<7> holds(panda(), panda().ready);
  PoseImpedanceConfig free;
  free.rate = free.rotation_stiffness = free.posture_stiffness = 0;
  free.lambda1 = free.lambda2 = 8;
  const PoseImpedance<7> yields(panda(), panda().ready, free);
  rme::EstimatorConfig<double, 7> config;
  config.sensing = rme::Sensing::LinkSide;
  const auto estimator = std::make_unique<rme::Estimator<double, 7>>(kPeriod, config);

  Result result;
  bool attached = false, led = false;
  Vector3d begins = home.position;
  double let_go = 0;
  while (arm.time() < kEnd) {
    const double t = arm.time();
    if (!attached && t > kAttach) attached = arm.attach(box(kMass, kCenter, {0.06, 0.06, 0.1})) > 0;
    const Kinematics<7> now = arm.kinematics();
    if (const rme::Status status = estimator->update({arm.tau_ext(), now.jacobian, now.rotation, arm.dq()});
        status != rme::Status::Ok)
      throw std::runtime_error(to_string(status));
    if (!led && t > kLed) {
      led = true;
      begins = now.position;
    }
    rme::Wrench<double> hand;
    if (led && t < kLetGo) {
      const double u = t - kLed, omega = 2 * std::acos(-1.0) * (0.25 + 0.01 * static_cast<double>(seed % 10));
      const double grown = std::min(1.0, u / 2);
      const Vector3d path(0.05 * std::sin(omega * u), 0.12 * std::sin(0.7 * omega * u),
                          0.06 * std::sin(0.5 * omega * u));
      const Vector3d tremor(0.4 * std::sin(56.5 * t), 0.3 * std::sin(50.3 * t + 1), 0.4 * std::sin(53.4 * t + 2));
      const rme::Vector6<double> twist = now.jacobian * arm.dq();
      const Eigen::AngleAxisd turn(home.rotation * now.rotation.transpose());
      hand.force =
          kHand * (begins + grown * path - now.position) - kHandDamping * twist.head<3>() + (smooth ? 0 : 1) * tremor;
      hand.moment = kWrist * turn.angle() * turn.axis() - kTwist * twist.tail<3>();
      result.off = std::max(result.off, std::abs(estimator->state().payload.mean[0] - kMass));
      let_go = now.position.z();
    }
    if (t >= kLetGo) result.sinks = std::max(result.sinks, let_go - now.position.z());
    rme::JointVector<double, 7> torque = (led ? yields : holds).torque(arm.q(), arm.dq(), now, arm.dynamics());
    if (carries == Carries::Estimate) torque += estimator->compensation(now.jacobian, now.rotation);
    if (carries == Carries::Truth && attached) torque += true_weight(now);
    arm.push(hand);
    arm.step(torque);
  }
  return result;
}

int run(Arguments& arguments) {
  const std::size_t runs = arguments.whole("--runs", 1, 1000).value_or(36);
  const std::uint64_t seed = arguments.whole("--seed", 0).value_or(1);
  const bool smooth = arguments.flag("--smooth");
  const Engine engine = parse_engine(arguments);
  arguments.finish();

  bool good = true;
  std::printf("1 kg, led by the hand for 20 s without stiffness, %zu runs.\n\n", runs);
  std::printf("| carried         | mass off by, median |    worst | sinks within 1 s, median |  worst |\n");
  std::printf("|-----------------|--------------------:|---------:|-------------------------:|-------:|\n");
  for (const Carries carries : {Carries::Nothing, Carries::Estimate, Carries::Truth}) {
    std::vector<double> off, sinks;
    for (std::size_t k = 0; k < runs; ++k) {
      const Result result = run_arm(seed + k, carries, smooth, engine);
      off.push_back(result.off);
      sinks.push_back(1e3 * result.sinks);
      std::fprintf(stderr, "\r%zu of %zu ", k + 1, runs);
    }
    std::fprintf(stderr, "\r            \r");
    std::sort(off.begin(), off.end());
    std::sort(sinks.begin(), sinks.end());
    const char* name = carries == Carries::Nothing ? "nothing"
                       : carries == Carries::Truth ? "the true weight"
                                                   : "what rme finds";
    std::printf("| %-15s |            %.3f kg | %.3f kg |                   %3.0f mm | %3.0f mm |\n", name,
                off[runs / 2], off.back(), sinks[runs / 2], sinks.back());
    std::fflush(stdout);
    if (carries == Carries::Estimate) good = off.back() < kOff;
  }
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_guided", kUsage, argc, argv, run);
}
