#include <memory>
#include <rme/rme.hpp>

#include "headers/float_core/float_core.hpp"

namespace float_core {
namespace {
/// An arm of seven joints that no wrench is hidden from.
struct TrackedHand {
  rme::Estimator<float, 7> estimator{0.001};
  rme::Proprioception<float, 7> sample;
  TrackedHand() { sample.jacobian.leftCols<6>().setIdentity(); }
  bool hold(const Vector6& wrench, int ticks) {
    for (; ticks > 0; --ticks) {
      sample.tau_ext += 0.05F * (sample.jacobian.transpose() * wrench - sample.tau_ext);
      if (estimator.update(sample) != Status::Ok) return false;
    }
    return true;
  }
};

bool tracker_finds_carries_and_lets_go() {
  const auto hand = std::make_unique<TrackedHand>();
  const auto& state = hand->estimator.state();
  const rme::Payload<float> kilogram{1, {0.02F, 0, 0.1F}};
  const Vector6 weight = rme::payload_wrench(kilogram, hand->sample.rotation).vector();
  if (!hand->hold(Vector6::Zero(), 500) || !state.empty() || !hand->hold(weight, 200)) return false;
  if (state.empty() || !near(state.payload.mean[0], 1, 0.02) || !near(state.payload.mean[1], 0.02, 0.005)) return false;
  const auto carried = hand->estimator.compensation(hand->sample.jacobian, hand->sample.rotation);
  if (!near(carried.head<6>(), -weight, 0.3)) return false;
  auto bad = hand->sample;
  bad.tau_ext[3] = kNan;
  if (hand->estimator.update(bad) != Status::NonFiniteInput) return false;
  return hand->hold(Vector6::Zero(), 200) && state.empty() && state.event.kind == rme::EventKind::Removed;
}

bool tracker_is_not_fooled_by_a_push() {
  const auto hand = std::make_unique<TrackedHand>();
  const auto& state = hand->estimator.state();
  const Vector6 push = (Vector6() << 12, -9, 3, 0, 1, 0).finished();
  return hand->hold(Vector6::Zero(), 500) && hand->hold(push, 500) && near(state.payload.mean[0], 0, 0.05) &&
         hand->hold(Vector6::Zero(), 500) && state.empty() && state.event.kind == rme::EventKind::Pushed;
}

/// Of a hand that everything turns about its origin: J is not that of a chain of joints, so that levers are given.
bool host_carries_fades_and_judges() {
  rme::PayloadCompensationConfig<float, 7> config;
  config.levers = Vector7::Ones();
  config.fade_time = 0.1F;
  rme::PayloadCompensation<float, 7> payload(0.001, config);
  rme::Proprioception<float, 7> sample;
  sample.jacobian.leftCols<6>().setIdentity();
  const Vector6 weight = rme::payload_wrench(rme::Payload<float>{1, {0.02F, 0, 0.1F}}, sample.rotation).vector();
  const auto run = [&](const Vector6& wrench, int ticks) {
    for (; ticks > 0; --ticks) {
      sample.tau_ext += 0.05F * (sample.jacobian.transpose() * wrench - sample.tau_ext);
      if (payload.update(sample) != Status::Ok) return false;
    }
    return true;
  };
  if (!run(Vector6::Zero(), 500) || payload.hand_over().verdict != rme::HandOverVerdict::Empty) return false;
  if (!run(weight, 500) || !near(payload.torque().head<6>(), -weight, 0.3)) return false;
  const rme::HandOver<float> judged = payload.hand_over();
  if (!(judged.torque_error > 0) || !near(judged.body.mass, 1, 0.02)) return false;
  payload.enable(false);
  return run(weight, 101) && payload.torque().isZero(0);
}

}  // namespace

const std::vector<Case> kTracker = {
    {"Estimator: finds, carries, lets go", tracker_finds_carries_and_lets_go},
    {"Estimator: not fooled by a push", tracker_is_not_fooled_by_a_push},
    {"PayloadCompensation: carries, fades, judges", host_carries_fades_and_judges},
};

}  // namespace float_core
