#include <cmath>
#include <limits>
#include <rme/inference/evidence.hpp>

#include "inference/likelihoods.hpp"
#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using rme::Status;
using rme::testing::Event;
using rme::testing::kDofs;
using Jacobian = rme::Jacobian<double, kDofs>;
using Joints = rme::PayloadStatistics<double, kDofs>::Marginals;

/// The log density of all torques of all joints at once, y ~ N(payload torque + N mu, C) with the full covariance C of
/// joints x samples: white noise, each joint's nuisances, and a constant wrench of covariance S through J. Without the
/// wrench, S = 0.
double dense_log_density(const Event& event, const rme::Payload<double>& payload, const Jacobian& J,
                         const Eigen::Matrix<double, 6, 6>& S) {
  const auto T = static_cast<Eigen::Index>(event.samples.size());
  Eigen::VectorXd residual(kDofs * T);
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(kDofs * T, kDofs * T);
  for (Eigen::Index j = 0; j < kDofs; ++j) {
    const auto s = static_cast<std::size_t>(j);
    Eigen::MatrixXd N(T, 3);
    for (Eigen::Index t = 0; t < T; ++t) {
      const auto& o = event.samples[static_cast<std::size_t>(t)];
      N.row(t) << 1, -o.direction[j], -o.velocity[j];
      residual[j * T + t] = o.tau[j] - o.regressor.torque(payload)[j] - N.row(t).dot(event.nuisance.mean[s]);
    }
    C.block(j * T, j * T, T, T) =
        Eigen::MatrixXd::Identity(T, T) / event.precision[j] + N * event.nuisance.covariance[s] * N.transpose();
    for (Eigen::Index i = 0; i < kDofs; ++i)
      C.block(j * T, i * T, T, T).array() += J.col(j).dot(S * J.col(i));  // the same at all times
  }
  return oracle::log_normal(residual, C);
}

/// What the library leaves out on purpose, since it is the same for every hypothesis: the white noise's determinant.
double left_out(const Event& event) {
  return 0.5 * static_cast<double>(event.samples.size()) * event.precision.array().log().sum();
}

TEST_CASE("push_log_evidence: equals the density under the full covariance of all joints and samples", "[evidence]") {
  const unsigned seed = 100;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    const Event event = rme::testing::random_event(random, 15, k % 2 == 1);
    const Jacobian J = Jacobian::Random();
    const rme::PushPrior prior{5.0 + k, 0.5 + 0.1 * k};
    rme::Vector6<double> variance;
    variance << Eigen::Vector3d::Constant(prior.force * prior.force),
        Eigen::Vector3d::Constant(prior.moment * prior.moment);
    for (const rme::Payload<double>& payload :
         {rme::Payload<double>(), rme::Payload<double>::from_vector(event.truth)}) {
      double push = 0;
      Joints joints;
      REQUIRE(event.statistics.marginals(event.precision, event.nuisance, joints) == Status::Ok);
      REQUIRE(rme::push_log_evidence<double, kDofs>(joints, payload, J, prior, push) == Status::Ok);
      const double still = rme::payload_log_evidence(rme::testing::likelihood_of(event), payload);
      const double dense_push = dense_log_density(event, payload, J, variance.asDiagonal());
      const double dense_still = dense_log_density(event, payload, J, Eigen::Matrix<double, 6, 6>::Zero());
      // Sums of squares of up to 1e5 with 1e-16 of rounding, through matrices of condition 1e6.
      CHECK(push + left_out(event) == Approx(dense_push).epsilon(1e-9).margin(1e-6));
      CHECK(still + left_out(event) == Approx(dense_still).epsilon(1e-9).margin(1e-6));
      CHECK(push - still == Approx(dense_push - dense_still).epsilon(1e-8).margin(1e-6));
    }
  }
}

TEST_CASE("push_log_evidence: numbers that overflow are refused", "[evidence]") {
  std::mt19937_64 random(101);
  const Event event = rme::testing::random_event(random);
  Joints joints;
  REQUIRE(event.statistics.marginals(event.precision, event.nuisance, joints) == Status::Ok);
  joints[3].products(5, 5) = std::numeric_limits<double>::quiet_NaN();
  double evidence = 7;
  CHECK(rme::push_log_evidence<double, kDofs>(joints, {}, Jacobian::Random(), {}, evidence) ==
        Status::NotPositiveDefinite);
  CHECK(evidence == 7);
}

static_assert(noexcept(rme::push_log_evidence<double, kDofs>(
    std::declval<const Joints&>(), std::declval<const rme::Payload<double>&>(), std::declval<const Jacobian&>(),
    std::declval<const rme::PushPrior&>(), std::declval<double&>())));

}  // namespace
