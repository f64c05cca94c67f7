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

}  // namespace

const std::vector<Case> kTracker = {
    {"Estimator: finds, carries, lets go", tracker_finds_carries_and_lets_go},
    {"Estimator: not fooled by a push", tracker_is_not_fooled_by_a_push},
};

}  // namespace float_core
