#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <rme/tracking/pour.hpp>
#include <rme/tracking/star_gaussian.hpp>
#include <vector>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"
#include "tracking/random_star.hpp"

namespace {

using namespace rme::testing;

TEST_CASE("StarGaussian: three hundred updates give what one dense batch solution of the whole trajectory gives",
          "[star]") {
  // x constant; beta_j(t) = A beta_j(t-1) + noise with variance Q, A and Q diagonal; y = h x + c beta_j + noise of
  // random joints. The batch knows no time steps: it is the conditional of the Gaussian over (x, beta(T), y_1 ..).
  const unsigned seed = 510;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> any_joint(0, kJoints - 1);
  for (int trial = 0; trial < 3; ++trial) {
    CAPTURE(trial);
    constexpr int steps = 300;
    const Arm arm = Arm::Constant(0.1) + Arm(random_vector(random, kArmShared).cwiseAbs2());
    Vector x0 = Vector::Zero(kShared);
    Matrix P0 = Matrix::Zero(kShared, kShared);
    x0.segment(kPayload, kInertial) = random_vector(random, kInertial);
    const Matrix L = oracle::random_matrix(random, kInertial, kInertial);
    P0.diagonal().head(kArmShared) = arm;
    P0.block(kPayload, kPayload, kInertial, kInertial) = oracle::square(L);
    Star star;
    star.set_arm(arm);
    star.draw_payload(x0.segment(kPayload, kInertial), L);
    std::vector<Matrix> V0;
    std::vector<Vector> b0;
    for (int j = 0; j < kJoints; ++j) {
      V0.push_back(oracle::square(oracle::random_matrix(random, kJointNuisances, kJointNuisances)));
      b0.push_back(random_vector(random, kJointNuisances));
      star.joint(j).mean = b0.back();
      star.joint(j).covariance = V0.back();
    }
    const Vector A = (Vector(kJointNuisances) << 1, 1, 0.99, 0.9, 1, 1).finished();
    const Vector Q = (Vector(kJointNuisances) << 1e-4, 1e-6, 0, 0.02, 1e-3, 1e-8).finished();

    Matrix H(steps, kShared), C(steps, kJointNuisances);
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
      const auto o = random_observation(random);
      H.row(t) = o.h.transpose();
      C.row(t) = o.c.transpose();
      y[t] = o.torque;
      R[t] = o.noise;
      star.observe(who.back(), star.predict(who.back(), o));
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
    Vector mean_y(steps), mean_x = Vector::Zero(kAll);
    Matrix S = oracle::congruence(H, P0), cross = Matrix::Zero(kAll, steps), Pxx = Matrix::Zero(kAll, kAll);
    mean_x.head(kShared) = x0;
    Pxx.topLeftCorner(kShared, kShared) = P0;
    cross.topRows(kShared) = oracle::product(P0, oracle::transposed(H));
    for (int j = 0; j < kJoints; ++j) {
      const auto k = static_cast<std::size_t>(j);
      mean_x.segment(first(j), kJointNuisances) = power(steps).asDiagonal() * b0[k];
      Pxx.block(first(j), first(j), kJointNuisances, kJointNuisances) = P[k].back();
    }
    for (int t = 0; t < steps; ++t) {
      const auto j = static_cast<std::size_t>(who[static_cast<std::size_t>(t)]);
      const auto& Pt = P[j][static_cast<std::size_t>(t)];
      mean_y[t] = H.row(t).dot(x0) + C.row(t).dot(power(t + 1).asDiagonal() * b0[j]);
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
    CHECK(difference(dense(star), batch) < 1e-9);
  }
}

TEST_CASE("StarGaussian: predict says what the dense Gaussian says of an observation", "[star]") {
  const unsigned seed = 511;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    Star star = random_star(random);
    if (k % 2 == 1) star.forget_payload();
    const auto [mean, covariance] = dense(star);
    const int j = k % kJoints;
    const auto o = random_observation(random);
    Vector row = Vector::Zero(kAll);
    row.head(kShared) = o.h;
    row.segment(first(j), kJointNuisances) = o.c;
    const auto p = star.predict(j, o);
    const Vector shared = (covariance * row).head(kShared);
    CHECK(p.innovation == Approx(o.torque - row.dot(mean)).epsilon(1e-12));
    CHECK(p.variance == Approx(row.dot(covariance * row) + o.noise).epsilon(1e-12));
    CHECK(p.given_shared == Approx(o.c.dot(star.joint(j).covariance * o.c) + o.noise).epsilon(1e-12));
    CHECK((star.covariance_row(p) - shared).norm() < 1e-12 * shared.norm());
    CHECK((star.nuisance_mean(j) - mean.segment<kJointNuisances>(first(j))).norm() < 1e-12);
    const auto own = covariance.block<kJointNuisances, kJointNuisances>(first(j), first(j));
    CHECK((star.nuisance_covariance(j) - own).norm() < 1e-11 * covariance.norm());
    for (int n = 0; n < kJointNuisances; ++n)
      CHECK(star.nuisance_mean(j, static_cast<rme::Nuisance>(n)) == Approx(mean[first(j) + n]).epsilon(1e-12));
    double gains = 0;  // given x
    for (int i = 0; i < kJoints; ++i) gains += star.joint(i).covariance(rme::kGain, rme::kGain) / kJoints;
    CHECK(star.nuisance_variance(rme::kGain) == Approx(gains).epsilon(1e-12));
    const Vector tilt = mean.segment(rme::kTilt, 2);
    const Matrix tilt_square = covariance.block(rme::kTilt, rme::kTilt, 2, 2) + tilt * tilt.transpose();
    CHECK((star.tilt_square() - tilt_square).norm() < 1e-12 * covariance.norm());
    Vector arm = Vector::Zero(kShared);
    arm.head(kArmShared) = p.gain_row.head(kArmShared);
    CHECK((star.arm_spread(p) - star.factor().transpose() * arm).norm() < 1e-12 * arm.norm() * star.factor().norm());
    CHECK(star.empty() == (k % 2 == 1));
    CHECK(star.mass() == mean[kPayload] + mean[kPoured]);
    Matrix sum = Matrix::Zero(kInertial, kAll);
    for (int i = 0; i < kInertial; ++i) sum(i, kPayload + i) = 1;
    for (int i = 0; i < 4; ++i) sum(i, kPoured + i) = 1;
    const Matrix payload = oracle::congruence(sum, covariance);
    CHECK((star.payload_mean() - oracle::product(sum, mean)).norm() < 1e-12);
    CHECK((star.payload_covariance() - payload).norm() < 1e-12 * covariance.norm());
    CHECK(star.mass_variance() == Approx(payload(0, 0)).epsilon(1e-12));
    for (int i = 0; i < kShared; ++i) CHECK(star.variance(i) == Approx(covariance(i, i)).epsilon(1e-12));
  }
}

TEST_CASE("StarGaussian: given x, a joint's nuisances learn from a torque what the dense Gaussian of both says",
          "[star]") {
  const unsigned seed = 512;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    Star star = random_star(random);
    const Dense before = dense(star);
    const int j = k % kJoints;
    const auto o = random_observation(random);
    // (x, y): the conditional of beta_j given both is what is looked for.
    Matrix T = Matrix::Zero(kShared + 1, kAll);
    T.topLeftCorner(kShared, kShared).setIdentity();
    T.row(kShared).head(kShared) = o.h.transpose();
    T.row(kShared).segment(first(j), kJointNuisances) = o.c.transpose();
    Matrix known = oracle::congruence(T, before.covariance);
    known(kShared, kShared) += o.noise;
    const Matrix beta = before.covariance.middleRows(first(j), kJointNuisances);
    const Matrix cross = oracle::product(beta, oracle::transposed(T));
    const Matrix gain = oracle::transposed(oracle::solve(known, oracle::transposed(cross)));
    star.observe_nuisances(j, star.predict(j, o));
    const double mean_y = T.row(kShared).dot(before.mean);
    const Vector b = before.mean.segment(first(j), kJointNuisances) + gain.col(kShared) * (o.torque - mean_y) -
                     oracle::product(gain.leftCols(kShared), Vector(before.mean.head(kShared)));
    const auto& joint = star.joint(j);
    CHECK((joint.slope.transpose() - gain.leftCols(kShared)).norm() < 1e-9 * gain.norm());
    CHECK((joint.mean - b).norm() < 1e-9 * gain.norm());
    const Matrix V = beta.middleCols(first(j), kJointNuisances) - oracle::product(gain, oracle::transposed(cross));
    CHECK((joint.covariance - V).norm() < 1e-9 * V.norm());
    // x keeps its distribution, and the other joints theirs.
    CHECK(star.mean() == before.mean.head(kShared));
    CHECK(star.covariance() == before.covariance.topLeftCorner(kShared, kShared));
    const int other = (j + 1) % kJoints;
    CHECK((star.nuisance_mean(other) - before.mean.segment<kJointNuisances>(first(other))).norm() < 1e-12);
  }
}

TEST_CASE("StarGaussian: a sensor that is zeroed turns its offset into what makes the torque zero", "[star]") {
  const unsigned seed = 528;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    Star star = random_star(random);
    if (k % 2 == 1) star.forget_payload();
    const Dense before = dense(star);
    const int j = k % kJoints, offset = first(j) + rme::kOffset;
    auto o = random_observation(random);
    o.c[rme::kOffset] = 1;
    constexpr double variance = 0.3;
    star.zero_torque(j, o, variance);
    // The new offset is minus all else that the torque has, and independent noise.
    Matrix T = Matrix::Identity(kAll, kAll);
    T.row(offset).head(kShared) = -o.h.transpose();
    T.row(offset).segment(first(j), kJointNuisances) = -o.c.transpose();
    T(offset, offset) = 0;
    Matrix covariance = oracle::congruence(T, before.covariance);
    covariance(offset, offset) += variance;
    const Dense after = dense(star);
    CHECK((after.mean - oracle::product(T, before.mean)).norm() < 1e-11 * before.mean.norm());
    CHECK((after.covariance - covariance).norm() < 1e-11 * covariance.norm());
    const auto p = star.predict(j, o);
    CHECK(p.innovation == Approx(o.torque).margin(1e-9));
    CHECK(p.variance == Approx(variance + o.noise).epsilon(1e-9));
  }
}

TEST_CASE("StarGaussian: what changes the payload or the tool keeps the moments of every pair", "[star]") {
  const unsigned seed = 513;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    const Star star = random_star(random);
    const Dense before = dense(star), empty = mapped(emptying(), before);
    // The hand is emptied; twice is once.
    Star changed = star;
    changed.forget_payload();
    CHECK(difference(dense(changed), empty) < 1e-9);
    const Dense once = dense(changed);
    changed.forget_payload();
    CHECK(difference(dense(changed), once) == 0);
    CHECK(changed.empty());
    // Something else is in it, independent of all.
    const Vector mean = random_vector(random, kInertial);
    const Matrix factor = oracle::random_matrix(random, kInertial, kInertial);
    Dense expected = empty;
    expected.mean.segment(kPayload, kInertial) = mean;
    expected.covariance.block(kPayload, kPayload, kInertial, kInertial) = oracle::square(factor);
    changed = star;
    changed.draw_payload(mean, factor);
    CHECK(difference(dense(changed), expected) < 1e-9);
    CHECK_FALSE(changed.empty());
    // It is the tool's from now on.
    Matrix T = Matrix::Identity(kAll, kAll);
    for (int i = 0; i < 4; ++i) T(kTool + i, kPayload + i) = T(kTool + i, kPoured + i) = 1;
    changed = star;
    rme::Pour<double, kJoints>().end(changed);
    changed.payload_is_tool();
    CHECK(difference(dense(changed), mapped(oracle::product(emptying(), T), before)) < 1e-9);
    CHECK(changed.empty());
    changed.payload_is_tool();  // there is none any more
    CHECK(difference(dense(changed), mapped(oracle::product(emptying(), T), before)) < 1e-9);
    // The last entries are multiplied by a number.
    const double scale = 0.3 + 0.1 * (k % 11);
    T = Matrix::Identity(kAll, kAll);
    for (int i = kPoured; i < kShared; ++i) T(i, i) = scale;
    changed = star;
    changed.scale_last(scale);
    CHECK(difference(dense(changed), mapped(T, before)) < 1e-9);
    // It is less certain, all its parameters alike.
    const Vector phi = before.mean.segment(kPayload, kInertial);
    expected = before;
    expected.covariance.block(kPayload, kPayload, kInertial, kInertial) += 0.3 * phi * phi.transpose();
    changed = star;
    changed.widen_payload(0.3);
    CHECK(difference(dense(changed), expected) < 1e-9);
    // The arm is less certain.
    const Arm wider = random_vector(random, kArmShared).cwiseAbs2();
    for (const bool held : {true, false}) {
      expected = held ? before : empty;
      expected.covariance.diagonal().head<kArmShared>() += wider;
      changed = star;
      if (!held) changed.forget_payload();
      changed.widen_arm(wider);
      CHECK(difference(dense(changed), expected) < 1e-9);
      CHECK(changed.empty() == !held);
    }
    // Something may be in the hand that the nuisances have taken for their own.
    const Matrix hidden = oracle::random_matrix(random, kInertial, kInertial);
    std::array<Star::Absorbed, kJoints> absorbed;
    Matrix columns = Matrix::Zero(kAll, kInertial);
    columns.middleRows(kPayload, kInertial) = hidden;
    for (int j = 0; j < kJoints; ++j) {
      auto& of = absorbed[static_cast<std::size_t>(j)];
      of = oracle::random_matrix(random, 4, kJointNuisances);
      columns.middleRows(first(j), kJointNuisances) = of.transpose() * hidden.topRows(4);
    }
    expected = empty;
    expected.covariance += columns * columns.transpose();
    changed = star;
    changed.forget_payload();
    changed.suppose_payload(hidden, absorbed);
    CHECK(difference(dense(changed), expected) < 1e-9);
  }
}

TEST_CASE("StarGaussian: a payload that turns out to be none leaves what an empty hand would have learned", "[star]") {
  const unsigned seed = 317;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int trial = 0; trial < 20; ++trial) {
    CAPTURE(trial);
    Star nothing;
    nothing.set_arm(Arm::Constant(0.5));
    for (int j = 0; j < kJoints; ++j) {
      nothing.joint(j).mean = random_vector(random, kJointNuisances);
      nothing.joint(j).slope.topRows<kArmShared>() = oracle::random_matrix(random, kArmShared, kJointNuisances);
      nothing.joint(j).covariance = oracle::square(oracle::random_matrix(random, kJointNuisances, kJointNuisances));
    }
    Star star = nothing;
    const Vector mean = random_vector(random, kInertial);
    const Matrix factor = oracle::random_matrix(random, kInertial, kInertial);
    star.draw_payload(mean, factor);
    double gained = 0;  // by there being nothing
    for (int k = 0; k < 30; ++k) {
      const auto o = random_observation(random);
      const auto with = star.predict(k % kJoints, o), without = nothing.predict(k % kJoints, o);
      const auto log_density = [](const auto& p) {
        return -0.5 * (p.innovation * p.innovation / p.variance + std::log(p.variance));
      };
      gained += log_density(without) - log_density(with);
      star.observe(k % kJoints, with);
      nothing.observe(k % kJoints, without);
    }
    // The ratio of the likelihoods is that of the densities at zero (Dickey, Annals of Mathematical Statistics 1971).
    const double prior = oracle::log_normal(mean, oracle::square(factor));
    CHECK(star.payload_is_none() - prior == Approx(gained).epsilon(1e-4).margin(1e-4));
    CHECK(star.empty());
    CHECK(difference(dense(star), dense(nothing)) < 1e-5);
  }
}

TEST_CASE("StarGaussian: an empty hand stays empty, and what it learns of the arm is what a dense batch learns",
          "[star]") {
  const unsigned seed = 520;
  CAPTURE(seed);
  std::mt19937 random(seed);
  Star star = random_star(random);
  star.forget_payload();
  for (int k = 0; k < 30; ++k) {
    const int j = k % kJoints;
    const auto o = random_observation(random);
    const Dense before = dense(star);
    Vector row = Vector::Zero(kAll);
    row.head(kShared) = o.h;
    row.segment(first(j), kJointNuisances) = o.c;
    const Vector gain = before.covariance * row / (row.dot(before.covariance * row) + o.noise);
    star.observe(j, star.predict(j, o));
    const Dense after{before.mean + gain * (o.torque - row.dot(before.mean)),
                      before.covariance - gain * (before.covariance * row).transpose()};
    for (int i = 0; i < kArmShared; ++i) CHECK(star.mean()[i] == Approx(after.mean[i]).margin(1e-12));
    CHECK((star.nuisance_mean(j) - after.mean.segment<kJointNuisances>(first(j))).norm() < 1e-11);
    CHECK((star.covariance() - after.covariance.topLeftCorner<kShared, kShared>()).norm() < 1e-11);
    CHECK(star.mean().tail<kInertial>().isZero(0));
    CHECK(star.covariance().bottomRows<kInertial>().isZero(0));
    CHECK(star.joint(j).slope.bottomRows<kInertial>().isZero(0));
  }
}

TEST_CASE("StarGaussian: set_tilt() is the deviation of both angles, and of nothing else", "[star]") {
  Star star;
  star.set_arm(Arm::Constant(0.25));
  Matrix expected = star.covariance();
  star.set_tilt(0.04);
  expected(rme::kTilt, rme::kTilt) = expected(rme::kTilt + 1, rme::kTilt + 1) = 0.04 * 0.04;
  CHECK((star.covariance() - expected).norm() < 1e-15);
}

TEST_CASE("StarGaussian: what is known of a payload for certain says nothing of whether there is one", "[star]") {
  Star star;
  rme::InertialMatrix<double> factor = rme::InertialMatrix<double>::Zero();
  factor(0, 0) = 0.5;  // of the mass alone
  star.draw_payload(rme::InertialVector<double>::Unit(0), factor);
  CHECK(star.payload_is_none() == Approx(-0.5 * 4 - std::log(0.5)));
  CHECK(star.empty());
}

TEST_CASE("StarGaussian: numbers that overflow change nothing", "[star]") {
  const double endless = std::numeric_limits<double>::infinity();
  Star star;
  star.draw_payload(rme::InertialVector<double>::Unit(0), rme::InertialMatrix<double>::Identity());
  star.set_arm(Arm::Constant(endless));
  star.forget_payload();
  CHECK_FALSE(star.empty());
  CHECK(star.mass() == 1);
  Star other;
  other.draw_payload(rme::InertialVector<double>::Unit(0), rme::InertialMatrix<double>::Identity());
  const rme::Vector4<double> ones = rme::Vector4<double>::Ones();
  CHECK_FALSE(other.add<kPayload>(ones, rme::Matrix4<double>(endless * ones.asDiagonal().toDenseMatrix()),
                                  Star::Cross(Star::Cross::Zero())));
  CHECK(other.mass() == 1);
  CHECK(other.finite());
}

TEST_CASE("StarGaussian: finite() checks every part", "[star]") {
  const unsigned seed = 521;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const Star star = random_star(random);
  CHECK(star.finite());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int part = 0; part < 5; ++part) {
    CAPTURE(part);
    Star spoilt = star;
    rme::InertialVector<double> mean = rme::InertialVector<double>::Zero();
    rme::InertialMatrix<double> factor = rme::InertialMatrix<double>::Identity();
    if (part == 0) mean[3] = nan;
    if (part == 1) factor(2, 1) = nan;
    if (part < 2) spoilt.draw_payload(mean, factor);
    if (part == 2) spoilt.joint(1).mean[4] = nan;
    if (part == 3) spoilt.joint(1).slope(9, 0) = nan;
    if (part == 4) spoilt.joint(1).covariance(2, 3) = nan;
    CHECK_FALSE(spoilt.finite());
  }
}

/// One joint's random walk, seen through noise: the Riccati equation's fixed point is a root of P^2 + q P - q r.
template <typename Scalar>
void check_steady_state(double tolerance) {
  rme::StarGaussian<Scalar, 1> star;
  const double q = 4e-8, r = 9e-4;
  star.joint(0).covariance(rme::kOffset, rme::kOffset) = Scalar(0.0225);
  rme::JointObservation<Scalar> o{Scalar(0.1), rme::SharedVector<Scalar>::Zero(),
                                  rme::JointNuisanceVector<Scalar>::Unit(rme::kOffset), Scalar(r)};
  for (int k = 0; k < 20000; ++k) {
    star.joint(0).covariance(rme::kOffset, rme::kOffset) += Scalar(q);
    star.observe(0, star.predict(0, o));
  }
  const double fixed_point = (-q + std::sqrt(q * q + 4 * q * r)) / 2;
  CHECK(double(star.joint(0).covariance(rme::kOffset, rme::kOffset)) == Approx(fixed_point).epsilon(tolerance));
  CHECK(double(star.joint(0).mean[rme::kOffset]) == Approx(0.1).epsilon(tolerance));
  // A mass that does not change, seen n times through white noise: 1 / (1 / P + n h^2 / r).
  rme::StarGaussian<Scalar, 1> mass;
  rme::InertialMatrix<Scalar> factor = rme::InertialMatrix<Scalar>::Zero();
  factor(0, 0) = Scalar(0.9);
  mass.draw_payload(rme::InertialVector<Scalar>::Zero(), factor);
  o = {Scalar(9.81 * 1.5 * 0.4), rme::SharedVector<Scalar>::Unit(kPayload) * Scalar(9.81 * 0.4),
       rme::JointNuisanceVector<Scalar>::Zero(), Scalar(r)};
  const int n = 20000;
  for (int k = 0; k < n; ++k) mass.observe(0, mass.predict(0, o));
  const double variance = 1 / (1 / 0.81 + n * 9.81 * 9.81 * 0.16 / r);
  CHECK(double(mass.variance(kPayload)) == Approx(variance).epsilon(tolerance));
  CHECK(double(mass.mass()) == Approx(1.5 * (1 - variance / 0.81)).epsilon(tolerance));
}

TEST_CASE("StarGaussian: variances settle where the Riccati equation says", "[star]") {
  check_steady_state<double>(1e-9);
  check_steady_state<float>(2e-3);
}

}  // namespace
