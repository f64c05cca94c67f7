// Arms whose base does not stand upright: docs/embedding.md, "The base".
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <rme/estimator.hpp>
#include <synthetic_arm/panda.hpp>

#include "support/catch.hpp"

namespace {

using namespace rme;
using rme::examples::panda;
using Vector7 = JointVector<double, 7>;

constexpr double kPeriod = 1e-3;  // [s]
const Payload<double> kKilogram{1, {0.03, -0.02, 0.12}};

/// An arm that moves slowly, and is handed a kilogram after two seconds; the base has the orientation base(t).
/// @param sample  callable (kinematics in base axes, base, external torque, time) -> sample
/// @return the state after so many seconds
template <typename Base, typename Sample>
EstimatorState<double> believed(const EstimatorConfig<double, 7>& config, Base&& base, Sample&& sample,
                                double seconds = 6) {
  std::mt19937 random(391);
  std::normal_distribution<double> noise(0, 0.02);
  const auto estimator = std::make_unique<Estimator<double, 7>>(kPeriod, config);
  Vector7 filtered = Vector7::Zero();
  bool started = false;
  for (int k = 0; k < static_cast<int>(seconds / kPeriod); ++k) {
    const double t = k * kPeriod;
    Vector7 q = panda().ready, dq = Vector7::Zero();
    for (int j = 0; j < 7; ++j) {
      q[j] += 0.2 * std::sin(0.7 * t + j);
      dq[j] = 0.14 * std::cos(0.7 * t + j);
    }
    const examples::Kinematics<7> at = panda().kinematics(q);
    const Matrix3<double> B = base(t);
    const Vector3<double> gravity = B.transpose() * standard_gravity<double>();  // base axes
    Vector7 external = Vector7::NullaryExpr([&] { return noise(random); });
    if (k > 2000) external -= compensation_torque(kKilogram, at.jacobian, at.rotation, gravity);
    Proprioception<double, 7> in = sample(q, at, B, external);
    if (!started) filtered = in.tau_ext;
    started = true;
    filtered += 50 * kPeriod * (in.tau_ext - filtered);
    in.tau_ext = filtered;
    in.dq = dq;
    REQUIRE(estimator->update(in) == Status::Ok);
  }
  return estimator->state();
}

double mass_error(const EstimatorState<double>& state) {
  return std::abs(state.payload.mean[0] - kKilogram.mass);
}

Matrix3<double> tilted(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 0).normalized()).toRotationMatrix();
}

TEST_CASE("A base that is tilted for good: tau_ext + g(true) - g(assumed), and the true gravity, find the kilogram",
          "[host]") {
  const auto base = [](double) { return tilted(0.2); };
  const Vector3<double> truth = tilted(0.2).transpose() * standard_gravity<double>();
  // The robot's own model stands upright: it reports tau_ext + g(assumed) - g(true).
  examples::ArmModel<7> upright = panda(), true_model = panda();
  true_model.gravity_vector = truth;
  const auto assumed_minus_true = [&](const Vector7& q) {
    return Vector7(upright.dynamics(q, Vector7::Zero()).gravity - true_model.dynamics(q, Vector7::Zero()).gravity);
  };
  EstimatorConfig<double, 7> config;
  config.sensing = Sensing::LinkSide;
  config.gravity = truth;
  const auto corrected = [&](const Vector7& q, const auto& at, const auto&, const Vector7& external) {
    const Vector7 reported = external + assumed_minus_true(q);
    return Proprioception<double, 7>{Vector7(reported - assumed_minus_true(q)), at.jacobian, at.rotation, {}};
  };
  const auto reported = [&](const Vector7& q, const auto& at, const auto&, const Vector7& external) {
    return Proprioception<double, 7>{Vector7(external + assumed_minus_true(q)), at.jacobian, at.rotation, {}};
  };
  CHECK(mass_error(believed(config, base, corrected)) < 0.01);
  // With the gravity alone, the robot's model is still upright: rme has to find out, and is less certain.
  const auto deviation = [](const EstimatorState<double>& s) { return std::sqrt(s.payload.covariance(0, 0)); };
  CHECK(deviation(believed(config, base, reported)) > 2 * deviation(believed(config, base, corrected)));
}

/// What is believed on a base that is tilted by an angle of which nobody knows.
/// @param with_gravity_torque  whether the sample has the arm's gravity torque
EstimatorState<double> believed_on_tilted_base(double angle, bool with_gravity_torque, double seconds) {
  const Matrix3<double> tilt = tilted(angle);
  examples::ArmModel<7> upright = panda(), true_model = panda();
  true_model.gravity_vector = tilt.transpose() * standard_gravity<double>();
  std::array<examples::ArmModel<7>, 3> along = {panda(), panda(), panda()};
  for (std::size_t axis = 0; axis < 3; ++axis)
    along[axis].gravity_vector = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(axis));
  EstimatorConfig<double, 7> config;
  config.sensing = Sensing::LinkSide;
  const auto base = [&](double) { return tilt; };
  const auto sample = [&](const Vector7& q, const auto& at, const auto&, const Vector7& external) {
    const Vector7 rest = Vector7::Zero();
    Proprioception<double, 7> in{
        Vector7(external + upright.dynamics(q, rest).gravity - true_model.dynamics(q, rest).gravity), at.jacobian,
        at.rotation, rest};
    if (!with_gravity_torque) return in;
    in.gravity_torque.emplace();
    for (std::size_t axis = 0; axis < 3; ++axis)
      in.gravity_torque->col(static_cast<Eigen::Index>(axis)) = along[axis].dynamics(q, rest).gravity;
    return in;
  };
  return believed(config, base, sample, seconds);
}

TEST_CASE("An unknown tilt of 3 and 5 degrees: an empty hand is no disturbance", "[host]") {
  constexpr double kStillEmpty = 2;  // [s]
  for (const double angle : {0.052, 0.087})
    for (const bool with_gravity_torque : {true, false}) {
      const EstimatorState<double> state = believed_on_tilted_base(angle, with_gravity_torque, kStillEmpty);
      CAPTURE(angle, with_gravity_torque, state.health);
      CHECK(state.health < EstimatorState<double>::kHealthy);
      CHECK(state.probability[Mode::Disturbed] < 0.01);
      CHECK(state.empty());
    }
}

TEST_CASE("An unknown tilt of 2 to 7 degrees: with the arm's gravity torque in the sample, the kilogram is found",
          "[host]") {
  for (const double angle : {0.035, 0.052, 0.087, 0.122}) {
    CAPTURE(angle);
    CHECK(mass_error(believed_on_tilted_base(angle, true, 6)) < 0.02);
  }
}

TEST_CASE("An unknown tilt of 2 to 5 degrees: without the arm's gravity torque, the kilogram is found all the same",
          "[host]") {
  for (const double angle : {0.035, 0.052, 0.07, 0.087}) {
    CAPTURE(angle);
    const EstimatorState<double> state = believed_on_tilted_base(angle, false, 6);
    CHECK(state.held > 0.9);
    CHECK(mass_error(state) < 0.05);
  }
}

TEST_CASE("A base that tilts as it goes: with J and R in axes that are fixed to gravity, the kilogram is found",
          "[host]") {
  const auto base = [](double t) { return tilted(0.25 * std::sin(1.5 * t)); };
  EstimatorConfig<double, 7> config;
  config.sensing = Sensing::LinkSide;
  const auto fixed_to_gravity = [](const Vector7&, const auto& at, const Matrix3<double>& B, const Vector7& external) {
    Proprioception<double, 7> in;
    in.tau_ext = external;
    in.jacobian.topRows<3>() = B * at.jacobian.template topRows<3>();
    in.jacobian.bottomRows<3>() = B * at.jacobian.template bottomRows<3>();
    in.rotation = B * at.rotation;
    return in;
  };
  const auto in_base_axes = [](const Vector7&, const auto& at, const auto&, const Vector7& external) {
    return Proprioception<double, 7>{external, at.jacobian, at.rotation, {}};
  };
  const EstimatorState<double> found = believed(config, base, fixed_to_gravity);
  CHECK(mass_error(found) < 0.01);
  CHECK((found.payload.mean.tail<3>() - kKilogram.com).norm() < 0.005);
  CHECK(found.health < EstimatorState<double>::kHealthy);
  CHECK(found.swinging < 0.01);
  // In axes that tilt with the base, gravity's direction sways to and fro, as if the kilogram swung or somebody pushed
  // slowly; and the state says so.
  const EstimatorState<double> misled = believed(config, base, in_base_axes);
  CAPTURE(misled.payload.mean.tail<3>().transpose(), misled.health, misled.swing_frequency);
  CHECK((misled.payload.mean.tail<3>() - kKilogram.com).norm() > 0.01);
  CHECK(misled.swinging + misled.probability[Mode::Disturbed] > 0.9);
  CHECK(misled.health > EstimatorState<double>::kHealthy);
}

}  // namespace
