#include <rme/host/payload_changes.hpp>

#include "support/catch.hpp"

namespace {

using namespace rme;

TEST_CASE("PayloadChanges: tells of each event but a push, once, and of a reset", "[host]") {
  PayloadChanges changes;
  EstimatorState<double> state;
  CHECK_FALSE(changes.since_last(state));
  state.event.number = 1;
  state.event.kind = EventKind::Attached;
  CHECK(changes.since_last(state));
  CHECK_FALSE(changes.since_last(state));
  state.event.number = 2;
  state.event.kind = EventKind::Pushed;
  CHECK_FALSE(changes.since_last(state));
  state.event.number = 4;  // of the third, nothing is known
  CHECK(changes.since_last(state));
  state.event.number = 0;
  CHECK(changes.since_last(state));
  CHECK_FALSE(changes.since_last(state));
}

}  // namespace
