// Does a tick take longer if the arm has more joints? A resting arm with random joint axes is handed a payload and
// loses it again; each tick feeds the estimator and asks for the compensation torque, timed as one. What a block of 20
// ticks needs is spread over the ticks after it.
#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <random>
#include <rme/estimator.hpp>
#include <rme/inference/payload_regressor.hpp>
#include <string>
#include <vector>

#include "benchmarks/stopwatch.hpp"

namespace {

using namespace rme;

constexpr double kPeriod = 1e-3;  // [s]

/// An arm that nobody has built, at rest: joint axes within reach of the flange, an observer of 50 rad/s.
template <int Dofs>
class RestingArm {
 public:
  explicit RestingArm(std::mt19937_64& random) : random_(random) {
    std::uniform_real_distribution<double> u(-1, 1);
    const auto direction = [&] {
      return Vector3<double>(normal_(random), normal_(random), normal_(random)).normalized();
    };
    for (int j = 0; j < Dofs; ++j) {
      const Vector3<double> axis = direction(), lever = 0.4 * Vector3<double>(u(random), u(random), u(random));
      sample_.jacobian.col(j) << axis.cross(lever), axis;
    }
    sample_.rotation = Eigen::AngleAxisd(3 * u(random), direction()).toRotationMatrix();
  }

  const Proprioception<double, Dofs>& tick(const Payload<double>& payload) {
    const auto regressor =
        payload_regressor<double, Dofs>(sample_.jacobian, sample_.rotation, standard_gravity<double>());
    JointVector<double, Dofs> tau = regressor.torque(payload);
    for (int j = 0; j < Dofs; ++j) tau[j] += 0.05 * normal_(random_);
    sample_.tau_ext += 50 * kPeriod * (tau - sample_.tau_ext);
    return sample_;
  }

 private:
  std::mt19937_64& random_;
  std::normal_distribution<double> normal_;
  Proprioception<double, Dofs> sample_;
};

struct Times {
  std::vector<double> mean, slowest;  // over the ticks of a block [us]
};

/// Half a second with an empty hand, half a second with a payload, and as long without it again.
template <int Dofs>
void live(std::mt19937_64& random, Times& times) {
  Estimator<double, Dofs> estimator(kPeriod);
  RestingArm<Dofs> arm(random);
  double sum = 0, most = 0;
  for (int tick = 1; tick <= 1500; ++tick) {
    const bool held = tick > 500 && tick <= 1000;
    const auto& sample = arm.tick(held ? Payload<double>{1.1, {0.05, 0.02, 0.13}} : Payload<double>());
    JointVector<double, Dofs> torque;
    Status status;
    const double time = benchmarks::time_of([&] {
      status = estimator.update(sample);
      torque = estimator.compensation(sample.jacobian, sample.rotation);
    });
    benchmarks::keep(torque);
    if (status != Status::Ok) continue;
    sum += time;
    most = std::max(most, time);
    if (tick % 20 != 0) continue;
    times.mean.push_back(sum / 20);
    times.slowest.push_back(most);
    sum = most = 0;
  }
  benchmarks::rest();
}

}  // namespace

int main(int argc, char** argv) {
  const int arms = benchmarks::quick(argc, argv) ? 2 : 300;
  std::mt19937_64 random(402);
  Times times[4];
  // In turns, so that whatever else the machine does meets all alike.
  for (int k = 0; k < arms; ++k) {
    live<4>(random, times[0]);
    live<6>(random, times[1]);
    live<7>(random, times[2]);
    live<8>(random, times[3]);
  }
  const int joints[] = {4, 6, 7, 8};
  benchmarks::print_head("Estimator by number of joints");
  for (std::size_t i = 0; i < std::size(joints); ++i)
    benchmarks::print_row("tick, mean over a block: " + std::to_string(joints[i]) + " joints", times[i].mean);
  for (std::size_t i = 0; i < std::size(joints); ++i)
    benchmarks::print_row("slowest tick of a block: " + std::to_string(joints[i]) + " joints", times[i].slowest);
  std::printf("\nseed 402, %d arms\n", arms);
}
