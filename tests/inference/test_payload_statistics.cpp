#include <cmath>
#include <random>
#include <rme/inference/payload_statistics.hpp>

#include "support/catch.hpp"
#include "support/random_events.hpp"

namespace {

using rme::testing::kDofs;

TEST_CASE("PayloadStatistics: the 15 numbers give the Gaussian density of all residuals", "[statistics]") {
  const unsigned seed = 30;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 40; ++k) {
    CAPTURE(k);
    const auto event = rme::testing::random_event(random, 30, k % 2 == 1);
    const auto likelihood = event.statistics.likelihood(event.precision);
    for (const Eigen::Vector4d& theta :
         {event.truth, Eigen::Vector4d(0, 0, 0, 0), Eigen::Vector4d(0.4, 0.1, -0.1, 0.2)}) {
      const auto payload = rme::Payload<double>::from_vector(theta);
      double expected = 0;
      for (const auto& o : event.samples) {
        const auto torque = o.regressor.torque(payload);
        for (int j = 0; j < kDofs; ++j) expected -= 0.5 * event.precision[j] * std::pow(o.tau[j] - torque[j], 2);
      }
      CHECK(likelihood.log_likelihood(theta) == Approx(expected).epsilon(1e-9).margin(1e-6));
    }
  }
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

}  // namespace
