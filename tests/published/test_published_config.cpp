#include <cmath>
#include <limits>
#include <string>

#include "published/pipelines.hpp"
#include "support/catch.hpp"

namespace {

using Config = rme::PublishedPipelineConfig<double>;
using Guess = rme::FixedGuess<double>;
using Pipeline = rme::PublishedPipeline<double, 7, Guess>;

/// Constructs a pipeline after `change` to the published settings; returns what it complains about.
template <typename Change>
std::string complaint(const Change& change, double dt = 0.001) {
  static const Guess zero;
  Config config;
  change(config);
  try {
    const Pipeline pipeline(dt, zero, config);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("PublishedPipelineConfig: the defaults are the numbers of the paper", "[published]") {
  const Config config;
  CHECK(config.detector.window == 0.5);
  CHECK(config.detector.edge_average == 0);  // single samples, 500 and 1
  CHECK(config.detector.stabilisation_threshold == 0.2);
  CHECK(config.detector.stabilisation_ratio == 0);
  CHECK(config.detector.activation_threshold >= 0.7);
  CHECK(config.detector.activation_threshold <= 1.1);
  CHECK(config.collection == 0.2);
  CHECK(config.damping == 1e-2);
  CHECK(config.standard_deviation == Eigen::Vector4d(0.5, 0.02, 0.02, 0.05));
  CHECK(config.likelihood.samples == 50);
  CHECK(config.likelihood.range_share == 0.25);
  CHECK(config.likelihood.least_sigma == 0.1);
  CHECK(config.inference.learning_rate == 0.025);
  CHECK(config.inference.gradient_norm == 1);
  CHECK(config.inference.max_steps == 2500);
  CHECK(config.inference.first_check == 700);
  CHECK(config.inference.check_interval == 10);
  CHECK(config.inference.small_change == 0.04);
  CHECK(config.inference.small_changes == 2);
  CHECK(complaint([](Config&) {}).empty());
}

TEST_CASE("PublishedPipelineConfig: a setting out of range is refused by name", "[published]") {
  const double nan = std::nan("");
  const auto unchanged = [](Config&) {};
  CHECK_THAT(complaint(unchanged, 0), contains("PublishedPipeline::dt"));
  CHECK_THAT(complaint(unchanged, nan), contains("PublishedPipeline::dt"));
  // At 80 Hz 200 ms are 16 samples, of which 20 cannot be taken.
  CHECK_THAT(complaint(unchanged, 0.0125), contains("PublishedPipelineConfig::collection"));
  CHECK_THAT(complaint([&](Config& c) { c.collection = nan; }), contains("PublishedPipelineConfig::collection"));
  CHECK_THAT(complaint([](Config& c) { c.collection = 1e9; }), contains("PublishedPipelineConfig::collection"));
  CHECK_THAT(complaint([](Config& c) { c.damping = 0; }), contains("PublishedPipelineConfig::damping"));
  CHECK_THAT(complaint([](Config& c) { c.standard_deviation[3] = 0; }),
             contains("PublishedPipelineConfig::standard_deviation"));
  CHECK_THAT(complaint([](Config& c) { c.gravity.setZero(); }), contains("PublishedPipelineConfig::gravity"));
  CHECK_THAT(complaint([&](Config& c) { c.gravity[1] = nan; }), contains("PublishedPipelineConfig::gravity"));
  CHECK_THAT(complaint([](Config& c) { c.detector.check_age[1] = 0.6; }),
             contains("MismatchDetectorConfig::check_age"));
  CHECK_THAT(complaint([](Config& c) { c.likelihood.samples = 1; }), contains("PublishedLikelihoodConfig::samples"));
  CHECK_THAT(complaint([](Config& c) { c.likelihood.samples = 1001; }), contains("PublishedLikelihoodConfig::samples"));
  CHECK_THAT(complaint([](Config& c) { c.likelihood.range_share = -1; }),
             contains("PublishedLikelihoodConfig::range_share"));
  CHECK_THAT(complaint([](Config& c) { c.likelihood.least_sigma = 0; }),
             contains("PublishedLikelihoodConfig::least_sigma"));
  CHECK_THAT(complaint([&](Config& c) { c.inference.learning_rate = nan; }),
             contains("StochasticViConfig::learning_rate"));
  CHECK_THAT(complaint([](Config& c) { c.inference.gradient_norm = 0; }),
             contains("StochasticViConfig::gradient_norm"));
  CHECK_THAT(complaint([](Config& c) { c.inference.max_steps = 0; }), contains("StochasticViConfig::max_steps"));
  CHECK_THAT(complaint([](Config& c) { c.inference.first_check = -1; }), contains("StochasticViConfig::first_check"));
  CHECK_THAT(complaint([](Config& c) { c.inference.check_interval = 0; }),
             contains("StochasticViConfig::check_interval"));
  CHECK_THAT(complaint([&](Config& c) { c.inference.small_change = nan; }),
             contains("StochasticViConfig::small_change"));
  CHECK_THAT(complaint([](Config& c) { c.inference.small_changes = 0; }),
             contains("StochasticViConfig::small_changes"));
  CHECK_THAT(complaint([](Config& c) { c.inference.initial_deviation[2] = 0; }),
             contains("StochasticViConfig::initial_deviation"));
  CHECK_THAT(complaint([](Config& c) { c.inference.evidence_draws = 0; }),
             contains("StochasticViConfig::evidence_draws"));
  // Gradients that are never shortened are an option of the solver.
  CHECK(complaint([](Config& c) { c.inference.gradient_norm = std::numeric_limits<double>::infinity(); }).empty());
}

}  // namespace
