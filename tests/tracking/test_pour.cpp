#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>
#include <rme/tracking/pour.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"
#include "tracking/joint_scene.hpp"
#include "tracking/random_star.hpp"

namespace {

using oracle::Matrix;
using oracle::Vector;
using rme::kInertial;
using rme::kPayload;
using rme::kPoured;
using rme::kShared;
constexpr int kDofs = 2;
constexpr double kRated = 3, kBlock = 0.02;
using Star = rme::StarGaussian<double, kDofs>;
using Pour = rme::Pour<double, kDofs>;

const rme::PayloadPrior<double>& prior() {
  static const auto out = rme::PayloadPrior<double>::of(kRated);
  return out;
}

/// Holds `mass`, known to a gram, with its centre of mass in the prior's place.
Star holding(double mass) {
  Star star;
  rme::InertialVector<double> mean = rme::InertialVector<double>::Zero();
  mean[0] = mass;
  mean.segment<3>(1) = mass * prior().com_mean;
  star.draw_payload(mean, 1e-3 * rme::InertialMatrix<double>::Identity());
  return star;
}

/// A block in which joint j weighs the payload, on a lever that changes.
rme::JointObservation<double> weighing(double mass, int k, double noise) {
  rme::JointObservation<double> o;
  o.h.setZero();
  o.c.setZero();
  o.h[kPayload] = -9.81 * (0.3 + 0.1 * std::sin(0.7 * k));
  o.h[kPayload + 3] = 9.81 * std::cos(0.3 * k);
  for (int i = 0; i < 4; ++i) o.h[kPoured + i] = o.h[kPayload + i];
  o.torque = o.h[kPayload] * mass + o.h[kPayload + 3] * mass * prior().com_mean[2];
  o.noise = noise * noise;
  return o;
}

TEST_CASE("Pour: payload and rate are what one dense filter over both makes of random torques", "[pour]") {
  // A Gaussian over (x, r), r the rate of (m, m r): r decays in 3 s towards zero, with a noise that keeps its spread;
  // (m, m r) moves by r dt, and the flow's own noise is what flows in 0.02 s at its spread.
  const unsigned seed = 570;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (const double mass : {0.0, 0.8}) {
    CAPTURE(mass);
    Star star = mass > 0 ? holding(mass) : Star();
    const auto centre = [&]() -> rme::Vector3<double> {
      if (star.mass() > 0.007 * kRated) return star.payload_mean().segment<3>(1) / star.mass();
      return prior().com_mean;
    };
    // Along the payload's own (m, m r), and about it; an empty hand takes up anything.
    const auto stationary = [&] {
      const double sigma = 0.03 * kRated;
      rme::Vector4<double> along(1, 0, 0, 0);
      along.tail<3>() = centre();
      rme::Matrix4<double> out = sigma * sigma * along * along.transpose();
      for (int i = 0; i < 3; ++i) out(1 + i, 1 + i) += std::pow((mass > 0 ? 0.4 : 1) * prior().com_std[i] * sigma, 2);
      return out;
    };
    Vector mean = Vector::Zero(kShared + 4);
    Matrix P = Matrix::Zero(kShared + 4, kShared + 4);
    mean.head(kShared) = star.mean();
    P.topLeftCorner(kShared, kShared) = star.covariance();
    P.bottomRightCorner(4, 4) = stationary();
    Pour pour;
    pour.begin(star, prior(), kRated, mass > 0 ? rme::PourKind::More : rme::PourKind::TakenUp);
    for (int k = 0; k < 40; ++k) {
      CAPTURE(k);
      const double keep = std::exp(-kBlock / 3);
      const rme::Matrix4<double> noise = stationary();
      Matrix T = Matrix::Identity(kShared + 4, kShared + 4);
      T.bottomRightCorner(4, 4) *= keep;
      T.block<4, 4>(kPoured, kShared) = kBlock * keep * rme::Matrix4<double>::Identity();
      mean = oracle::product(T, mean);
      // An error of the payload's own centre is one of what is poured as well: m r grows with m.
      const double before = mean[kPayload];
      const double share = kBlock * mean[kShared] * before / (before * before + P(kPayload, kPayload));
      for (int i = 0; mass > 0 && i < 3; ++i) {
        T(kPoured + 1 + i, kPayload + 1 + i) = share;
        T(kPoured + 1 + i, kPayload) = -share * centre()[i];
      }
      P = oracle::congruence(T, P);
      // The rate's new noise already moves the payload in this block.
      Matrix G = Matrix::Zero(kShared + 4, 4);
      G.block<4, 4>(kPoured, 0) = kBlock * rme::Matrix4<double>::Identity();
      G.bottomRows(4).setIdentity();
      P += oracle::congruence(G, (1 - keep * keep) * noise);
      P.block<4, 4>(kPoured, kPoured) += kBlock * 0.02 * noise;
      pour.predict(star, kBlock, prior(), kRated);
      for (int j = 0; j < kDofs; ++j) {
        rme::JointObservation<double> o{0.1 * oracle::random_matrix(random, 1, 1)(0, 0),
                                        oracle::random_matrix(random, kShared, 1),
                                        rme::JointNuisanceVector<double>::Zero(), 0.01};
        o.h.head<rme::kArmShared>().setZero();
        Vector row = Vector::Zero(kShared + 4);
        row.head(kShared) = o.h;
        const Vector cross = P * row;
        const double variance = row.dot(cross) + o.noise;
        mean += cross * (o.torque - row.dot(mean)) / variance;
        P -= cross * cross.transpose() / variance;
        const auto p = star.predict(j, o);
        pour.observe(star, p);
        star.observe(j, p);
      }
      CHECK(std::abs(pour.rate() - mean[kShared]) < 1e-9);
      CHECK((star.mean() - mean.head(kShared)).norm() < 1e-9);
      CHECK((star.covariance() - P.topLeftCorner(kShared, kShared)).norm() < 1e-9 * P.norm());
      if (std::abs(star.mass()) < 0.022 && std::abs(star.mass()) > 0.02) break;  // where the rule changes
    }
    // Each entry of the inertia of what was poured is unknown by E[r^2] = 1 + 0.36 + 0.36 + 0.49 dm^2 times its mass.
    const double poured = mean[kPoured] * mean[kPoured] + P(kPoured, kPoured);
    const Matrix inertia =
        P.block<6, 6>(kPayload + 4, kPayload + 4) + 0.0221 * 0.0221 * poured * Matrix::Identity(6, 6);
    CHECK((pour.payload_after(star, 0).covariance.bottomRightCorner<6, 6>() - inertia).norm() < 1e-9 * inertia.norm());
    pour.end(star);
    CHECK((star.payload_covariance().bottomRightCorner<6, 6>() - inertia).norm() < 1e-9 * inertia.norm());
  }
}

TEST_CASE("Pour: what has been poured becomes part of the payload when it ends, with the moments of every pair",
          "[pour]") {
  using namespace rme::testing;
  using Any = rme::StarGaussian<double, kJoints>;
  const unsigned seed = 516;
  CAPTURE(seed);
  std::mt19937 random(seed);
  Matrix settled = Matrix::Identity(kAll, kAll);
  for (int i = 0; i < 4; ++i) {
    settled(kPayload + i, kPoured + i) = 1;
    settled(kPoured + i, kPoured + i) = 0;
  }
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    Any star = random_star(random);
    rme::Pour<double, kJoints> pour;
    const Dense before = dense(star);
    CHECK(star.mass() == star.mean()[kPayload] + star.mean()[kPoured]);
    pour.end(star);
    CHECK(star.last() == Any::Last::Nothing);
    CHECK(difference(dense(star), mapped(settled, before)) < 1e-9);
    const Dense ended = dense(star);
    pour.end(star);
    CHECK(difference(dense(star), ended) == 0);
  }
}

TEST_CASE("Pour: what is held later is what the rate makes of it, and less certain by what is not known of the rate",
          "[pour]") {
  const unsigned seed = 572;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Star star = holding(0.5);
  Pour pour;
  pour.begin(star, prior(), kRated, rme::PourKind::Quick);
  for (int k = 0; k < 5; ++k) {
    pour.predict(star, kBlock, prior(), kRated);
    for (int j = 0; j < kDofs; ++j) {
      auto o = weighing(0.5 + 0.04 * k, 2 * k + j, 0.02);
      o.torque += 0.02 * normal(random);
      const auto p = star.predict(j, o);
      pour.observe(star, p);
      star.observe(j, p);
    }
  }
  // The mean is linear in the time, and so are its differences.
  const auto now = pour.payload_after(star, 0);
  CHECK((now.mean - star.payload_mean()).norm() < 1e-12);
  CHECK((now.covariance - star.payload_covariance()).topLeftCorner<4, 4>().norm() < 1e-12);
  const auto before = pour.payload_after(star, -0.1), after = pour.payload_after(star, 0.1);
  CHECK(after.mean[0] == Approx(star.mass() + 0.1 * pour.rate()));
  CHECK((after.mean + before.mean - 2 * now.mean).norm() < 1e-12);
  for (int i = 4; i < kInertial; ++i) CHECK(after.mean[i] == now.mean[i]);
  // The filter's own time update adds the same, and the flow's noise, 0.002 s of the spread.
  Star moved = star;
  Pour goes_on = pour;
  constexpr double kShort = 1e-5;
  goes_on.predict(moved, kShort, prior(), kRated);
  const rme::InertialMatrix<double> drift = moved.payload_covariance() - star.payload_covariance(),
                                    ahead = pour.payload_after(star, kShort).covariance - now.covariance;
  const double flow = kShort * 0.002 * kRated * kRated;  // of the mass; about it, 0.7 of the prior's spread of r
  CHECK(drift(0, 0) - ahead(0, 0) == Approx(flow).epsilon(1e-3));
  CHECK(ahead(0, 0) > 0);
  CHECK(Eigen::SelfAdjointEigenSolver<Matrix>(after.covariance).eigenvalues().minCoeff() > -1e-12);
}

TEST_CASE("Pour: a steady flow is followed in mass and rate, into an empty hand, into a held thing and out of it",
          "[pour]") {
  const unsigned seed = 571;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (const auto& [start, rate] : {std::pair(0.0, 0.1), std::pair(0.5, 0.05), std::pair(1.0, -0.08)}) {
    CAPTURE(start, rate);
    Star star = start > 0 ? holding(start) : Star();
    Pour pour;
    pour.begin(star, prior(), kRated, rme::PourKind::More);
    double mass = start;
    for (int k = 0; k < 250; ++k) {
      mass += rate * kBlock;
      pour.predict(star, kBlock, prior(), kRated);
      for (int j = 0; j < kDofs; ++j) {
        auto o = weighing(mass, 2 * k + j, 0.02);
        o.torque += 0.02 * normal(random);
        const auto p = star.predict(j, o);
        pour.observe(star, p);
        star.observe(j, p);
      }
    }
    REQUIRE(star.finite());
    CHECK(star.mass() == Approx(mass).margin(0.01));
    CHECK(std::abs(star.mass() - mass) < 4 * std::sqrt(star.mass_variance()));
    CHECK(pour.rate() == Approx(rate).margin(0.025));
  }
}

TEST_CASE("Pour: more of what is held shares its centre of mass, and what is not known of it", "[pour]") {
  // A cup of which x is hardly known is filled; only its weight shows. So x is known no better at the end.
  Star star = holding(0.4);
  auto phi = star.mean();
  rme::SharedMatrix<double> factor = star.factor();
  phi[kPayload + 1] = 0.4 * 0.02;
  factor.row(kPayload + 1).setZero();
  factor(kPayload + 1, kPayload + 1) = 0.4 * 0.05;
  star.set_shared(phi, factor);
  Pour pour;
  pour.begin(star, prior(), kRated, rme::PourKind::More);
  for (int k = 1; k <= 500; ++k) {
    pour.predict(star, kBlock, prior(), kRated);
    rme::JointObservation<double> o{0.4 + 0.08 * k * kBlock, rme::SharedVector<double>::Zero(),
                                    rme::JointNuisanceVector<double>::Zero(), 1e-6};
    o.h[kPayload] = o.h[kPoured] = 1;
    const auto p = star.predict(0, o);
    pour.observe(star, p);
    star.observe(0, p);
  }
  const double mass = star.mass(), deviation = std::sqrt(star.payload_covariance()(1, 1)) / mass;
  REQUIRE(mass == Approx(1.2).epsilon(0.01));
  CHECK(star.payload_mean()[1] / mass == Approx(0.02).epsilon(0.05));
  CHECK(deviation == Approx(0.05).epsilon(0.1));
}

TEST_CASE("Pour: a payload that was hidden by the nuisances changes no prediction, wherever its centre of mass is",
          "[pour]") {
  rme::testing::joints::Scene scene(rme::Sensing::JointFriction);
  scene.block({0.3, -0.3});
  auto star = scene.star;
  Pour::suppose_hidden(scene.model, star, prior());
  const rme::InertialMatrix<double> hidden = star.payload_covariance();
  double precision = 0;
  for (int j = 0; j < kDofs; ++j) {
    const auto o = scene.model.observation(j, {});
    const auto before = scene.star.predict(j, o), after = star.predict(j, o);
    const double torque = o.h[kPayload] + 0.1 * o.h[kPayload + 3];
    const auto V = scene.star.nuisance_covariance(j);
    double able = 0;
    for (int n = 0; n < rme::kJointNuisances; ++n) able += V(n, n) * o.c[n] * o.c[n];
    precision += torque * torque / (able + o.noise);
    CHECK(after.innovation == Approx(before.innovation));
    // What the noise would have let through of any such payload, and what its inertia takes.
    Vector through = o.h.segment(kPayload, rme::kInertial);
    through.head(4) *= o.noise / (able + o.noise);
    CHECK(after.variance == Approx(before.variance + through.dot(hidden * through)));
  }
  REQUIRE(precision > 0);
  const double square = 9 / precision;
  CHECK(star.mass_variance() == Approx(square));
  // The centre is unknown as well, as of a payload of half this size.
  const rme::Vector3<double> spread(0.06, 0.06, 0.07);
  for (int i = 0; i < 3; ++i)
    CHECK(hidden(1 + i, 1 + i) == Approx(square * (spread[i] * spread[i] / 4 + (i == 2 ? 0.01 : 0))));
  CHECK(hidden(4, 4) == Approx(square / 4 * 0.0221 * 0.0221));
}

}  // namespace
