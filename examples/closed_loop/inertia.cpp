// inertia: how much motion of the wrist does an estimate of a payload's inertia need?
//
// A Panda under an impedance law, with the estimator's compensation, holds a long box of 1.5 kg and turns it to and fro
// about all three axes. Its torque sensors have typical noise and offsets. Prints, for turns of several sizes and
// speeds, the relative error of the inertia about the centre of mass (Frobenius norm) after some seconds, and the
// standard deviation that the estimator states for it; medians over the runs.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <rme/core/compensation.hpp>
#include <rme/estimator.hpp>
#include <stdexcept>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

#include "io/program.hpp"

namespace {

using namespace rme::examples;
using Eigen::Matrix3d, Eigen::Vector3d;

constexpr double kPeriod = 1e-3, kAttach = 1, kTurn = 2;  // [s]
constexpr std::array<double, 4> kJudged = {1, 2, 5, 10};  // when the estimate is read, after the turning began [s]
constexpr double kPi = 3.14159265358979323846;

constexpr const char* kUsage = R"(usage: rme_inertia [options]

Prints the error of a payload's estimated inertia after the wrist has been turned, for several angles and speeds.

  --runs N     arms with different noise and offsets, for each row (default 10)
  --friction   the torque contains joint friction
  --seed N     of everything random (default 1)
  --help       this text

Exit codes: 0 done; 1 a simulation failed; 2 unusable arguments.
)";

struct Options {
  std::size_t runs = 10;
  bool friction = false;
  std::uint64_t seed = 1;
};

/// A motion to and fro about all three axes.
struct Turning {
  double amplitude, frequency;  // [rad], [Hz]

  /// The rotation vector [rad] and its rate [rad/s] after t seconds; the motion starts from rest.
  Vector3d vector(double t) const { return swing(t, false); }
  Vector3d rate(double t) const { return swing(t, true); }

 private:
  Vector3d swing(double t, bool rate) const {
    Vector3d out;
    for (int i = 0; i < 3; ++i) {
      const double omega = 2 * kPi * frequency * (1 - 0.15 * i);
      out[i] = amplitude / 2 * (rate ? omega * std::sin(omega * t) : 1 - std::cos(omega * t));
    }
    return out;
  }
};

struct Result {
  std::array<double, kJudged.size()> error, deviation;  // relative to the true inertia
  double speed = 0;                                     // largest angular speed of the flange [rad/s]
};

Result run_arm(const Options& options, const Turning& turning, std::size_t run) {
  auto config = with_typical_faults(panda(), options.seed * 1000003 + run);
  if (!options.friction) config.friction = {};
  SyntheticArm<7> arm(panda(), config, panda().ready);
  PoseImpedanceConfig stiff;
  stiff.rotation_stiffness = 60;
  stiff.rotation_damping = 6;
  PoseImpedance<7> controller(panda(), panda().ready, stiff);
  rme::CompensationRamp<double, 7> ramp(kPeriod);
  rme::Estimator<double, 7> estimator(kPeriod);
  const Kinematics<7> home = panda().kinematics(panda().ready);
  const RigidBody payload = box(1.5, {0.02, 0.01, 0.12}, {0.1, 0.06, 0.3});

  Result result;
  bool attached = false;
  std::size_t judged = 0;
  while (judged < kJudged.size()) {
    const double t = arm.time() - kTurn;
    if (!attached && arm.time() > kAttach) attached = arm.attach(payload) > 0;
    if (t > 0) {
      const Vector3d turn = turning.vector(t);
      const Matrix3d rotation = Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()).toRotationMatrix();
      controller.follow({home.position, rotation * home.rotation, Vector3d::Zero(), turning.rate(t)});
    }
    const auto& [position, rotation, jacobian] = arm.kinematics();
    rme::Status status = estimator.update({arm.tau_ext(), jacobian, rotation, arm.dq()});
    if (status == rme::Status::Ok) status = ramp.update(estimator.compensation(jacobian, rotation));
    if (status != rme::Status::Ok) throw std::runtime_error(to_string(status));
    arm.step(controller.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics()) + ramp.torque());
    result.speed = std::max(result.speed, (jacobian.bottomRows<3>() * arm.dq()).norm());
    if (t < kJudged[judged]) continue;

    const auto& belief = estimator.state().inertial;
    const auto body = rme::InertialParameters<double>::from_vector(belief.mean);
    result.error[judged] = (body.inertia_about_com() - payload.inertia).norm() / payload.inertia.norm();
    // This is the standard deviation of I about the origin. That of I about the centre of mass is about the same, since
    // m and m r are known far better.
    Eigen::Matrix<double, 6, 1> variance = belief.covariance.diagonal().tail<6>();
    for (const int off : {1, 2, 4}) variance[off] *= 2;  // the elements off the diagonal occur twice in the matrix
    result.deviation[judged] = std::sqrt(variance.sum()) / payload.inertia.norm();
    ++judged;
  }
  return result;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

int run(Arguments& arguments) {
  Options options;
  options.runs = arguments.whole("--runs", 1, 10000).value_or(10);
  options.friction = arguments.flag("--friction");
  options.seed = arguments.whole("--seed", 0).value_or(1);
  arguments.finish();

  std::printf("| turned by, at    | peak rad/s |");
  for (const double t : kJudged) std::printf(" error, std. at %2.0f s  |", t);
  std::printf("\n|------------------|-----------:|");
  for (std::size_t i = 0; i < kJudged.size(); ++i) std::printf("---------------------:|");
  std::printf("\n");
  const Turning turnings[] = {{0, 0}, {0.1, 0.5}, {0.2, 0.5}, {0.4, 0.5}, {0.8, 0.5}, {0.4, 0.25}, {0.4, 1}};
  for (const Turning& turning : turnings) {
    std::array<std::vector<double>, kJudged.size()> error, deviation;
    double speed = 0;
    for (std::size_t k = 0; k < options.runs; ++k) {
      const Result result = run_arm(options, turning, k);
      std::fprintf(stderr, "\r%.1f rad, %.2f Hz: %zu of %zu", turning.amplitude, turning.frequency, k + 1,
                   options.runs);
      for (std::size_t i = 0; i < kJudged.size(); ++i) {
        error[i].push_back(result.error[i]);
        deviation[i].push_back(result.deviation[i]);
      }
      speed = std::max(speed, result.speed);
    }
    std::fprintf(stderr, "\r%40s\r", "");
    std::printf("| %.1f rad, %.2f Hz | %10.2f |", turning.amplitude, turning.frequency, speed);
    for (std::size_t i = 0; i < kJudged.size(); ++i)
      std::printf("      %5.0f, %5.0f %% |", 100 * median(error[i]), 100 * median(deviation[i]));
    std::printf("\n");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_inertia", kUsage, argc, argv, run);
}
