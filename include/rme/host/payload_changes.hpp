#pragma once
/// Whether the payload may have changed since one last looked.
#include <rme/estimator_state.hpp>
#include <rme/tracking/event_monitor.hpp>

namespace rme {

/// For code that looks at the state now and then, such as a thread that prints. One object for each such place.
class PayloadChanges {
 public:
  /// Whether the hand may hold something else than at the last call; a push alone is no change.
  /// @param state  a copy of the estimator's
  template <typename Scalar>
  bool since_last(const EstimatorState<Scalar>& state) noexcept {
    const int events = state.event.number - seen_;
    seen_ = state.event.number;
    // Below 0 after the estimator's reset(). Of several events, only the last one's kind is known.
    return events < 0 || events > 1 || (events == 1 && state.event.kind != EventKind::Pushed);
  }

 private:
  int seen_ = 0;
};

}  // namespace rme
