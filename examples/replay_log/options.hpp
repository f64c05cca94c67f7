#pragma once
/// The command-line options that every program which replays logs understands, beside those of recorded_arm.hpp.
#include <optional>
#include <string>
#include <vector>

#include "io/arguments.hpp"
#include "replay_log/replay.hpp"
#include "run_network/network_file.hpp"

namespace rme::examples {

constexpr const char* kSettingsUsage =
    "  --config C.json     settings of the estimator (rme/estimator_json.hpp); other options override them\n"
    "  --preset NAME       torque sensing: unknown (default), link_side, joint_friction, rough_model\n"
    "  --bandwidth W       of the observer that tau_ext comes from [rad/s] (50); 0: none\n";
constexpr const char* kReplayUsage =
    "  --at T              trigger() at T; ends with the estimate one window later [s]\n"
    "  --window S          with --at: that window [s] (0.2)\n"
    "  --baseline B        auto (default), none, or T0:T1, when the hand is known to be empty [s]\n"
    "  --weights W.json    a network, whose guess is printed with the estimate at the end of each event\n";

/// An arm and the settings of its estimator.
template <int Dofs>
struct ArmSettings {
  RecordedArm<Dofs> arm;
  EstimatorConfig<double, Dofs> config;
  std::optional<UrdfChain> chain;  ///< that the arm was made of; nothing: the Panda
  bool corrected = false;          ///< the chain is not --urdf's but the settings' own ("model")
  std::vector<std::string> notes;  ///< what was assumed, one sentence each
};

/// Takes the first options above out of `arguments`.
/// @throws ArgumentError naming what is wrong
template <int Dofs>
ArmSettings<Dofs> parse_settings(Arguments& arguments, const ArmRequest& arm);

/// All that the options above say.
template <int Dofs>
struct ReplayRequest {
  ReplayOptions<Dofs> options;
  std::optional<NetworkFile> weights;
  std::vector<std::string> notes;  ///< what was assumed, a sentence each
};

/// Takes all options above out of `arguments`.
/// @throws ArgumentError naming what is wrong
template <int Dofs>
ReplayRequest<Dofs> parse_replay(Arguments& arguments, const ArmRequest& arm);

}  // namespace rme::examples
