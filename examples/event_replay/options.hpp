#pragma once
/// The command-line options that every program which replays logs understands.
#include <optional>
#include <rme/event_estimator_config.hpp>
#include <string>

#include "event_replay/replay.hpp"
#include "io/arguments.hpp"
#include "run_network/network_file.hpp"

namespace rme::examples {

constexpr const char* kReplayUsage =
    "  --at T              estimate from the samples [T, T + window), whatever the detector says [s]\n"
    "  --window S          how long samples are collected [s] (0.2)\n"
    "  --baseline B        auto (default), none, or T0:T1, when the hand is known to be empty [s]\n"
    "  --config C.json     settings of the estimator (rme/event_estimator_json.hpp); other options go before them\n"
    "  --weights W.json    a network's guess as the prior, in place of the fixed one\n"
    "  --preset NAME       sensing of the arm: unknown (default), link_side, joint_friction\n"
    "  --detector NAME     robust (default), or published: Algorithm 1 to the letter\n";

/// All that the options below say.
struct ReplayRequest {
  ReplayOptions options;
  std::optional<NetworkFile> weights;

  /// The prior that the command line asks for: a network's guess, or the fixed one.
  AnyPrior prior(const Log<7>& log) const { return weights ? AnyPrior(*weights, nominal_period(log.t)) : AnyPrior(); }
};

/// The settings that a file holds.
/// @throws ArgumentError naming the file and what is wrong
EventEstimatorConfig<double, 7> read_estimator(const std::string& file);

/// Writes settings that read_estimator() reads.
/// @throws LogError if the file cannot be written
void write_estimator(const std::string& file, const EventEstimatorConfig<double, 7>& settings);

/// Takes --config and --preset out of `arguments`.
/// @throws ArgumentError naming what is wrong
EventEstimatorConfig<double, 7> parse_estimator(Arguments& arguments);

/// Takes the options above out of `arguments`.
/// @throws ArgumentError naming what is wrong
ReplayRequest parse_replay_options(Arguments& arguments);

}  // namespace rme::examples
