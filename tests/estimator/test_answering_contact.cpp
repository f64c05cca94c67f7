#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <rme/estimator.hpp>

#include "support/catch.hpp"
#include "synthetic_arm/panda.hpp"

namespace {

using Torque = rme::JointVector<double, 7>;

/// A Panda at rest, with an observer of 50 rad/s and a torque sensor's noise. A force acts on the hand, in the direction of
/// gravity: it grows from nothing within a second.
struct Held {
  double largest = 0;  ///< force on the hand from then on [N]
  double mass = 0;     ///< believed at the end [kg]
};
/// @param force    without any compensation [N]
/// @param answers  the hand cannot move: each newton of compensation is a newton more
/// @param known    whether the estimator knows that the torque contains no joint friction
Held hold(double force, bool answers, bool known, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto pose = rme::examples::panda().kinematics(rme::examples::panda().ready);
  rme::EstimatorConfig<double, 7> config;
  if (known) config.sensing = rme::Sensing::LinkSide;
  const auto estimator = std::make_unique<rme::Estimator<double, 7>>(0.001, config);
  Torque observed = Torque::Zero(), offset;
  for (int j = 0; j < 7; ++j) offset[j] = 0.05 * normal(random);
  Torque answer = Torque::Zero();  // after drive and contact: 10 ms
  Held out;
  for (int tick = 0; tick < 12000; ++tick) {
    const double t = 1e-3 * tick, grown = std::min(1.0, std::max(0.0, t - 2));
    const Torque compensation = estimator->compensation(pose.jacobian, pose.rotation);
    if (answers) answer -= 0.1 * (compensation + answer);
    rme::Vector6<double> w = rme::Vector6<double>::Zero();
    w[2] = -force * grown;
    w[4] = 0.03 * force * grown;  // 3 cm beside the flange's origin
    const double carried = 9.81 * estimator->state().payload.mean[0];
    if (t > 3) out.largest = std::max(out.largest, force * grown + (answers ? carried : 0));
    rme::Proprioception<double, 7> sample;
    sample.jacobian = pose.jacobian;
    sample.rotation = pose.rotation;
    Torque torque = pose.jacobian.transpose() * w + answer + offset;
    for (int j = 0; j < 7; ++j) {
      torque[j] += 0.05 * normal(random);
      sample.dq[j] = 1e-4 * normal(random);
    }
    observed += 0.05 * (torque - observed);
    sample.tau_ext = observed;
    REQUIRE(estimator->update(sample) == rme::Status::Ok);
  }
  out.mass = estimator->state().payload.mean[0];
  return out;
}

TEST_CASE("Estimator: what answers to the compensation is not carried, and compensation does not pump it up",
          "[contact]") {
  for (const bool known : {true, false}) {
    for (const double force : {1.2, 2.3, 7.0}) {
      double worst = 0, sum = 0;
      const unsigned runs = 6;
      for (unsigned seed = 1; seed <= runs; ++seed) {
        const Held held = hold(force, true, known, seed);
        worst = std::max(worst, held.largest);
        sum += held.largest;
      }
      CAPTURE(known, force, worst, sum / runs);
      CHECK(sum / runs < force + (force < 5 ? 1.5 : 3));
      CHECK(worst < force + 4);  // without the answer in the model, 30 N
    }
  }
}

TEST_CASE("Estimator: a weight that grows in the same way does not answer, and is carried", "[contact]") {
  for (const bool known : {true, false}) {
    for (const double force : {5.0, 10.0}) {
      for (unsigned seed = 1; seed <= 4; ++seed) {
        CAPTURE(known, force, seed);
        CHECK(hold(force, false, known, seed).mass == Approx(force / 9.81).epsilon(0.15));
      }
    }
  }
}

}  // namespace
