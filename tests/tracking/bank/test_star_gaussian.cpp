#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <rme/tracking/bank/star_gaussian.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/random_pose.hpp>
#include <vector>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using oracle::Matrix;
using oracle::Vector;
using rme::kInertial;
using rme::bank::kJointNuisances;
constexpr int kJoints = 3;
constexpr int kAll = kInertial + kJoints * kJointNuisances;
using Star = rme::bank::StarGaussian<double, kJoints>;
using Beta = rme::bank::JointNuisanceVector<double>;
using BetaMatrix = rme::bank::JointNuisanceMatrix<double>;

int first(int j) {
  return kInertial + j * kJointNuisances;
}

Vector random_vector(std::mt19937& random, int n) {
  return oracle::random_matrix(random, n, 1).col(0);
}

/// Any star: every joint correlated with the payload.
Star random_star(std::mt19937& random) {
  Star star;
  star.replace_payload(random_vector(random, kInertial), oracle::random_matrix(random, kInertial, kInertial));
  for (int j = 0; j < kJoints; ++j) {
    star.joint(j).mean = random_vector(random, kJointNuisances);
    star.joint(j).slope = oracle::random_matrix(random, kInertial, kJointNuisances);
    const Matrix L = oracle::random_matrix(random, kJointNuisances, kJointNuisances);
    star.joint(j).covariance = oracle::square(L);
  }
  return star;
}

/// The same Gaussian over all of (phi, beta_1 .. beta_n), by the definition of a star.
struct Dense {
  Vector mean;
  Matrix covariance;
};
Dense dense(const Star& star) {
  // (phi, beta) = T (phi, beta - E[beta | phi]) + constant, and the latter two are independent.
  Matrix T = Matrix::Identity(kAll, kAll), blocks = Matrix::Zero(kAll, kAll);
  Vector constant = Vector::Zero(kAll);
  blocks.topLeftCorner(kInertial, kInertial) = star.covariance();
  for (int j = 0; j < kJoints; ++j) {
    T.block(first(j), 0, kJointNuisances, kInertial) = star.joint(j).slope.transpose();
    blocks.block(first(j), first(j), kJointNuisances, kJointNuisances) = star.joint(j).covariance;
    constant.segment(first(j), kJointNuisances) = star.joint(j).mean;
  }
  Vector phi = Vector::Zero(kAll);
  phi.head(kInertial) = star.mean();
  return {oracle::product(T, phi) + constant, oracle::congruence(T, blocks)};
}

/// Largest difference of two Gaussians in what a star holds: phi and each pair (phi, beta_j), but not two joints'
/// nuisances. Relative to the deviations; infinite if one of them is not finite.
double difference(const Dense& a, const Dense& b) {
  for (const Dense* d : {&a, &b})
    if (!d->mean.allFinite() || !d->covariance.allFinite()) return std::numeric_limits<double>::infinity();
  const Vector scale = b.covariance.diagonal().cwiseMax(1e-300).cwiseSqrt();
  double worst = 0;
  for (int i = 0; i < kAll; ++i) {
    worst = std::max(worst, std::abs(a.mean[i] - b.mean[i]) / scale[i]);
    for (int k = 0; k < kAll; ++k) {
      const bool own =
          i < kInertial || k < kInertial || (i - first(0)) / kJointNuisances == (k - first(0)) / kJointNuisances;
      if (own) worst = std::max(worst, std::abs(a.covariance(i, k) - b.covariance(i, k)) / (scale[i] * scale[k]));
    }
  }
  return worst;
}

TEST_CASE("StarGaussian: three hundred updates give what one dense batch solution of the whole trajectory gives",
          "[star]") {
  // phi constant; beta_j(t) = A beta_j(t-1) + noise with variance Q, A and Q diagonal; y = h phi + c beta_j + noise of
  // random joints. The batch knows no time steps: it is the conditional of the Gaussian over (phi, beta(T), y_1 ..).
  const unsigned seed = 510;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> any_joint(0, kJoints - 1);
  std::uniform_real_distribution<double> u(0, 1);
  for (int trial = 0; trial < 3; ++trial) {
    CAPTURE(trial);
    constexpr int steps = 300;
    const Vector phi0 = random_vector(random, kInertial);
    const Matrix L = oracle::random_matrix(random, kInertial, kInertial);
    Star star;
    star.replace_payload(phi0, L);
    std::vector<Matrix> V0;
    std::vector<Vector> b0;
    for (int j = 0; j < kJoints; ++j) {
      const Matrix S = oracle::random_matrix(random, kJointNuisances, kJointNuisances);
      V0.push_back(oracle::square(S));
      b0.push_back(random_vector(random, kJointNuisances));
      star.joint(j).mean = b0.back();
      star.joint(j).covariance = V0.back();
    }
    const Vector A = (Vector(kJointNuisances) << 1, 1, 0.99, 0.9, 1).finished();
    const Vector Q = (Vector(kJointNuisances) << 1e-4, 1e-6, 0, 0.02, 1e-3).finished();

    Matrix H(steps, kInertial), C(steps, kJointNuisances);
    Vector y(steps), R(steps);
    std::vector<int> who;
    for (int t = 0; t < steps; ++t) {
      for (int j = 0; j < kJoints; ++j) {  // time passes for all joints
        auto& joint = star.joint(j);
        joint.mean = A.asDiagonal() * joint.mean;
        joint.slope = joint.slope * A.asDiagonal();
        joint.covariance = A.asDiagonal() * joint.covariance * A.asDiagonal();
        joint.covariance.diagonal() += Q;
      }
      who.push_back(any_joint(random));
      H.row(t) = random_vector(random, kInertial).transpose();
      C.row(t) = random_vector(random, kJointNuisances).transpose();
      y[t] = 3 * random_vector(random, 1)[0];
      R[t] = 0.01 + u(random);
      const auto p = star.predict(who.back(), {y[t], H.row(t).transpose(), C.row(t).transpose(), R[t]});
      star.observe(who.back(), p);
    }

    // P_j(t), and cov(beta(t), beta(s)) = A^(t - s) P(s) for s <= t.
    const auto power = [&](int n) { return Vector(A.array().pow(n)); };
    std::vector<std::vector<Matrix>> P(kJoints);
    for (std::size_t j = 0; j < kJoints; ++j) {
      Matrix V = V0[j];
      for (int t = 0; t < steps; ++t) {
        V = A.asDiagonal() * V * A.asDiagonal();
        V.diagonal() += Q;
        P[j].push_back(V);
      }
    }
    const Matrix P0 = oracle::square(L);
    Vector mean_y(steps), mean_x = Vector::Zero(kAll);
    Matrix S = oracle::congruence(H, P0), cross = Matrix::Zero(kAll, steps), Pxx = Matrix::Zero(kAll, kAll);
    mean_x.head(kInertial) = phi0;
    Pxx.topLeftCorner(kInertial, kInertial) = P0;
    cross.topRows(kInertial) = oracle::product(P0, oracle::transposed(H));
    for (int j = 0; j < kJoints; ++j) {
      const auto k = static_cast<std::size_t>(j);
      mean_x.segment(first(j), kJointNuisances) = power(steps).asDiagonal() * b0[k];
      Pxx.block(first(j), first(j), kJointNuisances, kJointNuisances) = P[k].back();
    }
    for (int t = 0; t < steps; ++t) {
      const auto j = static_cast<std::size_t>(who[static_cast<std::size_t>(t)]);
      const auto& Pt = P[j][static_cast<std::size_t>(t)];
      mean_y[t] = H.row(t).dot(phi0) + C.row(t).dot(power(t + 1).asDiagonal() * b0[j]);
      S(t, t) += R[t];
      for (int s = t; s < steps; ++s) {
        if (who[static_cast<std::size_t>(s)] != static_cast<int>(j)) continue;
        const double c = C.row(s) * (power(s - t).asDiagonal() * (Pt * C.row(t).transpose()));
        S(s, t) += c;
        if (s != t) S(t, s) += c;
      }
      cross.block(first(static_cast<int>(j)), t, kJointNuisances, 1) =
          power(steps - 1 - t).asDiagonal() * (Pt * C.row(t).transpose());
    }
    const Matrix gain = oracle::transposed(oracle::solve(S, oracle::transposed(cross)));
    const Dense batch{mean_x + oracle::product(gain, y - mean_y),
                      Pxx - oracle::product(gain, oracle::transposed(cross))};
    const double off = difference(dense(star), batch);
    CHECK(off < 1e-9);
  }
}

TEST_CASE("StarGaussian: predict says what the dense Gaussian says of an observation", "[star]") {
  const unsigned seed = 511;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    const Star star = random_star(random);
    const auto [mean, covariance] = dense(star);
    const int j = k % kJoints;
    rme::bank::JointObservation<double> o{1.5, random_vector(random, kInertial), random_vector(random, kJointNuisances),
                                          0.3};
    Vector row = Vector::Zero(kAll);
    row.head(kInertial) = o.h;
    row.segment(first(j), kJointNuisances) = o.c;
    const auto p = star.predict(j, o);
    CHECK(p.innovation == Approx(1.5 - row.dot(mean)).epsilon(1e-12));
    CHECK(p.variance == Approx(row.dot(covariance * row) + 0.3).epsilon(1e-12));
    CHECK(p.given_payload == Approx(o.c.dot(star.joint(j).covariance * o.c) + 0.3).epsilon(1e-12));
    CHECK((star.nuisance_mean(j) - mean.segment<kJointNuisances>(first(j))).norm() < 1e-12);
    CHECK(
        (star.nuisance_covariance(j) - covariance.block<kJointNuisances, kJointNuisances>(first(j), first(j))).norm() <
        1e-11 * covariance.norm());
    CHECK(star.mass_variance() == Approx(covariance(0, 0)).epsilon(1e-12));
  }
}

TEST_CASE("StarGaussian: a new payload changes nothing of what is known of the joints", "[star]") {
  const unsigned seed = 512;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    Star star = random_star(random);
    Dense expected = dense(star);
    const Vector mean = random_vector(random, kInertial);
    const Matrix factor = oracle::random_matrix(random, kInertial, kInertial);
    expected.mean.head(kInertial) = mean;
    expected.covariance.topRows(kInertial).setZero();
    expected.covariance.leftCols(kInertial).setZero();
    expected.covariance.topLeftCorner(kInertial, kInertial) = oracle::square(factor);
    star.replace_payload(mean, factor);
    CHECK(difference(dense(star), expected) < 1e-12);
    star.empty_payload();
    CHECK(star.mean().isZero(0));
    CHECK(star.covariance().isZero(0));
    CHECK(star.nuisance_mean(1).isApprox(expected.mean.segment<kJointNuisances>(first(1)), 1e-12));
  }
}

TEST_CASE("StarGaussian: diffuse adds to the payload's covariance, and to no joint's", "[star]") {
  const unsigned seed = 513;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    Star star = random_star(random);
    Dense expected = dense(star);
    // Of full rank, and in one direction alone.
    const Matrix L = oracle::random_matrix(random, kInertial, k % 2 == 0 ? kInertial : 1);
    expected.covariance.topLeftCorner(kInertial, kInertial) += oracle::square(L);
    star.diffuse(oracle::square(L));
    CHECK(difference(dense(star), expected) < 1e-9);
  }
  // From an empty hand: the joints know nothing of what comes.
  Star empty = random_star(random);
  empty.empty_payload();
  Dense expected = dense(empty);
  const Matrix L = oracle::random_matrix(random, kInertial, kInertial);
  expected.covariance.topLeftCorner(kInertial, kInertial) = oracle::square(L);
  empty.diffuse(oracle::square(L));
  CHECK(difference(dense(empty), expected) < 1e-9);
}

TEST_CASE("StarGaussian: mix has the moments of the mixture, pair by pair", "[star]") {
  const unsigned seed = 514;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    const std::array<Star, 4> stars = {random_star(random), random_star(random), random_star(random),
                                       random_star(random)};
    const std::array<double, 4> weights = {0.5, 0.2, 0, 0.3};
    Dense mixture{Vector::Zero(kAll), Matrix::Zero(kAll, kAll)}, emptied = mixture;
    for (std::size_t i = 0; i < 4; ++i) mixture.mean += weights[i] * dense(stars[i]).mean;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto [mean, covariance] = dense(stars[i]);
      const Vector d = mean - mixture.mean;
      mixture.covariance += weights[i] * (covariance + oracle::square(d));
    }
    const std::array<const Star*, 4> parts = {&stars[0], &stars[1], &stars[2], &stars[3]};
    const Star mixed = Star::mix(parts, weights);
    CHECK(difference(dense(mixed), mixture) < 1e-9);
    CHECK((mixed.nuisance_mean(1) - mixture.mean.segment<kJointNuisances>(first(1))).norm() < 1e-9);

    emptied = mixture;
    emptied.mean.head(kInertial).setZero();
    emptied.covariance.topRows(kInertial).setZero();
    emptied.covariance.leftCols(kInertial).setZero();
    const Star out = Star::mix_emptied(parts, weights);
    CHECK(difference(dense(out), emptied) < 1e-12);
    CHECK(out.covariance().isZero(0));
  }
}

TEST_CASE("StarGaussian: a mixture of one part is that part, and one with an empty hand keeps its share", "[star]") {
  const unsigned seed = 515;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const Star star = random_star(random);
  Star empty = random_star(random);
  empty.empty_payload();
  CHECK(difference(dense(Star::mix<2>({&star, &empty}, {1, 0})), dense(star)) < 1e-9);
  const Star same = Star::mix<2>({&star, &star}, {0.3, 0.7});
  CHECK(difference(dense(same), dense(star)) < 1e-9);
  const Star nothing = Star::mix<2>({&star, &empty}, {0, 1});
  CHECK(nothing.covariance().isZero(0));
  CHECK(nothing.nuisance_mean(2).isApprox(empty.nuisance_mean(2), 1e-12));
  // Half of the payload, and half of its covariance beside what lies between the two means.
  const Star half = Star::mix<2>({&star, &empty}, {0.5, 0.5});
  const Matrix P = 0.5 * star.covariance() + 0.25 * oracle::square(star.mean());
  CHECK((half.covariance() - P).norm() < 1e-12 * P.norm());
  CHECK((half.mean() - 0.5 * star.mean()).norm() < 1e-14);
}

TEST_CASE("StarGaussian: a mixture does not look at parts of weight 0, nor at slopes of an empty hand", "[star]") {
  const unsigned seed = 518;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Star star = random_star(random);
  Star spoilt = random_star(random);
  spoilt.replace_payload(Star::Phi::Constant(nan), Star::PhiMatrix::Constant(nan));
  for (int j = 0; j < kJoints; ++j) {
    spoilt.joint(j).mean.setConstant(nan);
    spoilt.joint(j).covariance.setConstant(nan);
  }
  const std::array<const Star*, 3> parts = {&spoilt, &star, &spoilt};
  CHECK(difference(dense(Star::mix<3>(parts, {0, 1, 0})), dense(star)) < 1e-9);
  const Star emptied = Star::mix_emptied<3>(parts, {0, 1, 0});
  CHECK(emptied.finite());
  CHECK(emptied.nuisance_mean(1).isApprox(star.nuisance_mean(1), 1e-12));
  CHECK(emptied.nuisance_covariance(1).isApprox(star.nuisance_covariance(1), 1e-12));

  Star empty = random_star(random);
  empty.empty_payload();
  const Star half = Star::mix<2>({&star, &empty}, {0.5, 0.5});
  for (int j = 0; j < kJoints; ++j) empty.joint(j).slope.setConstant(nan);
  CHECK(difference(dense(Star::mix<2>({&star, &empty}, {0.5, 0.5})), dense(half)) == 0);
}

TEST_CASE("StarGaussian: mix keeps the moments of payloads that vary in a few directions only", "[star]") {
  // Three directions and the way between the two means: the payload's covariance is singular, and its rows are not 0.
  const unsigned seed = 519;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::array<Star, 2> stars = {random_star(random), random_star(random)};
  Matrix G = Matrix::Zero(kInertial, kInertial);
  G.leftCols(3) = oracle::random_matrix(random, kInertial, 3);
  for (Star& star : stars) star.replace_payload(random_vector(random, kInertial), G);
  for (Star& star : stars)
    for (int j = 0; j < kJoints; ++j) star.joint(j).slope = oracle::random_matrix(random, kInertial, kJointNuisances);
  Dense mixture{0.5 * (dense(stars[0]).mean + dense(stars[1]).mean), Matrix::Zero(kAll, kAll)};
  for (const Star& star : stars) {
    const auto [mean, covariance] = dense(star);
    mixture.covariance += 0.5 * (covariance + oracle::square(Vector(mean - mixture.mean)));
  }
  CHECK(difference(dense(Star::mix<2>({&stars[0], &stars[1]}, {0.5, 0.5})), mixture) < 1e-6);
}

TEST_CASE("StarGaussian: with an empty hand only the joints learn, until there may be a payload again", "[star]") {
  const unsigned seed = 520;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const rme::bank::JointObservation<double> o{1.5, random_vector(random, kInertial),
                                              random_vector(random, kJointNuisances), 0.3};
  Star emptied = random_star(random), fresh;
  emptied.empty_payload();
  fresh.joint(0).covariance = emptied.joint(0).covariance;
  for (Star* star : {&emptied, &fresh}) {
    const auto before = star->nuisance_mean(0);
    star->observe(0, star->predict(0, o));
    CHECK(star->mean().isZero(0));
    CHECK(star->joint(0).slope.isZero(0));
    CHECK((star->nuisance_mean(0) - before).norm() > 1e-3);
    // From here on it is as any star: the payload takes its share of what the torque shows.
    const Matrix L = oracle::random_matrix(random, kInertial, kInertial);
    star->diffuse(oracle::square(L));
    const auto p = star->predict(0, o);
    const double variance = o.h.dot(oracle::square(L) * o.h) + o.c.dot(star->joint(0).covariance * o.c) + o.noise;
    CHECK(p.variance == Approx(variance).epsilon(1e-9));
    star->observe(0, p);
    const Vector expected = oracle::product(oracle::square(L), Vector(o.h)) * (p.innovation / variance);
    CHECK((star->mean() - expected).norm() < 1e-9 * expected.norm());
  }
}

TEST_CASE("StarGaussian: finite looks at every part", "[star]") {
  const unsigned seed = 521;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const Star star = random_star(random);
  CHECK(star.finite());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int part = 0; part < 5; ++part) {
    CAPTURE(part);
    Star spoilt = star;
    Star::Phi mean = star.mean();
    Star::PhiMatrix factor = Star::PhiMatrix::Identity();
    if (part == 0) mean[3] = nan;
    if (part == 1) factor(2, 1) = nan;
    if (part < 2) spoilt.replace_payload(mean, factor);
    if (part == 2) spoilt.joint(1).mean[4] = nan;
    if (part == 3) spoilt.joint(1).slope(9, 0) = nan;
    if (part == 4) spoilt.joint(1).covariance(2, 3) = nan;
    CHECK_FALSE(spoilt.finite());
  }
}

TEST_CASE("StarGaussian: factorise gives one direction where there is one, and none of rounding", "[star]") {
  const unsigned seed = 522;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    Star::PhiMatrix L;
    REQUIRE(Star::factorise(oracle::square(oracle::random_matrix(random, kInertial, 1)), L));
    CHECK((L.diagonal().array() > 0).count() == 1);
  }
}

TEST_CASE("StarGaussian: factorise gives a factor a factor of singular matrices too, and of NaN none", "[star]") {
  const unsigned seed = 516;
  CAPTURE(seed);
  std::mt19937 random(seed);
  using PhiMatrix = Star::PhiMatrix;
  for (int rank = 0; rank <= kInertial; ++rank) {
    CAPTURE(rank);
    const Matrix G = oracle::random_matrix(random, kInertial, rank);
    Matrix scale = Matrix::Identity(kInertial, kInertial);
    for (int i = 4; i < kInertial; ++i) scale(i, i) = 1e-4;  // kilograms beside kilogram square metres
    const PhiMatrix P = oracle::congruence(scale, oracle::square(G));
    PhiMatrix L = PhiMatrix::Constant(7);
    REQUIRE(Star::factorise(P, L));
    CHECK(L.isLowerTriangular(0));
    // Entry by entry, relative to the diagonal's scale.
    const Matrix off = oracle::square(L) - P;
    for (int i = 0; i < kInertial; ++i)
      for (int k = 0; k < kInertial; ++k) CHECK(std::abs(off(i, k)) <= 1e-13 * std::sqrt(P(i, i) * P(k, k)));
  }
  // A direction of which P says nothing: a mass that is known exactly.
  PhiMatrix P = PhiMatrix::Identity(), L;
  P.row(0).setZero();
  P.col(0).setZero();
  REQUIRE(Star::factorise(P, L));
  CHECK(L == P);
  P(3, 3) = std::numeric_limits<double>::quiet_NaN();
  const PhiMatrix before = L;
  CHECK_FALSE(Star::factorise(P, L));
  CHECK(L == before);
}

/// One joint's random walk, seen through noise: the Riccati equation's fixed point is a root of P^2 + q P - q r.
template <typename Scalar>
void check_steady_state(double tolerance) {
  rme::bank::StarGaussian<Scalar, 1> star;
  const double q = 4e-8, r = 9e-4;
  star.joint(0).covariance(rme::bank::kOffset, rme::bank::kOffset) = Scalar(0.0225);
  rme::bank::JointObservation<Scalar> o{Scalar(0.1), rme::InertialVector<Scalar>::Zero(),
                                        rme::bank::JointNuisanceVector<Scalar>::Unit(rme::bank::kOffset), Scalar(r)};
  for (int k = 0; k < 20000; ++k) {
    star.joint(0).covariance(rme::bank::kOffset, rme::bank::kOffset) += Scalar(q);
    star.observe(0, star.predict(0, o));
  }
  const double fixed_point = (-q + std::sqrt(q * q + 4 * q * r)) / 2;
  CHECK(double(star.joint(0).covariance(rme::bank::kOffset, rme::bank::kOffset)) ==
        Approx(fixed_point).epsilon(tolerance));
  CHECK(double(star.joint(0).mean[rme::bank::kOffset]) == Approx(0.1).epsilon(tolerance));
  // A mass that does not change, seen n times through white noise: 1 / (1 / P + n h^2 / r).
  rme::bank::StarGaussian<Scalar, 1> mass;
  rme::InertialMatrix<Scalar> factor = rme::InertialMatrix<Scalar>::Zero();
  factor(0, 0) = Scalar(0.9);
  mass.replace_payload(rme::InertialVector<Scalar>::Zero(), factor);
  o = {Scalar(9.81 * 1.5 * 0.4), rme::InertialVector<Scalar>::Unit(0) * Scalar(9.81 * 0.4),
       rme::bank::JointNuisanceVector<Scalar>::Zero(), Scalar(r)};
  const int n = 20000;
  for (int k = 0; k < n; ++k) mass.observe(0, mass.predict(0, o));
  const double variance = 1 / (1 / 0.81 + n * 9.81 * 9.81 * 0.16 / r);
  CHECK(double(mass.mass_variance()) == Approx(variance).epsilon(tolerance));
  CHECK(double(mass.mean()[0]) == Approx(1.5 * (1 - variance / 0.81)).epsilon(tolerance));
}

TEST_CASE("StarGaussian: variances settle where the Riccati equation says", "[star]") {
  check_steady_state<double>(1e-9);
  check_steady_state<float>(2e-3);
}

/// Smallest eigenvalue of a covariance whose rows have been scaled to a diagonal of ones.
double least_correlation(const Matrix& covariance) {
  const Matrix symmetric = 0.5 * (covariance + oracle::transposed(covariance));
  const Matrix scale = covariance.diagonal().cwiseSqrt().cwiseInverse().asDiagonal();
  return oracle::eigenvalues(oracle::congruence(scale, symmetric))[0];
}

/// What the joints' torques depend on at a moment of the motion.
struct Regressors {
  Eigen::Matrix<double, rme::kInertial, 7> h;
  rme::JointVector<double, 7> velocity;
};

/// A Panda in 64 random poses, turning in each.
std::vector<Regressors> panda_poses(std::mt19937_64& random, std::normal_distribution<double>& normal) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto vector = [&](double size) {
    return Eigen::Vector3d(size * normal(random), size * normal(random), size * normal(random));
  };
  const auto& arm = rme::examples::panda();
  std::vector<Regressors> poses(64);
  for (Regressors& pose : poses) {
    const auto at = arm.kinematics(rme::examples::random_panda_pose(uniform));
    const auto Y =
        rme::inertial_wrench_regressor<double>(at.rotation, arm.gravity_vector, {vector(0.5), vector(0.5), vector(1)});
    pose.h = Y.transpose() * at.jacobian;
    for (double& v : pose.velocity) v = 0.3 * normal(random);
  }
  return poses;
}

/// A Panda carries a payload from pose to pose for `blocks` blocks of 20 ms; each is one joint's torque, in turn, which
/// is a seventh of the work and shows the same. Every 5 s it sets out for another pose, turning; it never rests.
template <typename Scalar>
void check_long_run(int blocks, unsigned seed) {
  CAPTURE(blocks, seed);
  constexpr int n = 7;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const std::vector<Regressors> poses = panda_poses(random, normal);
  rme::InertialVector<double> numbers;
  numbers << 0.9, 0.02, -0.01, 0.09, 0.012, 0, 0, 0.012, 0, 0.002;
  const rme::InertialVector<Scalar> truth = numbers.template cast<Scalar>();
  numbers << 0.9, 0.05, 0.05, 0.1, 0.02, 0.02, 0.02, 0.02, 0.02, 0.02;
  const rme::InertialVector<Scalar> deviation = numbers.template cast<Scalar>();
  rme::bank::StarGaussian<Scalar, n> star;
  star.replace_payload(rme::InertialVector<Scalar>::Zero(), deviation.asDiagonal());
  for (int j = 0; j < n; ++j) {
    star.joint(j).mean << 0, Scalar(0.2), Scalar(0.1), 0, 0;
    star.joint(j).covariance.diagonal() << Scalar(0.0225), Scalar(0.01), Scalar(0.0025), Scalar(4e-4), Scalar(0.0144);
  }
  const Scalar keep = Scalar(0.99), noise = Scalar(0.03);
  std::array<Scalar, 1024> white;
  for (Scalar& w : white) w = noise * static_cast<Scalar>(normal(random));
  for (int k = 0; k < blocks; ++k) {
    const auto& pose = poses[static_cast<std::size_t>(k / 250) % poses.size()];
    const int j = k % n;
    auto& joint = star.joint(j);
    auto& V = joint.covariance;
    joint.mean[rme::bank::kResidual] *= keep;
    joint.slope.col(rme::bank::kResidual) *= keep;
    V.row(rme::bank::kResidual) *= keep;
    V.col(rme::bank::kResidual) *= keep;
    V(rme::bank::kResidual, rme::bank::kResidual) += (1 - keep * keep) * Scalar(4e-4);
    V(rme::bank::kOffset, rme::bank::kOffset) += Scalar(4e-8);
    V(rme::bank::kCoulomb, rme::bank::kCoulomb) += Scalar(4e-10);
    V(rme::bank::kViscous, rme::bank::kViscous) += Scalar(1e-10);
    const auto velocity = Scalar(pose.velocity[j]), direction = velocity > 0 ? Scalar(1) : Scalar(-1);
    rme::bank::JointObservation<Scalar> o;
    o.h = pose.h.col(j).template cast<Scalar>();
    o.c << 1, -direction, -velocity, 1, 0;
    o.noise = noise * noise;
    // With an offset of 0.1 N m and friction of 0.25 N m and 0.08 N m s/rad.
    o.torque = o.h.dot(truth) + Scalar(0.1) - Scalar(0.25) * direction - Scalar(0.08) * velocity +
               white[static_cast<std::size_t>(random() % white.size())];
    star.observe(j, star.predict(j, o));
  }
  CHECK(star.mean().allFinite());
  CHECK(least_correlation(star.covariance().template cast<double>()) > 0);
  for (int j = 0; j < n; ++j) {
    CAPTURE(j, star.joint(j).covariance);
    CHECK(star.joint(j).mean.allFinite());
    CHECK((star.joint(j).covariance.diagonal().array() > 0).all());
    CHECK(least_correlation(star.joint(j).covariance.template cast<double>()) > 0);
    CHECK(least_correlation(star.nuisance_covariance(j).template cast<double>()) > 0);
    const auto& V = star.joint(j).covariance;
    CHECK((V - V.transpose()).norm() < 1e-3 * V.norm());
  }
  // It still knows what it carries.
  CAPTURE(star.mean().transpose());
  CHECK(double(std::abs(star.mean()[0] - truth[0])) < 0.005);
  CHECK(double((star.mean() - truth).template segment<3>(1).norm()) < 0.002);
}

TEST_CASE("StarGaussian: after ten million blocks in double the covariance is positive definite", "[star]") {
  check_long_run<double>(10'000'000, 517);
}

TEST_CASE("StarGaussian: after a million blocks in float the covariance is positive definite", "[star]") {
  check_long_run<float>(1'000'000, 518);
}

}  // namespace
