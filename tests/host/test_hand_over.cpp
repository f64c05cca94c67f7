#include <cmath>
#include <limits>
#include <random>
#include <rme/core/payload.hpp>
#include <rme/host/hand_over.hpp>
#include <rme/host/largest_levers.hpp>
#include <string>
#include <synthetic_arm/panda.hpp>

#include "support/catch.hpp"

namespace {

using namespace rme;
using rme::examples::panda;
using Vector7 = JointVector<double, 7>;

TEST_CASE("largest_torque_error: one joint with a lever, by hand", "[host]") {
  // A mass of 2 kg +- 10 g, 0.1 m out along z and known there; 0.5 m lever. Then the torque is m g (0.5 + 0.1) at most,
  // wrong by 0.01 * 9.81 * 0.6 for one standard deviation. If instead only z is uncertain by 20 mm: 2 * 9.81 * 0.02.
  constexpr double kChi = 3.0802;  // of chi^2 with four degrees of freedom, 95 %: 9.4877
  PayloadGaussian<double> payload;
  payload.mean << 2, 0, 0, 0.1;
  payload.covariance.setZero();
  payload.covariance(0, 0) = 1e-4;
  const JointVector<double, 1> lever(0.5);
  CHECK(largest_torque_error(payload, lever, 9.81)[0] == Approx(kChi * 0.01 * 9.81 * 0.6));
  payload.covariance.setZero();
  payload.covariance(3, 3) = 4e-4;
  CHECK(largest_torque_error(payload, lever, 9.81)[0] == Approx(kChi * 2 * 9.81 * 0.02));
  // Uncertain in both, but m r is known: the error of the mass acts at the end-effector origin.
  payload.covariance(0, 0) = 1e-4;
  payload.covariance(3, 3) = 1e-4 * 0.05 * 0.05;
  payload.covariance(0, 3) = payload.covariance(3, 0) = -1e-4 * 0.05;
  CHECK(largest_torque_error(payload, lever, 9.81)[0] == Approx(kChi * 0.01 * 9.81 * 0.5).epsilon(1e-6));
}

TEST_CASE("largest_torque_error: as often as it says, no pose of a Panda is off by more", "[host]") {
  const unsigned seed = 372;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<examples::Kinematics<7>> poses;
  for (int k = 0; k < 400; ++k)
    poses.push_back(panda().kinematics(
        Vector7::NullaryExpr([&] { return std::uniform_real_distribution<double>(-3.1, 3.1)(random); })));
  const Vector7 levers = largest_levers(poses[0].jacobian);
  int exceeded = 0, tight = 0;
  const int kTrials = 300;
  for (int trial = 0; trial < kTrials; ++trial) {
    // A truth, and what is believed of it: mass and first moment with errors that are correlated.
    Matrix4<double> factor = Matrix4<double>::NullaryExpr([&] { return 0.01 * normal(random); });
    const Vector4<double> error =
        factor * Vector4<double>(normal(random), normal(random), normal(random), normal(random));
    PayloadGaussian<double> believed;
    believed.mean << 1.5, 0.03, -0.05, 0.12;
    Matrix4<double> per_com = Matrix4<double>::Identity();  // (m, r) by (m, m r)
    for (int i = 1; i < 4; ++i) {
      per_com(i, 0) = -believed.mean[i] / 1.5;
      per_com(i, i) = 1 / 1.5;
    }
    believed.covariance = per_com * factor * factor.transpose() * per_com.transpose();
    const Vector7 bound = largest_torque_error(believed, levers, 9.81);
    double largest = 0;
    for (const auto& at : poses) {
      // Torque of the error: linear in mass and first moment.
      const Eigen::Vector3d weight(0, 0, -9.81);
      Vector6<double> wrench;
      wrench << error[0] * weight, (at.rotation * error.tail<3>()).cross(weight);
      largest = std::max(largest, (at.jacobian.transpose() * wrench).cwiseAbs().cwiseQuotient(bound).maxCoeff());
    }
    exceeded += largest > 1;
    tight += largest > 0.3;
  }
  CHECK(exceeded <= 0.05 * kTrials);
  CHECK(tight > 0.3 * kTrials);  // the bound is not idle
}

EstimatorState<double> sure() {
  EstimatorState<double> state;
  state.held = 1;
  state.probability = {};
  state.probability[Mode::Held] = 1;
  state.payload = PayloadGaussian<double>::independent({1.2, 0.02, 0.01, 0.15}, {0.002, 0.001, 0.001, 0.003});
  const InertialParameters<double> body =
      InertialParameters<double>::of_body({1.2, {0.02, 0.01, 0.15}}, Matrix3<double>::Identity() * 0.002);
  state.inertial.mean = body.vector();
  return state;
}

TEST_CASE("judge_hand_over: mass and centre of mass are judged, and what stands against it is said", "[host]") {
  const Vector7 levers = Vector7::Constant(0.8);
  HandOver<double> judged = judge_hand_over(sure(), levers, 9.81, 0.3);
  CHECK(judged.ready());
  CHECK(judged.body.mass == Approx(1.2));
  CHECK(judged.body.payload().com.z() == Approx(0.15));
  CHECK(judged.torque_error > 0.05);
  CHECK(judged.torque_error < 0.3);
  CHECK(judge_hand_over(sure(), levers, 9.81, 0.05).verdict == HandOverVerdict::Uncertain);

  // The mass is as certain as before, the centre of mass is not: 1.2 * 9.81 * 0.05 * 3.08 = 1.8 N m.
  EstimatorState<double> state = sure();
  state.payload.covariance(3, 3) = 0.05 * 0.05;
  judged = judge_hand_over(state, levers, 9.81, 0.3);
  CHECK(judged.verdict == HandOverVerdict::Uncertain);
  CHECK(judged.torque_error == Approx(1.81).epsilon(0.02));

  state = sure();
  state.held = 0.9;
  CHECK(judge_hand_over(state, levers, 9.81, 0.3).verdict == HandOverVerdict::Empty);
  state = sure();
  state.changing = true;
  CHECK(judge_hand_over(state, levers, 9.81, 0.3).verdict == HandOverVerdict::Changing);
  state = sure();
  state.probability[Mode::Held] = 0.2;
  state.probability[Mode::Disturbed] = 0.8;
  CHECK(judge_hand_over(state, levers, 9.81, 0.3).verdict == HandOverVerdict::Changing);
  Vector7 unknown = levers;
  unknown[2] = std::numeric_limits<double>::infinity();
  CHECK(judge_hand_over(sure(), unknown, 9.81, 0.3).verdict == HandOverVerdict::NotRevolute);
  state = sure();
  state.payload.covariance.setConstant(std::nan(""));
  CHECK_FALSE(judge_hand_over(state, levers, 9.81, 0.3).ready());
}

TEST_CASE("judge_hand_over: the joint named is the one that may be off by most", "[host]") {
  Vector7 levers = Vector7::Constant(0.3);
  levers[4] = 0.9;
  CHECK(judge_hand_over(sure(), levers, 9.81, 0.3).joint == 4);
}

TEST_CASE("HandOverVerdict: every one has a sentence", "[host]") {
  for (int i = 0; i <= static_cast<int>(HandOverVerdict::NotRevolute); ++i)
    CHECK(std::string(to_string(static_cast<HandOverVerdict>(i))) != "unknown");
  CHECK(std::string(to_string(static_cast<HandOverVerdict>(99))) == "unknown");
}

}  // namespace
