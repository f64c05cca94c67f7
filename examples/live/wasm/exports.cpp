// The simulation for the page's worker: plain C functions, numbers and text.
#include <emscripten.h>

#include <memory>
#include <string>

#include "live/simulation.hpp"

namespace {

using rme::examples::Simulation;
using rme::examples::Snapshot;

std::unique_ptr<Simulation> simulation;
Snapshot snapshot;
std::string layout;

}  // namespace

extern "C" {

/// Begins anew.
EMSCRIPTEN_KEEPALIVE void live_start(double seed) {
  simulation = std::make_unique<Simulation>(static_cast<std::uint64_t>(seed));
}
/// Simulation::command().
EMSCRIPTEN_KEEPALIVE int live_command(const char* line) {
  return simulation->command(line);
}
EMSCRIPTEN_KEEPALIVE void live_step(int ticks) {
  for (int i = 0; i < ticks; ++i) simulation->step();
}
/// The numbers of the present tick, where live_layout() says.
EMSCRIPTEN_KEEPALIVE const double* live_values() {
  snapshot = simulation->snapshot();
  return snapshot.values.data();
}
/// "name offset count" of each field, a line each.
EMSCRIPTEN_KEEPALIVE const char* live_layout() {
  layout.clear();
  for (const Snapshot::Field& field : simulation->snapshot().fields)
    layout += field.name + ' ' + std::to_string(field.offset) + ' ' + std::to_string(field.count) + '\n';
  return layout.c_str();
}

}  // extern "C"
