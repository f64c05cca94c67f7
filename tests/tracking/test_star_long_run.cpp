#include <array>
#include <cmath>
#include <random>
#include <rme/tracking/star_gaussian.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/random_pose.hpp>
#include <vector>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using oracle::Matrix;
using rme::kArmShared;
using rme::kInertial;
using rme::kPayload;
using rme::kTool;

/// Smallest eigenvalue of a covariance whose rows have been scaled to a diagonal of ones.
double least_correlation(const Matrix& covariance) {
  const Matrix symmetric = 0.5 * (covariance + oracle::transposed(covariance));
  const Matrix scale = covariance.diagonal().cwiseSqrt().cwiseInverse().asDiagonal();
  return oracle::eigenvalues(oracle::congruence(scale, symmetric))[0];
}

/// What the joints' torques depend on at a moment of the motion.
struct Regressors {
  Eigen::Matrix<double, kInertial, 7> h;
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
/// is a seventh of the work and shows the same. Every 5 s it sets out for another pose, turning; it never rests. The hand
/// is empty for a minute of every five.
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
  const rme::InertialMatrix<Scalar> deviation = numbers.template cast<Scalar>().asDiagonal();
  rme::StarGaussian<Scalar, n> star;
  const double arm[kArmShared] = {0.003, 0.03, 0.0075, 0.0075, 0.0075, 0.02, 0.02};
  star.set_arm(Eigen::Map<const Eigen::Matrix<double, kArmShared, 1>>(arm).cwiseAbs2().template cast<Scalar>());
  for (int j = 0; j < n; ++j) {
    star.joint(j).mean << 0, Scalar(0.2), Scalar(0.1), 0, 0, 0;
    star.joint(j).covariance.diagonal() << Scalar(0.0225), Scalar(0.01), Scalar(0.0025), Scalar(4e-4), Scalar(0.0144),
        Scalar(1e-4);
  }
  const Scalar keep = Scalar(0.99), noise = Scalar(0.03);
  std::array<Scalar, 1024> white;
  for (Scalar& w : white) w = noise * static_cast<Scalar>(normal(random));
  const auto draw = [&] { return white[static_cast<std::size_t>(random() % white.size())]; };
  const int last = blocks - 64 * 250;
  for (int k = 0; k < blocks; ++k) {
    const bool empty = k % 15000 < 3000 && k < last;
    if (empty) {
      star.forget_payload();
    } else if (star.empty()) {
      star.draw_payload(rme::InertialVector<Scalar>::Zero(), deviation);
    }
    const auto& pose = poses[static_cast<std::size_t>(k / 250) % poses.size()];
    const int j = k % n;
    auto& joint = star.joint(j);
    auto& V = joint.covariance;
    joint.mean[rme::kResidual] *= keep;
    joint.slope.col(rme::kResidual) *= keep;
    V.row(rme::kResidual) *= keep;
    V.col(rme::kResidual) *= keep;
    V(rme::kResidual, rme::kResidual) += (1 - keep * keep) * Scalar(4e-4);
    V(rme::kOffset, rme::kOffset) += Scalar(4e-8);
    V(rme::kCoulomb, rme::kCoulomb) += Scalar(4e-10);
    V(rme::kViscous, rme::kViscous) += Scalar(1e-10);
    const auto velocity = Scalar(pose.velocity[j]), direction = velocity > 0 ? Scalar(1) : Scalar(-1);
    rme::JointObservation<Scalar> o;
    o.h.setZero();
    o.h.template segment<kInertial>(kPayload) = pose.h.col(j).template cast<Scalar>();
    o.h.template segment<4>(kTool) = o.h.template segment<4>(kPayload);
    o.h[rme::kLag] = 300 * draw();
    o.h[rme::kTilt] = Scalar(pose.h(3, j));
    o.h[rme::kTilt + 1] = Scalar(pose.h(2, j));
    o.c << 1, -direction, -velocity, 1, 0, 0;
    o.noise = noise * noise;
    // With an offset of 0.1 N m and friction of 0.25 N m and 0.08 N m s/rad.
    o.torque = Scalar(0.1) - Scalar(0.25) * direction - Scalar(0.08) * velocity + draw();
    if (!empty) o.torque += o.h.template segment<kInertial>(kPayload).dot(truth);
    star.observe(j, star.predict(j, o));
  }
  REQUIRE(star.finite());
  CHECK(least_correlation(
            star.covariance().template topLeftCorner<rme::kHeldShared, rme::kHeldShared>().template cast<double>()) >
        0);
  for (int j = 0; j < n; ++j) {
    CAPTURE(j, star.joint(j).covariance);
    CHECK((star.joint(j).covariance.diagonal().array() > 0).all());
    CHECK(least_correlation(star.joint(j).covariance.template cast<double>()) > 0);
    CHECK(least_correlation(star.nuisance_covariance(j).template cast<double>()) > 0);
    const auto& V = star.joint(j).covariance;
    CHECK((V - V.transpose()).norm() < 1e-3 * V.norm());
  }
  // It still knows what it carries.
  CAPTURE(star.mean().transpose());
  const Scalar off = std::abs(star.mass() - truth[0]), spread = std::sqrt(star.variance(kPayload));
  CHECK(off < Scalar(0.005));
  CHECK(spread < Scalar(0.003));
}

TEST_CASE("StarGaussian: after ten million blocks in double the covariance is positive definite", "[star]") {
  check_long_run<double>(10'000'000, 517);
}

TEST_CASE("StarGaussian: after a million blocks in float the covariance is positive definite", "[star]") {
  check_long_run<float>(1'000'000, 518);
}

}  // namespace
