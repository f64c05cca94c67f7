#include <cmath>
#include <random>
#include <vector>

#include "published/changing_hand.hpp"
#include "published/literal_pipeline.hpp"
#include "published/pipelines.hpp"
#include "support/catch.hpp"
#include "support/linear_algebra.hpp"
#include "support/random_events.hpp"

namespace {

using rme::InputFrame;
using rme::Status;
using rme::testing::cast;
using rme::testing::changing_hand;
using rme::testing::LiteralPipeline;
using rme::testing::random_network;
using Ticks = std::vector<rme::Proprioception<double, 7>>;

/// Plays each `stride`-th of 1,000 ticks a second to both; returns how many estimates they made.
template <typename Scalar, typename Network>
int expect_equal(const Network& network, const Ticks& ticks, int stride, const rme::testing::LiteralRate& rate) {
  constexpr std::uint64_t kSeed = 77;
  const double dt = 0.001 * stride;
  rme::PublishedPipeline<Scalar, 7, Network> pipeline(dt, network, {}, kSeed);
  LiteralPipeline<Scalar, 7, Network> literal(network, kSeed, rate);
  for (std::size_t k = 0; k < ticks.size() / std::size_t(stride); ++k) {
    CAPTURE(k);
    const auto tick = cast<Scalar>(ticks[std::size_t(stride) * k]);
    REQUIRE(pipeline.update(tick) == Status::Ok);
    literal.update(tick);
    const auto& state = pipeline.state();
    REQUIRE(state.estimates == literal.estimates().size());
    if (literal.estimates().empty() || literal.estimates().back().made != k + 1) continue;
    const auto& expected = literal.estimates().back();
    CHECK(state.detected_at == Approx(double(expected.detected) * dt));
    CHECK(state.estimated_at == Approx(double(expected.made) * dt));
    CHECK(state.iterations == expected.steps);
    CHECK(state.outcome == (expected.stopped ? Status::Ok : Status::NotConverged));
    // No tolerance, and none would do: rounding errors grow until the inference ends elsewhere.
    CHECK(state.posterior.mean == expected.mean);
    CHECK(state.posterior.covariance == rme::Matrix4<Scalar>(expected.variance.asDiagonal()));
  }
  return int(pipeline.state().estimates);
}

TEMPLATE_TEST_CASE("PublishedPipeline: equals a literal transcription of the paper to the last bit", "[published]",
                   double, float) {
  const unsigned seed = 501;
  CAPTURE(seed);
  const Ticks ticks = changing_hand(seed, {1.1, {0.05, 0.02, 0.13}}, {1.7, {-0.02, 0.03, 0.1}});
  const auto rate = rme::testing::literal_1khz();
  SECTION("with a network in world axes, as published") {
    CHECK(expect_equal<TestType>(*random_network(InputFrame::World), ticks, 1, rate) >= 5);
  }
  SECTION("with a network in end-effector axes") {
    CHECK(expect_equal<TestType>(*random_network(InputFrame::EndEffector), ticks, 1, rate) >= 5);
  }
  SECTION("without a network, around zero") {
    CHECK(expect_equal<TestType>(rme::FixedGuess<TestType>(), ticks, 1, rate) >= 5);
  }
}

TEST_CASE("PublishedPipeline: at 250 Hz it is the same, all that the paper counts in samples taken as time",
          "[published]") {
  const unsigned seed = 502;
  CAPTURE(seed);
  const Ticks ticks = changing_hand(seed, {0.9, {0.02, -0.03, 0.1}}, {1.4, {0.03, 0.01, 0.12}});
  CHECK(expect_equal<double>(*random_network(InputFrame::World), ticks, 4, rme::testing::literal_250hz()) >= 5);
}

/// What a network may say: 1 kg, and the moment of the newest pseudo-wrench that it sees in 0.1 m.
struct EchoNetwork {
  using Window = Eigen::Matrix<double, 20, 6>;
  using Output = Eigen::Vector4d;
  InputFrame frame() const noexcept { return InputFrame::World; }
  Status forward(const Window& window, Output& out) const noexcept {
    out << 1, 0.1 * window.row(19).tail<3>().transpose();
    return Status::Ok;
  }
};

TEST_CASE(
    "PublishedPipeline: its first steps are those up the density of all residuals, in scalars, with settings of "
    "its own",
    "[published]") {
  // No sums, no linear algebra: every step passes over 60 samples and 7 joints. An arm on a tilted wall, which turns.
  const unsigned seed = 503;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, 0.01);
  rme::PublishedPipelineConfig<double> config;
  config.gravity << 3, -2, 9;
  config.collection = 0.237;  // 4 * 59 + 1 samples: each fourth, ends included
  config.likelihood.samples = 60;
  config.likelihood.range_share = 0.4;
  config.likelihood.least_sigma = 0.07;
  config.standard_deviation << 0.4, 0.03, 0.05, 0.06;
  config.damping = 0.05;
  config.inference.max_steps = 20;  // rounding errors have no time to grow
  const EchoNetwork network;
  rme::PublishedPipeline<double, 7, EchoNetwork> pipeline(0.001, network, config, 9);
  const auto base = rme::testing::random_pose(random);
  Ticks ticks;
  while (pipeline.state().estimates == 0) {
    REQUIRE(ticks.size() < 2000);
    rme::Proprioception<double, 7> tick;
    const double t = 0.001 * double(ticks.size());
    tick.jacobian = (1 + 0.01 * std::sin(5 * t)) * base.jacobian;
    tick.rotation = Eigen::AngleAxisd(0.1 * t, Eigen::Vector3d::UnitX()).toRotationMatrix() * base.rotation;
    const double mass = t < 0.7 ? 0 : 0.8;
    const Eigen::Vector3d weight = mass * config.gravity, lever = tick.rotation * Eigen::Vector3d(0.03, -0.02, 0.1);
    Eigen::Matrix<double, 6, 1> wrench;
    wrench << weight, lever.cross(weight);
    tick.tau_ext = tick.jacobian.transpose() * wrench;
    for (int j = 0; j < 7; ++j) tick.tau_ext[j] += noise(random);
    ticks.push_back(tick);
    REQUIRE(pipeline.update(tick) == Status::Ok);
  }
  CHECK(pipeline.state().outcome == Status::NotConverged);
  CHECK(pipeline.state().iterations == 20);

  const auto& newest = ticks.back();
  const oracle::Matrix damped = oracle::square(newest.jacobian) + 0.05 * oracle::Matrix::Identity(6, 6);
  const oracle::Vector pseudo_wrench = oracle::solve(damped, oracle::product(newest.jacobian, newest.tau_ext));
  const double prior[] = {1, 0.1 * pseudo_wrench[3], 0.1 * pseudo_wrench[4], 0.1 * pseudo_wrench[5]};
  const double prior_deviation[] = {0.4, 0.03, 0.05, 0.06};
  double sigma[7];
  for (int j = 0; j < 7; ++j) {
    double least = 1e9, most = -1e9;
    for (std::size_t k = ticks.size() - 237; k < ticks.size(); k += 4) {
      least = std::min(least, ticks[k].tau_ext[j]);
      most = std::max(most, ticks[k].tau_ext[j]);
    }
    sigma[j] = std::max(0.4 * (most - least), 0.07);
  }
  double x[8], m[8] = {}, v[8] = {};
  const double start[] = {1, 0.05, 0.05, 0.1};
  for (int i = 0; i < 4; ++i) x[i] = prior[i], x[4 + i] = std::log(start[i]);
  std::mt19937_64 draws(9);
  std::normal_distribution<double> normal;
  for (int step = 1; step <= 20; ++step) {
    double epsilon[4], theta[4], g[8] = {};
    for (int i = 0; i < 4; ++i) {
      epsilon[i] = normal(draws);
      theta[i] = x[i] + std::exp(x[4 + i]) * epsilon[i];
    }
    for (std::size_t k = ticks.size() - 237; k < ticks.size(); k += 4) {
      const auto& J = ticks[k].jacobian;
      const auto& R = ticks[k].rotation;
      for (int j = 0; j < 7; ++j) {
        const Eigen::Vector3d force = J.col(j).head<3>(), moment = J.col(j).tail<3>();
        double slope[4] = {force.dot(config.gravity)};  // of the joint's torque, by each parameter
        for (int i = 0; i < 3; ++i) {
          const double per_mass = moment.dot(R.col(i).cross(config.gravity));
          slope[0] += per_mass * theta[1 + i];
          slope[1 + i] = theta[0] * per_mass;
        }
        const double residual = ticks[k].tau_ext[j] - theta[0] * slope[0];
        for (int i = 0; i < 4; ++i) g[i] += residual * slope[i] / (sigma[j] * sigma[j]);
      }
    }
    double norm = 0;
    for (int i = 0; i < 4; ++i) {
      g[i] -= (theta[i] - prior[i]) / (prior_deviation[i] * prior_deviation[i]);
      g[4 + i] = g[i] * std::exp(x[4 + i]) * epsilon[i] + 1;
      norm += g[i] * g[i] + g[4 + i] * g[4 + i];
    }
    for (int i = 0; i < 8; ++i) {
      g[i] /= std::max(std::sqrt(norm), 1.0);
      m[i] = 0.9 * m[i] + 0.1 * g[i];
      v[i] = 0.999 * v[i] + 0.001 * g[i] * g[i];
      x[i] += 0.025 * (m[i] / (1 - std::pow(0.9, step))) / (std::sqrt(v[i] / (1 - std::pow(0.999, step))) + 1e-8);
    }
  }
  const auto& posterior = pipeline.state().posterior;
  for (int i = 0; i < 4; ++i) {
    CHECK(posterior.mean[i] == Approx(x[i]).epsilon(1e-7).margin(1e-8));
    CHECK(posterior.standard_deviation()[i] == Approx(std::exp(x[4 + i])).epsilon(1e-7));
  }
  const Eigen::Vector3d weight = x[0] * config.gravity;
  const Eigen::Vector3d lever = newest.rotation * Eigen::Vector3d(x[1], x[2], x[3]), moment = lever.cross(weight);
  const auto torque = pipeline.compensation(newest.jacobian, newest.rotation);
  for (int j = 0; j < 7; ++j) {
    const auto column = newest.jacobian.col(j);
    CHECK(torque[j] == Approx(-column.head<3>().dot(weight) - column.tail<3>().dot(moment)).epsilon(1e-6));
  }
}

}  // namespace
