#include <cmath>
#include <limits>
#include <random>
#include <rme/tracking/bank/push_filter.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using oracle::Matrix;
using oracle::Vector;
constexpr int kDofs = 7;
constexpr double kRated = 3;
constexpr double kBlock = 0.02;  // [s]
template <typename Scalar>
using Filter = rme::bank::PushFilter<Scalar, kDofs>;
using Joints = rme::JointVector<double, kDofs>;
using Covariance = Filter<double>::Covariance;

/// Of a wrench that may be any.
Matrix any_wrench() {
  Vector deviation(6);
  deviation << 12, 12, 12, 1.5, 1.5, 1.5;
  return deviation.cwiseAbs2().asDiagonal();
}

/// An arm that is pushed: its Jacobian, and how well its torque is known without.
struct Pushed {
  explicit Pushed(unsigned seed) : random(seed) {
    jacobian = oracle::random_matrix(random, 6, kDofs);
    covariance =
        1e-4 * oracle::square(oracle::random_matrix(random, kDofs, kDofs)) + 1e-4 * Matrix::Identity(kDofs, kDofs);
  }
  /// Torque of a wrench, with noise.
  Joints torque(const rme::Vector6<double>& wrench) {
    return jacobian.transpose() * wrench + Joints(0.01 * oracle::random_matrix(random, kDofs, 1));
  }
  rme::Vector6<double> wrench() { return any_wrench().cwiseSqrt() * Vector(oracle::random_matrix(random, 6, 1)); }

  std::mt19937 random;
  rme::Jacobian<double, kDofs> jacobian;
  Covariance covariance;
};

TEST_CASE("PushFilter: blocks are as likely as the joint Gaussian of all of them says, of each story", "[push]") {
  // In three blocks the wrench may go on or be another one, twice: four stories, each a Gaussian over 21 torques.
  // The filter follows the likelier half after each block, which costs nothing where one of them is far likelier.
  const double p = 0.97;
  for (unsigned seed = 1; seed < 21; ++seed) {
    CAPTURE(seed);
    Pushed arm(seed);
    Filter<double> filter(kRated);
    const auto wrench = arm.wrench(), other = arm.wrench();
    const Joints y[3] = {arm.torque(wrench), arm.torque(wrench), arm.torque(seed % 2 == 0 ? wrench : other)};
    double filtered = 0;
    for (int k = 0; k < 3; ++k) filtered += filter.update(y[k], arm.covariance, arm.jacobian, kBlock, k == 0 ? 0 : p);
    const Matrix Jt = arm.jacobian.transpose();
    double sum = 0;
    for (int story = 0; story < 4; ++story) {
      // Covariance of w over the blocks: shared while it goes on, and 10 % more in each.
      Matrix W = Matrix::Zero(18, 18);
      const int begins[3] = {0, (story & 1) != 0 ? 0 : 1, 0};
      const int begin[3] = {0, begins[1], (story & 2) != 0 ? begins[1] : 2};
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
          if (begin[a] == begin[b])
            W.block(6 * a, 6 * b, 6, 6) = (1 + 0.1 * 0.1 * (std::min(a, b) - begin[a])) * any_wrench();
      Matrix S(21, 21);
      Vector all(21);
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b)
          S.block(7 * a, 7 * b, 7, 7) = oracle::product(oracle::product(Jt, W.block(6 * a, 6 * b, 6, 6)), arm.jacobian);
        S.block(7 * a, 7 * a, 7, 7) += arm.covariance;
        all.segment(7 * a, 7) = y[a];
      }
      double log_weight = 0;
      for (int k = 1; k < 3; ++k) log_weight += std::log((story & k) != 0 ? 0.9 * p : 1 - 0.9 * p);
      sum += std::exp(log_weight + oracle::log_normal(all, S));
    }
    CHECK(filtered == Approx(std::log(sum)).epsilon(1e-6));
  }
}

TEST_CASE("PushFilter: a wrench that lasts is paid for once in a second", "[push]") {
  Pushed arm(30);
  Filter<double> filter(kRated);
  const auto wrench = arm.wrench();
  double first = filter.update(arm.torque(wrench), arm.covariance, arm.jacobian, kBlock, 0);
  for (int k = 1; k < 120; ++k) {
    CAPTURE(k);
    const double later = filter.update(arm.torque(wrench), arm.covariance, arm.jacobian, kBlock, 0.97);
    if (k == 50 || k == 100)
      CHECK(later == Approx(first).margin(8));
    else
      CHECK(later > first + 5);
  }
  filter.forget();
  CHECK(filter.update(arm.torque(wrench), arm.covariance, arm.jacobian, kBlock, 0.97) == Approx(first).margin(8));
}

TEST_CASE("PushFilter: a wrench goes on for a whole second, and is new in the block after", "[push]") {
  // 32 blocks of 1/32 s make a second without rounding.
  Pushed arm(35);
  Filter<double> filter(kRated);
  const auto wrench = arm.wrench();
  const double first = filter.update(arm.torque(wrench), arm.covariance, arm.jacobian, 1.0 / 32, 0);
  for (int k = 1; k <= 33; ++k) {
    CAPTURE(k);
    const double later = filter.update(arm.torque(wrench), arm.covariance, arm.jacobian, 1.0 / 32, 0.97);
    if (k <= 32)
      CHECK(later > first + 5);
    else
      CHECK(later == Approx(first).margin(8));
  }
}

TEST_CASE("PushFilter: both stories count where the block cannot tell them apart", "[push]") {
  // Noise so large that the wrench hardly shows: each story's weight is what the chain says.
  for (const double p : {0.2, 0.6, 1.0}) {
    CAPTURE(p);
    Pushed arm(36);
    Filter<double> filter(kRated);
    const auto wrench = arm.wrench();
    const Matrix Jt = arm.jacobian.transpose();
    const Joints pushed = oracle::product(Jt, wrench);
    (void)filter.update(pushed, 1e-9 * Covariance::Identity(), arm.jacobian, kBlock, 0);
    const Covariance noise = 1e3 * oracle::congruence(Jt, any_wrench()) + 1e3 * Matrix::Identity(kDofs, kDofs);
    const Matrix on = noise + 0.1 * 0.1 * oracle::congruence(Jt, any_wrench()),
                 anew = noise + oracle::congruence(Jt, any_wrench());
    const double expected = std::log(0.9 * p * std::exp(oracle::log_normal(Joints::Zero(), on)) +
                                     (1 - 0.9 * p) * std::exp(oracle::log_normal(pushed, anew)));
    CHECK(filter.update(pushed, noise, arm.jacobian, kBlock, p) == Approx(expected).margin(1e-6));
  }
}

TEST_CASE("PushFilter: in float, torque that is known far better than a wrench is found all the same", "[push]") {
  // Seven torques of a wrench of six numbers: J^T W J is singular, and rounding makes some of its pivots negative.
  for (unsigned seed = 40; seed < 60; ++seed) {
    CAPTURE(seed);
    Pushed arm(seed);
    Filter<float> filter(static_cast<float>(kRated));
    const Joints y = oracle::product(Matrix(arm.jacobian.transpose()), arm.wrench());
    const float found = filter.update(y.cast<float>(), 1e-12f * Filter<float>::Covariance::Identity(),
                                      arm.jacobian.cast<float>(), static_cast<float>(kBlock), 0);
    CHECK(std::isfinite(found));
  }
}

TEST_CASE("PushFilter: in a longer block a hand changes more", "[push]") {
  for (const double factor : {1.0, 3.0}) {
    CAPTURE(factor);
    Pushed arm(31);
    Filter<double> filter(kRated);
    // A wrench that is known exactly, and then differs by a little.
    const auto wrench = arm.wrench();
    const Matrix Jt = arm.jacobian.transpose();
    const Joints pushed = oracle::product(Jt, wrench), then = pushed + 0.1 * arm.torque(arm.wrench());
    (void)filter.update(pushed, 1e-9 * Covariance::Identity(), arm.jacobian, kBlock, 0);
    const Matrix S = arm.covariance, on = S + factor * 0.1 * 0.1 * oracle::congruence(Jt, any_wrench()),
                 anew = S + oracle::congruence(Jt, any_wrench());
    const double expected = std::log(0.9 * std::exp(oracle::log_normal(then - pushed, on)) +
                                     0.1 * std::exp(oracle::log_normal(then, anew)));
    CHECK(filter.update(then, arm.covariance, arm.jacobian, factor * kBlock, 1) == Approx(expected).epsilon(1e-4));
  }
}

TEST_CASE("PushFilter: float agrees with double over a thousand blocks", "[push]") {
  Pushed arm(32);
  Filter<double> exact(kRated);
  Filter<float> filter(static_cast<float>(kRated));
  auto wrench = arm.wrench();
  for (int k = 0; k < 1000; ++k) {
    CAPTURE(k);
    if (k % 40 == 39) wrench = arm.wrench();
    const Joints y = arm.torque(wrench);
    const double a = exact.update(y, arm.covariance, arm.jacobian, kBlock, 0.97);
    const float b = filter.update(y.cast<float>(), arm.covariance.cast<float>(), arm.jacobian.cast<float>(),
                                  static_cast<float>(kBlock), 0.97f);
    // Of a wrench that is new, a float cannot tell torques that no wrench makes as finely.
    const double nats = k < 2 || k % 40 == 39 || k % 40 == 0 ? 2 : 0.2;
    CHECK(std::abs(static_cast<double>(b) - a) < nats);
  }
}

TEST_CASE("PushFilter: what no wrench can be asked of is minus infinity, and is forgotten", "[push]") {
  Pushed arm(33);
  Filter<double> filter(kRated), fresh(kRated);
  const Joints y = arm.torque(arm.wrench());
  (void)filter.update(y, arm.covariance, arm.jacobian, kBlock, 0);
  const double none = -std::numeric_limits<double>::infinity();
  CHECK(filter.update(y, Covariance(-1e6 * Covariance::Identity()), arm.jacobian, kBlock, 0.97) == none);
  filter.forget();
  CHECK(filter.update(y, arm.covariance, arm.jacobian, kBlock, 0.97) ==
        fresh.update(y, arm.covariance, arm.jacobian, kBlock, 0));
}

TEST_CASE("PushFilter: before the first block there is no wrench that could go on", "[push]") {
  Pushed arm(34);
  Filter<double> filter(kRated), fresh(kRated);
  const Joints y = arm.torque(arm.wrench());
  CHECK(filter.update(y, arm.covariance, arm.jacobian, kBlock, 0.97) ==
        fresh.update(y, arm.covariance, arm.jacobian, kBlock, 0));
}

}  // namespace
