#pragma once
/// Code that all hosts share: the compensation for a controller, its settings, and the events of the payload.
/// docs/embedding.md shows the parts between the marks; tests/docs/snippets.cmake checks that its copies are the same.

// <snippet compensation>
#include <rme/rme.hpp>
// </snippet>
// <snippet settings>
#include <fstream>
#include <rme/estimator_json.hpp>  // needs nlohmann-json
#include <stdexcept>
#include <string>
// </snippet>

namespace hosts {

// <snippet compensation>
/// Estimator and ramp, as a controller uses them. Construct it before the loop: that may throw. Nothing else throws or
/// allocates.
template <int Dofs>
class PayloadCompensation {
 public:
  explicit PayloadCompensation(double period, const rme::EstimatorConfig<double, Dofs>& config = {})
      : estimator_(period, config), ramp_(period) {}

  /// Each tick. A bad sample is refused, and torque() stays what it was.
  rme::Status update(const rme::Proprioception<double, Dofs>& sample) noexcept {
    const rme::Status status = estimator_.update(sample);
    return status == rme::Status::Ok ? ramp_.update(estimator_.compensation(sample.jacobian, sample.rotation)) : status;
  }
  const rme::JointVector<double, Dofs>& torque() const noexcept { return ramp_.torque(); }  // to add to yours [N m]
  rme::Estimator<double, Dofs>& estimator() noexcept { return estimator_; }
  /// Before a control loop whose torque starts at zero: the estimate stays, and its torque comes at the ramp's rate.
  void restart() noexcept { ramp_.reset(); }
  /// An empty hand. The torque steps to zero: only while the arm is not commanded, or where something else carries it.
  void reset() noexcept {
    estimator_.reset();
    ramp_.reset();
  }

 private:
  rme::Estimator<double, Dofs> estimator_;
  rme::CompensationRamp<double, Dofs> ramp_;  // keeps the compensation within the arm's torque rate
};
// </snippet>

// <snippet settings>
/// Settings from a file such as {"rated_payload": 12.5, "observer_bandwidth": 0, "torque_sign": "reaction"}. Missing
/// fields keep their defaults; unknown ones are refused by name.
template <int Dofs>
rme::EstimatorConfig<double, Dofs> read_settings(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  return rme::estimator_config_from_json<double, Dofs>(nlohmann::json::parse(in));
}
// </snippet>

// <snippet events>
/// Tells whether the hand may hold something else than when it was last asked; a push alone is no change.
class PayloadChanges {
 public:
  bool since_last(const rme::EstimatorState<double>& state) noexcept {
    const int events = state.event.number - seen_;
    seen_ = state.event.number;
    // Below 0 after the estimator's reset(). Of several events, only the last one's kind is known.
    return events < 0 || events > 1 || (events == 1 && state.event.kind != rme::EventKind::Pushed);
  }

 private:
  int seen_ = 0;
};
// </snippet>

}  // namespace hosts
