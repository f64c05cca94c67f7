#include <cmath>
#include <random>
#include <rme/tracking/rate.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"
#include "tracking/random_star.hpp"

namespace {

using namespace rme::testing;

TEST_CASE(
    "Rate: what changes at a rate, and with what is not known of x, takes along what is known of both, in every pair "
    "of a star",
    "[rate]") {
  // (x, beta, r): beta depends on r through x alone, so cov(beta_j, r) = B_j cov(x, r).
  const unsigned seed = 514;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const double dt = 0.3;
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    Star star = random_star(random);
    if (k % 4 == 3) star.forget_payload();
    star.extend(Star::Last::Poured);
    const Dense before = dense(star);
    const Matrix W = 0.1 * oracle::random_matrix(random, 4, kShared), N = oracle::random_matrix(random, 4, 4);
    rme::Rate<double, kJoints> rate;
    rate.cross = oracle::product(Matrix(star.covariance()), oracle::transposed(W));
    rate.covariance = oracle::congruence(W, Matrix(star.covariance())) + oracle::square(N);
    rate.mean = random_vector(random, 4);
    // Noise of full rank, or in one direction alone.
    const Matrix L = oracle::random_matrix(random, 4, k % 2 == 0 ? 4 : 1);
    Matrix all = Matrix::Zero(kAll + 4, kAll + 4), T = Matrix::Identity(kAll + 4, kAll + 4);
    all.topLeftCorner(kAll, kAll) = before.covariance;
    all.bottomRightCorner(4, 4) = rate.covariance;
    all.block(0, kAll, kShared, 4) = rate.cross;
    for (int j = 0; j < kJoints; ++j)
      all.block(first(j), kAll, kJointNuisances, 4) =
          oracle::product(oracle::transposed(star.joint(j).slope), Matrix(rate.cross));
    all.bottomLeftCorner(4, kAll) = all.topRightCorner(kAll, 4).transpose();
    T.block<4, 4>(kPoured, kAll) = dt * rme::Matrix4<double>::Identity();
    const Matrix A = 0.2 * oracle::random_matrix(random, kShared, 4);
    if (k % 3 == 1) T.block(kPoured, 0, 4, kShared) += A.transpose();
    all = oracle::congruence(T, all);
    all.block<4, 4>(kPoured, kPoured) += oracle::square(L);
    Dense expected{before.mean, all.topLeftCorner(kAll, kAll)};
    expected.mean.segment<4>(kPoured) += dt * rate.mean;
    if (k % 3 == 1)
      rate.drift(star, dt, oracle::square(L), A);
    else
      rate.drift(star, dt, oracle::square(L));
    CHECK(difference(dense(star), expected) < 1e-9);
    CHECK((rate.cross - all.block(0, kAll, kShared, 4)).norm() < 1e-12 * all.norm());
    // Of noise that is no number nothing is taken.
    const Dense now = dense(star);
    const Star::Cross kept = rate.cross;
    rate.drift(star, dt, rme::Matrix4<double>::Constant(std::nan("")));
    CHECK(difference(dense(star), now) == 0);
    CHECK(rate.cross == kept);
  }
}

}  // namespace
