#include <random>
#include <rme/inference/window_statistics.hpp>

#include "support/catch.hpp"
#include "support/random_events.hpp"

namespace {

using rme::PayloadObservation;
using rme::PayloadStatistics;
using rme::Status;
using rme::WindowStatistics;
using rme::testing::gaussian3;
using rme::testing::kDofs;

/// An arm on the move: each tick another pose, another acceleration.
std::vector<PayloadObservation<double, kDofs>> motion(std::mt19937_64& random, int ticks) {
  std::vector<PayloadObservation<double, kDofs>> out;
  for (int k = 0; k < ticks; ++k) {
    const auto [J, R] = rme::testing::random_pose(random);
    PayloadObservation<double, kDofs> o;
    const rme::FlangeMotion<double> m{gaussian3(random), gaussian3(random), gaussian3(random)};
    o.regressor = rme::payload_regressor<double, kDofs>(J, R, rme::standard_gravity<double>(), m, 0.03);
    o.tau.setRandom();
    o.direction = rme::JointVector<double, kDofs>::Random().cwiseSign();
    o.velocity.setRandom();
    out.push_back(o);
  }
  return out;
}

/// The likelihood of the sums, under some nuisances or other.
rme::PayloadLikelihood<double> likelihood(const PayloadStatistics<double, kDofs>& sums) {
  rme::NuisanceGaussian<double, kDofs> nuisance;
  for (std::size_t j = 0; j < kDofs; ++j) {
    nuisance.mean[j] << 0.1, 0.2, 0.05;
    nuisance.covariance[j] = Eigen::Vector3d(0.01, 0.04, 0.09).asDiagonal();
  }
  rme::PayloadLikelihood<double> out;
  REQUIRE(sums.likelihood(rme::JointVector<double, kDofs>::Constant(100), nuisance, out) == Status::Ok);
  return out;
}

void check_same(const rme::PayloadLikelihood<double>& a, const rme::PayloadLikelihood<double>& b) {
  CHECK(a.yy == Approx(b.yy));
  CHECK(a.ya == Approx(b.ya).margin(1e-9));
  CHECK(a.aa == Approx(b.aa));
  CHECK((a.yB - b.yB).norm() < 1e-10 * b.BB.norm());
  CHECK((a.aB - b.aB).norm() < 1e-10 * b.BB.norm());
  CHECK((a.BB - b.BB).norm() < 1e-10 * b.BB.norm());
  CHECK(a.log_factor == Approx(b.log_factor));
}

TEST_CASE("WindowStatistics: about a centre of mass it is the Taylor expansion of every tick's torque there",
          "[window_statistics]") {
  const unsigned seed = 140;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const auto ticks = motion(random, 30);
  const Eigen::Vector3d com(0.04, -0.07, 0.12);
  WindowStatistics<double, kDofs> window(1);
  PayloadStatistics<double, kDofs> expanded;
  for (const auto& o : ticks) {
    window.add(o);
    // By central differences, which are exact for a quadratic: torque per kilogram at com, and its slope.
    const auto torque = [&o](const Eigen::Vector3d& r) { return o.regressor.torque({1.0, r}); };
    auto linear = o;
    linear.regressor.Q.setZero();
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d step = 0.5 * Eigen::Vector3d::Unit(i);
      linear.regressor.B.col(i) = torque(com + step) - torque(com - step);
    }
    linear.regressor.a = torque(com) - linear.regressor.B * com;
    expanded.add(linear);
  }
  check_same(likelihood(window.about(com)), likelihood(expanded));
  CHECK(window.count() == 30);
  CHECK(window.about(com).count() == 30);
  // It matters: about the origin the answer is another.
  CHECK((likelihood(window.about(Eigen::Vector3d::Zero())).BB - likelihood(expanded).BB).norm() >
        1e-3 * likelihood(expanded).BB.norm());
}

TEST_CASE("WindowStatistics: blocks count as their mean, as often as they have ticks, the unfinished one included",
          "[window_statistics]") {
  const unsigned seed = 141;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const auto ticks = motion(random, 25);
  const Eigen::Vector3d com(0.02, 0.03, 0.1);
  WindowStatistics<double, kDofs> window(10), means(1);
  for (std::size_t first = 0; first < ticks.size(); first += 10) {
    const std::size_t last = std::min(first + 10, ticks.size());
    PayloadObservation<double, kDofs> mean;
    for (std::size_t k = first; k < last; ++k) {
      window.add(ticks[k]);
      mean += ticks[k];
    }
    const double share = 1 / static_cast<double>(last - first);
    mean.tau *= share;
    mean.regressor.a *= share;
    mean.regressor.B *= share;
    mean.regressor.Q *= share;
    mean.direction *= share;
    mean.velocity *= share;
    for (std::size_t k = first; k < last; ++k) means.add(mean);
    check_same(likelihood(window.about(com)), likelihood(means.about(com)));
  }
  CHECK(window.count() == 25);
  window.clear();
  CHECK(window.count() == 0);
  for (const auto& o : ticks) window.add(o);
  check_same(likelihood(window.about(com)), likelihood(means.about(com)));
}

using Window = WindowStatistics<double, kDofs>;
static_assert(noexcept(std::declval<Window&>().add(std::declval<const PayloadObservation<double, kDofs>&>())));
static_assert(noexcept(std::declval<const Window&>().about(std::declval<const Eigen::Vector3d&>())));
static_assert(noexcept(std::declval<Window&>().clear()));

}  // namespace
