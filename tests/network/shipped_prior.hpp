#pragma once
// The shipped weights as a prior, compiled apart: the estimator, JSON and the network in one file compile for a minute.
#include <cstddef>
#include <memory>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/sensing/sample_window.hpp>

/// The prior of examples/models/panda.json at 1 kHz. Remembers what it said last.
class ShippedPrior {
 public:
  ShippedPrior();
  rme::PayloadGaussian<double> operator()(const rme::SampleWindow<double, 7>& window, std::size_t count) const noexcept;

  /// Whether the network was asked the last time.
  bool asked() const noexcept;
  /// What came of it.
  const rme::PayloadGaussian<double>& said() const noexcept;

 private:
  struct State;
  std::shared_ptr<State> state_;  // the estimator copies its prior
};
