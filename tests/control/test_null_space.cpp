#include <cmath>
#include <rme/control/null_space.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using Jacobian7 = rme::Jacobian<double, 7>;

/// J = U diag(sigma) V^T: singular values, null space and pseudo-inverse are known by construction.
struct KnownJacobian {
  oracle::Matrix U, V;
  Eigen::Matrix<double, 6, 1> sigma;
  KnownJacobian(std::mt19937& random, int dofs, double smallest)
      : U(oracle::random_rotation(random, 6)), V(oracle::random_rotation(random, dofs)) {
    sigma << 1.7, 1.2, 0.9, 0.6, 0.4, smallest;
  }
  oracle::Matrix matrix() const { return oracle::composed(U, sigma, V); }
};

TEST_CASE("NullSpace: away from singular poses the projector is exact", "[null-space]") {
  const unsigned seed = 4101;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 200; ++i) {
    const KnownJacobian known(random, 7, 0.1);
    rme::NullSpace<double, 7> null_space;
    REQUIRE(null_space.update(Jacobian7(known.matrix())) == rme::Status::Ok);
    const oracle::Matrix expected = known.V.col(6) * known.V.col(6).transpose();
    REQUIRE((null_space.projector() - expected).norm() < 1e-13);
    REQUIRE(null_space.damping() == 0);
    REQUIRE(null_space.clearance() == Approx(1 / known.sigma.cwiseInverse().norm()).epsilon(1e-12));
  }
}

TEST_CASE("NullSpace: six joints have none, nine have three dimensions of it", "[null-space]") {
  const unsigned seed = 4102;
  CAPTURE(seed);
  std::mt19937 random(seed);
  rme::NullSpace<double, 6> six;
  REQUIRE(six.update(rme::Jacobian<double, 6>(KnownJacobian(random, 6, 0.1).matrix())) == rme::Status::Ok);
  CHECK(six.projector().isZero(0));
  rme::NullSpace<double, 9> nine;
  const KnownJacobian known(random, 9, 0.1);
  REQUIRE(nine.update(rme::Jacobian<double, 9>(known.matrix())) == rme::Status::Ok);
  CHECK((nine.projector() - known.V.rightCols(3) * known.V.rightCols(3).transpose()).norm() < 1e-13);
}

TEMPLATE_TEST_CASE("NullSpace: the damped projector leaks at most lambda / 2 and stays within [0, 1]", "[null-space]",
                   float, double) {
  using Scalar = TestType;
  const unsigned seed = 4103;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const Scalar rounding = 50 * Eigen::NumTraits<Scalar>::epsilon();
  for (const double smallest : {0.019, 0.01, 1e-3, 1e-6, 0.0}) {
    CAPTURE(smallest);
    const KnownJacobian known(random, 7, smallest);
    const rme::Jacobian<Scalar, 7> J = known.matrix().template cast<Scalar>();
    rme::NullSpace<Scalar, 7> null_space;
    REQUIRE(null_space.update(J) == rme::Status::Ok);
    REQUIRE(null_space.projector().allFinite());
    const Scalar lambda = null_space.damping();
    CHECK(lambda > 0);
    // The documented law, with the clearance from the singular values; |J^+|_F is infinite at sigma_6 = 0.
    const double ratio = smallest > 0 ? 1 / known.sigma.cwiseInverse().norm() / 0.02 : 0;
    CHECK(lambda == Approx(0.02 * (1 - ratio * ratio)).epsilon(1e-4));
    const oracle::Vector eigenvalues = oracle::eigenvalues(null_space.projector().template cast<double>());
    CHECK(eigenvalues[0] > -rounding);
    CHECK(eigenvalues[6] < 1 + rounding);
    const rme::Jacobian<Scalar, 7> leak = J * null_space.projector();
    CHECK(oracle::singular_values(leak.template cast<double>())[0] <= lambda / 2 + rounding);
    // By the SVD the eigenvalue of direction i is lambda^2 / (sigma_i^2 + lambda^2), and 1 in the null space. In float,
    // the squares of J J^T + lambda^2 I resolve lambda^2 = 4e-4 to a part in 4e-4 / (3 * 1e-7).
    const double l2 = static_cast<double>(lambda) * static_cast<double>(lambda);
    oracle::Vector values = oracle::Vector::Ones(7);
    for (int k = 0; k < 6; ++k) values[k] = l2 / (known.sigma[k] * known.sigma[k] + l2);
    const oracle::Matrix expected = oracle::composed(known.V, values, known.V);
    const double resolution = static_cast<double>(rounding) / l2;
    CHECK((null_space.projector().template cast<double>() - expected).norm() < resolution);
  }
}

TEST_CASE("NullSpace: N is continuous through a singular pose", "[null-space]") {
  const unsigned seed = 4104;
  CAPTURE(seed);
  std::mt19937 random(seed);
  KnownJacobian known(random, 7, 0.1);
  rme::NullSpace<double, 7> null_space;
  // d/dsigma of lambda^2 / (sigma^2 + lambda^2) with lambda <= sigma_0 = lambda_0 = 0.02 stays below 2 / sigma_0 = 100;
  // halving the step must halve the largest change.
  double changes[2];
  for (const int halved : {0, 1}) {
    const double step = halved ? 5e-5 : 1e-4;
    rme::JointMatrix<double, 7> previous = rme::JointMatrix<double, 7>::Zero();
    double largest = 0;
    for (int k = 0; k * step <= 0.1; ++k) {
      known.sigma[5] = 0.05 - k * step;  // through zero: a negative singular value is a turned direction
      REQUIRE(null_space.update(Jacobian7(known.matrix())) == rme::Status::Ok);
      if (k > 0) largest = std::max(largest, (null_space.projector() - previous).norm());
      previous = null_space.projector();
    }
    changes[halved] = largest;
    CHECK(largest < 2 * 100 * step);
  }
  CHECK(changes[1] == Approx(changes[0] / 2).epsilon(0.05));
}

TEST_CASE("NullSpace: a zero Jacobian makes everything null space", "[null-space]") {
  rme::NullSpace<double, 7> null_space;
  REQUIRE(null_space.update(Jacobian7::Zero()) == rme::Status::Ok);
  CHECK(null_space.clearance() == 0);
  CHECK((null_space.projector() - rme::JointMatrix<double, 7>::Identity()).norm() < 1e-15);
}

TEST_CASE("NullSpace: settings that are not positive are refused by name", "[null-space]") {
  rme::NullSpaceConfig<double> config;
  config.clearance = 0;
  CHECK_THROWS_WITH((rme::NullSpace<double, 7>(config)), contains("NullSpaceConfig::clearance"));
  config = {};
  config.damping = -1;
  CHECK_THROWS_WITH((rme::NullSpace<double, 7>(config)), contains("NullSpaceConfig::damping"));
}

}  // namespace
