#include <rme/inference/payload_statistics.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"
#include "support/random_events.hpp"

namespace {

using rme::Status;
using rme::testing::kDofs;

/// Literal log-likelihood, nuisances integrated out, from the full T x T covariance of each joint; no sums, no
/// Woodbury.
double dense_log_likelihood(const rme::testing::Event& event, const Eigen::Vector4d& theta) {
  const auto payload = rme::Payload<double>::from_vector(theta);
  const auto T = static_cast<Eigen::Index>(event.samples.size());
  double total = 0;
  for (int j = 0; j < kDofs; ++j) {
    const auto s = static_cast<std::size_t>(j);
    Eigen::VectorXd residual(T);
    Eigen::MatrixXd N(T, 3);
    for (Eigen::Index t = 0; t < T; ++t) {
      const auto& o = event.samples[static_cast<std::size_t>(t)];
      residual[t] = o.tau[j] - o.regressor.torque(payload)[j];
      N.row(t) << 1, -o.direction[j], -o.velocity[j];
    }
    residual -= N * event.nuisance.mean[s];
    const Eigen::MatrixXd covariance =
        Eigen::MatrixXd::Identity(T, T) / event.precision[j] + N * event.nuisance.covariance[s] * N.transpose();
    total -= 0.5 * residual.dot(oracle::solve(covariance, residual).col(0));
  }
  return total;
}

TEST_CASE("PayloadStatistics: the 15 numbers give the likelihood of the full covariance, offset and friction included",
          "[statistics]") {
  const unsigned seed = 30;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 40; ++k) {
    CAPTURE(k);
    const auto event = rme::testing::random_event(random, 30, k % 2 == 1);
    rme::PayloadLikelihood<double> likelihood;
    REQUIRE(event.statistics.likelihood(event.precision, event.nuisance, likelihood) == Status::Ok);
    for (const Eigen::Vector4d& theta :
         {event.truth, Eigen::Vector4d(0, 0, 0, 0), Eigen::Vector4d(0.4, 0.1, -0.1, 0.2)}) {
      const double dense = dense_log_likelihood(event, theta);
      CHECK(likelihood.log_likelihood(theta) == Approx(dense).epsilon(1e-9).margin(1e-6));
    }
  }
}

TEST_CASE("PayloadStatistics: the nuisances of an empty hand are those of Bayesian linear regression", "[statistics]") {
  const unsigned seed = 31;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const auto event = rme::testing::random_event(random, 40, true);
  rme::NuisanceGaussian<double, kDofs> posterior;
  REQUIRE(event.statistics.nuisance_posterior(event.precision, event.nuisance, posterior) == Status::Ok);
  for (int j = 0; j < kDofs; ++j) {
    CAPTURE(j);
    const auto s = static_cast<std::size_t>(j);
    Eigen::MatrixXd N(event.samples.size(), 3);
    Eigen::VectorXd y(event.samples.size());
    for (std::size_t t = 0; t < event.samples.size(); ++t) {
      const auto& o = event.samples[t];
      N.row(Eigen::Index(t)) << 1, -o.direction[j], -o.velocity[j];
      y[Eigen::Index(t)] = o.tau[j];
    }
    const Eigen::Matrix3d prior_precision = event.nuisance.covariance[s].inverse();
    const Eigen::Matrix3d precision = prior_precision + event.precision[j] * N.transpose() * N;
    const Eigen::Vector3d mean =
        oracle::solve(precision, prior_precision * event.nuisance.mean[s] + event.precision[j] * N.transpose() * y);
    CHECK((posterior.mean[s] - mean).norm() < 1e-8 * mean.norm());
    CHECK((posterior.covariance[s] * precision - Eigen::Matrix3d::Identity()).norm() < 1e-7);
  }
}

TEST_CASE("PayloadStatistics: a nuisance covariance that is not positive definite is refused", "[statistics]") {
  std::mt19937_64 random(32);
  auto event = rme::testing::random_event(random);
  event.nuisance.covariance[3](1, 1) = -1;
  rme::PayloadLikelihood<double> likelihood;
  likelihood.yy = 5;
  CHECK(event.statistics.likelihood(event.precision, event.nuisance, likelihood) == Status::NotPositiveDefinite);
  CHECK(likelihood.yy == 5);
  rme::NuisanceGaussian<double, kDofs> posterior;
  CHECK(event.statistics.nuisance_posterior(event.precision, event.nuisance, posterior) == Status::NotPositiveDefinite);
}

TEST_CASE("payload_regressor: m (a + B r) is J^T times the payload's wrench", "[regressor]") {
  const unsigned seed = 33;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const Eigen::Matrix3d R = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const rme::Jacobian<double, 7> J = rme::Jacobian<double, 7>::Random();
  const Eigen::Vector3d gravity = rme::testing::gaussian3(random);
  const rme::Payload<double> payload{1.3, {0.05, -0.02, 0.11}};
  const Eigen::VectorXd torque = rme::payload_regressor<double, 7>(J, R, gravity).torque(payload);
  CHECK((torque - J.transpose() * rme::payload_wrench(payload, R, gravity).vector()).norm() < 1e-14);
}

TEST_CASE("payload_regressor: a carried payload pushes back with Newton's and Euler's laws", "[regressor]") {
  // A rigid body of mass m, CoM p = R r and isotropic inertia m k^2 about it: force m (g - a_c), moment about the
  // flange p x m (g - a_c) - m k^2 alpha, with a_c = a + alpha x p + omega x (omega x p).
  const unsigned seed = 34;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(0.3 * k, rme::testing::gaussian3(random).normalized()).toRotationMatrix();
    const rme::Jacobian<double, 7> J = rme::Jacobian<double, 7>::Random();
    const Eigen::Vector3d g(0, 0, -9.81);
    const rme::FlangeMotion<double> motion{rme::testing::gaussian3(random), rme::testing::gaussian3(random),
                                           rme::testing::gaussian3(random)};
    const rme::Payload<double> payload{0.9, 0.1 * rme::testing::gaussian3(random)};
    const double gyration = 0.04;
    const Eigen::Vector3d p = R * payload.com;
    const Eigen::Vector3d a_c = motion.linear_acceleration + motion.angular_acceleration.cross(p) +
                                motion.angular_velocity.cross(motion.angular_velocity.cross(p));
    const Eigen::Vector3d force = payload.mass * (g - a_c);
    const Eigen::Vector3d moment = p.cross(force) - payload.mass * gyration * gyration * motion.angular_acceleration;
    const Eigen::VectorXd expected = J.transpose() * rme::Wrench<double>{force, moment}.vector();
    const auto regressor = rme::payload_regressor<double, 7>(J, R, g, motion, gyration);
    CHECK((regressor.torque(payload) - expected).norm() < 1e-12 * expected.norm());
  }
}

}  // namespace
