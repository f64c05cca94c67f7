// Does an estimate take longer if its window is longer, or if the arm has more joints? A resting arm with random joint
// axes is handed a payload; the tick that makes the final estimate is timed, with the compensation torque.
#include <Eigen/Geometry>
#include <cstddef>
#include <random>
#include <rme/event_estimator.hpp>
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

/// One event from the empty hand to the final estimate, made from `collection` samples; appends what that tick took.
template <int Dofs>
void estimate_once(std::mt19937_64& random, int collection, std::vector<double>& times) {
  EventEstimatorConfig<double, Dofs> config;
  config.collection = collection * kPeriod;
  config.window.duration = config.detector.window + std::max(config.collection, 0.32) + 0.1;
  EventEstimator<double, Dofs> estimator(kPeriod, config);
  RestingArm<Dofs> arm(random);
  const int last = 3000 + collection;
  for (int tick = 0; tick < last; ++tick) {
    const auto& sample = arm.tick(tick < 1000 ? Payload<double>() : Payload<double>{1.1, {0.05, 0.02, 0.13}});
    JointVector<double, Dofs> torque;
    Status status;
    const double time = benchmarks::time_of([&] {
      status = estimator.update(sample);
      torque = estimator.compensation(sample.jacobian, sample.rotation);
    });
    benchmarks::keep(torque);
    if (status != Status::Ok || !estimator.estimated()) continue;
    times.push_back(time);
    break;
  }
  benchmarks::rest();
}

}  // namespace

int main(int argc, char** argv) {
  const bool quick = benchmarks::quick(argc, argv);
  const int events = quick ? 2 : 400;
  std::mt19937_64 random(402);

  // In turns, so that whatever else the machine does meets all lengths alike.
  const int lengths[] = {50, 100, 200, 500, 1000, 2000, 5000};
  std::vector<double> by_length[std::size(lengths)];
  for (int k = 0; k < events; ++k)
    for (std::size_t i = 0; i < std::size(lengths); ++i) estimate_once<7>(random, lengths[i], by_length[i]);
  benchmarks::print_head("Final estimate by window length, 7 joints, without a network");
  for (std::size_t i = 0; i < std::size(lengths); ++i)
    benchmarks::print_row("window of " + std::to_string(lengths[i]) + " samples", by_length[i]);

  std::vector<double> by_joints[4];
  for (int k = 0; k < 2 * events; ++k) {
    estimate_once<6>(random, 200, by_joints[0]);
    estimate_once<7>(random, 200, by_joints[1]);
    estimate_once<10>(random, 200, by_joints[2]);
    estimate_once<14>(random, 200, by_joints[3]);
  }
  benchmarks::print_head("Final estimate by number of joints, window of 200 samples, without a network");
  const int joints[] = {6, 7, 10, 14};
  for (std::size_t i = 0; i < std::size(joints); ++i)
    benchmarks::print_row(std::to_string(joints[i]) + " joints", by_joints[i]);
  std::printf("\nseed 402\n");
}
