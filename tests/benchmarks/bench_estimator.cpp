// What does a host's tick cost? A simulated Panda holds random poses while random payloads come and go; each tick feeds
// the estimator and asks for the compensation torque, timed as one. The tick that estimates is the whole chain: from
// the window's last sample to payload, covariance and torque.
#include <cstdio>
#include <random>
#include <rme/event_estimator.hpp>
#include <rme/network/network_prior.hpp>
#include <string>
#include <vector>

#include "benchmarks/shipped_network.hpp"
#include "benchmarks/stopwatch.hpp"
#include "support/held_arm.hpp"

namespace {

using namespace rme;
using testing::HeldArm;

/// A network's prior that says how often the network was asked.
template <typename NetworkScalar>
struct CountingPrior {
  PayloadGaussian<double> operator()(const SampleWindow<double, 7>& window, std::size_t count) const noexcept {
    const auto gaussian = prior(window, count);
    *asked += gaussian.mean[0] != FixedPrior<double>().gaussian.mean[0];
    return gaussian;
  }
  NetworkPrior<double, PublishedArchitecture, NetworkScalar> prior;
  std::size_t* asked;
};

struct Times {
  std::vector<double> watching, collecting, early, final;
  std::size_t asked = 0;  // networks, in ticks that made a final estimate
};

/// One payload in one pose: a second at rest, the payload comes, is estimated, and is carried for a while.
template <typename Prior>
void live(std::mt19937_64& random, const Prior& prior, const std::size_t& asked, Times& times) {
  std::uniform_real_distribution<double> u(-1, 1);
  HeldArm arm(random());
  HeldArm::Vector pose = arm.pose();
  for (int j = 0; j < 7; ++j) pose[j] += 0.4 * u(random);
  arm.move(pose, HeldArm::kPeriod);
  (void)arm.tick();
  const Payload<double> payload = {1.1 + 0.7 * u(random), {0.05 * u(random), 0.05 * u(random), 0.1 + 0.08 * u(random)}};
  EventEstimator<double, 7, Prior> estimator(HeldArm::kPeriod, {}, prior);
  for (int tick = 0; tick < 2200; ++tick) {
    if (tick == 1000) arm.hold(payload);
    const auto& sample = arm.tick();
    const Phase before = estimator.phase();
    const std::size_t asked_before = asked;
    Status status;
    HeldArm::Vector torque;
    const double time = benchmarks::time_of([&] {
      status = estimator.update(sample);
      torque = estimator.compensation(sample.jacobian, sample.rotation);
    });
    benchmarks::keep(torque);
    if (status != Status::Ok) continue;
    if (estimator.estimated()) {
      times.final.push_back(time);
      times.asked += asked - asked_before;
    } else if (estimator.refreshed()) {
      times.early.push_back(time);
    } else if (before == Phase::Collecting && estimator.phase() == Phase::Collecting) {
      times.collecting.push_back(time);
    } else if (before != Phase::Collecting && estimator.phase() != Phase::Collecting) {
      times.watching.push_back(time);
    }
  }
}

/// @param which  what the rows' names end with
template <typename Prior>
void report(const std::string& which, const Prior& prior, const std::size_t& asked, int events) {
  std::mt19937_64 random(401);
  Times times;
  for (int k = 0; k < events; ++k) {
    live(random, prior, asked, times);
    benchmarks::rest();
  }
  benchmarks::print_head(("Estimator, " + which).c_str());
  benchmarks::print_row("tick while watching, " + which, times.watching);
  benchmarks::print_row("tick while collecting, " + which, times.collecting);
  benchmarks::print_row("tick with an early estimate, " + which, times.early);
  benchmarks::print_row("tick with the final estimate, " + which, times.final);
  std::printf("\nseed 401, %d events; the network was asked in %zu of %zu final estimates\n", events, times.asked,
              times.final.size());
}

template <typename NetworkScalar>
void report_network(const std::string& which, int events) {
  const auto network = benchmarks::shipped_network<NetworkScalar>();
  std::size_t asked = 0;
  report(which, CountingPrior<NetworkScalar>{{*network, HeldArm::kPeriod}, &asked}, asked, events);
}

}  // namespace

int main(int argc, char** argv) {
  const int events = benchmarks::quick(argc, argv) ? 5 : 5000;
  report_network<float>("network in float", events);
  report_network<double>("network in double", events);
  report("no network", FixedPrior<double>(), std::size_t(0), events);
}
