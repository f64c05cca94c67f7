#pragma once
/// The command-line options that every program which replays logs understands.
#include <optional>
#include <rme/estimator_config.hpp>
#include <string>

#include "io/arguments.hpp"
#include "replay_log/replay.hpp"
#include "run_network/network_file.hpp"

namespace rme::examples {

constexpr const char* kReplayUsage =
    "  --at T              the host says at T that the payload changes; ends with what is known a window later [s]\n"
    "  --window S          with --at: how long after it [s] (0.2)\n"
    "  --baseline B        auto (default), none, or T0:T1, when the hand is known to be empty [s]\n"
    "  --config C.json     settings of the estimator (rme/estimator_json.hpp); other options go before them\n"
    "  --weights W.json    a network, whose guess each final estimate is printed with\n"
    "  --preset NAME       sensing of the arm: unknown (default), link_side, joint_friction\n"
    "  --rated-payload M   heaviest payload of the arm [kg] (3)\n";

/// All that the options above say.
struct ReplayRequest {
  ReplayOptions options;
  std::optional<NetworkFile> weights;
};

/// Takes --config, --preset and --rated-payload out of `arguments`.
/// @throws ArgumentError naming what is wrong
EstimatorConfig<double, 7> parse_estimator_config(Arguments& arguments);

/// Takes the options above out of `arguments`.
/// @throws ArgumentError naming what is wrong
ReplayRequest parse_replay(Arguments& arguments);

}  // namespace rme::examples
