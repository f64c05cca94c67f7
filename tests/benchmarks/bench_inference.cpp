// How long do the estimator's parts take? One thread, seven joints, double, random events. Prints a Markdown table with
// the median and the 99th percentile: a control loop cares about the slow calls as well, which an average hides.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <random>
#include <rme/estimator.hpp>
#include <rme/inference/exact_posterior.hpp>
#include <string>
#include <vector>

#include "support/random_events.hpp"

namespace {

using namespace rme;
using testing::kDofs;
using Clock = std::chrono::steady_clock;

double microseconds(Clock::duration d) {
  return std::chrono::duration<double, std::micro>(d).count();
}

void print(const char* what, std::vector<double> times) {
  const auto percentile = [&times](double share) {
    const auto at = times.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(times.size() - 1));
    std::nth_element(times.begin(), at, times.end());
    return *at;
  };
  const double median = percentile(0.5), slow = percentile(0.99);
  std::printf("| %-48s | %9.3f | %9.3f | %7zu |\n", what, median, slow, times.size());
}

double sink = 0;  // keeps results alive

/// Times work(i), `batch` calls at a time where one alone would drown in the clock's own time.
template <typename Work>
void measure(const char* what, std::size_t runs, std::size_t batch, const Work& work) {
  std::vector<double> times;
  for (std::size_t run = 0; run < runs + runs / 10; ++run) {
    const auto start = Clock::now();
    for (std::size_t i = 0; i < batch; ++i) sink += work(run * batch + i);
    const double elapsed = microseconds(Clock::now() - start) / static_cast<double>(batch);
    if (run >= runs / 10) times.push_back(elapsed);  // the first ones warm up
  }
  print(what, times);
}

/// Whole life cycles: a payload comes after a second at rest, is estimated and goes again.
void measure_estimator(std::size_t events) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> watching, collecting, estimating;
  for (std::size_t k = 0; k < events; ++k) {
    const testing::Pose pose = testing::random_pose(random);
    const auto regressor = payload_regressor<double, kDofs>(pose.jacobian, pose.rotation, standard_gravity<double>());
    Estimator<double, kDofs> estimator(1e-3);
    Proprioception<double, kDofs> sample;
    sample.jacobian = pose.jacobian;
    sample.rotation = pose.rotation;
    const JointVector<double, kDofs> weight = regressor.torque({1.1, {0.05, 0.02, 0.13}});
    JointVector<double, kDofs> lagged = JointVector<double, kDofs>::Zero();  // as a momentum observer would report it
    for (int tick = 0; tick < 2000; ++tick) {
      for (int j = 0; j < kDofs; ++j) {
        const double tau = (tick < 1000 ? 0 : weight[j]) + 0.05 * normal(random);
        lagged[j] += 0.0488 * (tau - lagged[j]);
      }
      sample.tau_ext = lagged;
      const Phase before = estimator.phase();
      const auto start = Clock::now();
      const Status status = estimator.update(sample);
      const double elapsed = microseconds(Clock::now() - start);
      if (status != Status::Ok) continue;
      if (estimator.estimated())
        estimating.push_back(elapsed);
      else if (before == Phase::Collecting)
        collecting.push_back(elapsed);
      else if (estimator.phase() != Phase::Collecting)
        watching.push_back(elapsed);
    }
  }
  print("Estimator::update, watching", watching);
  if (!collecting.empty()) print("Estimator::update, collecting", collecting);
  if (!estimating.empty()) print("Estimator::update, the tick that estimates", estimating);
}

}  // namespace

int main() {
  std::mt19937_64 random(1);
  std::vector<testing::Event> events;
  for (int k = 0; k < 200; ++k) events.push_back(testing::random_event(random, 200, k % 2 == 1));
  const auto event = [&events](std::size_t i) -> const testing::Event& { return events[i % events.size()]; };
  const PayloadGaussian<double> prior = testing::wide_prior();
  std::vector<PayloadLikelihood<double>> likelihoods;
  for (const auto& e : events) {
    PayloadLikelihood<double> likelihood;
    if (e.statistics.likelihood(e.precision, e.nuisance, likelihood) != Status::Ok) return 1;
    likelihoods.push_back(likelihood);
  }
  FlangeMotion<double> motion;
  motion.angular_velocity << 0.1, 0.2, 0.3;
  motion.linear_acceleration << 0.3, 0.2, 0.1;
  motion.angular_acceleration << 0.5, -0.5, 0.1;
  const testing::Pose pose = testing::random_pose(random);

  std::printf("compiler flags: %s\n\n", RME_BENCHMARK_FLAGS);
  std::printf("| %-48s | %9s | %9s | %7s |\n", "7 joints, double, one thread", "median us", "99 % us", "runs");
  std::printf("|%s|%s:|%s:|%s:|\n", std::string(50, '-').c_str(), std::string(10, '-').c_str(),
              std::string(10, '-').c_str(), std::string(8, '-').c_str());
  PayloadStatistics<double, kDofs> sums;
  measure("PayloadStatistics::add, per tick", 20000, 20, [&](std::size_t i) {
    sums.add(events[0].samples[i % events[0].samples.size()]);
    return static_cast<double>(sums.count());
  });
  measure("payload_regressor with motion, per tick", 20000, 20, [&](std::size_t i) {
    motion.angular_velocity[0] = 1e-3 * static_cast<double>(i % 100);
    const auto regressor =
        payload_regressor<double, kDofs>(pose.jacobian, pose.rotation, standard_gravity<double>(), motion, 0.03);
    return regressor.a[0] + regressor.B(3, 2);
  });
  measure("PayloadStatistics::likelihood", 20000, 1, [&](std::size_t i) {
    PayloadLikelihood<double> likelihood;
    const auto& e = event(i);
    (void)e.statistics.likelihood(e.precision, e.nuisance, likelihood);
    return likelihood.aa;
  });
  measure("infer: full covariance, from the likelihood", 20000, 1, [&](std::size_t i) {
    VariationalPosterior<double> result;
    (void)infer(likelihoods[i % likelihoods.size()], prior, result);
    return result.posterior.mean[0];
  });
  measure("likelihood and infer: from the sums", 20000, 1, [&](std::size_t i) {
    PayloadLikelihood<double> likelihood;
    VariationalPosterior<double> result;
    const auto& e = event(i);
    (void)e.statistics.likelihood(e.precision, e.nuisance, likelihood);
    (void)infer(likelihood, prior, result);
    return result.posterior.mean[0];
  });
  measure("exact_posterior with evidence", 5000, 1, [&](std::size_t i) {
    ExactPosterior<double> result;
    (void)exact_posterior(likelihoods[i % likelihoods.size()], prior, result);
    return result.moments.mean[0];
  });
  measure_estimator(100);
  return sink == sink ? 0 : 1;
}
