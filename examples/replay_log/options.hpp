#pragma once
/// Command-line options of the programs that replay logs, in addition to those of recorded_arm.hpp.
#include <optional>
#include <string>
#include <vector>

#include "io/arguments.hpp"
#include "io/network_file.hpp"
#include "replay_log/replay.hpp"

namespace rme::examples {

constexpr const char* kSettingsUsage =
    "  --config C.json     settings of the estimator (rme/estimator_json.hpp); other options override them\n"
    "  --preset NAME       torque sensing: unknown (default), link_side, joint_friction, rough_model\n"
    "  --bandwidth W       bandwidth of the observer that tau_ext comes from [rad/s] (50); 0: none\n";
constexpr const char* kReplayUsage =
    "  --at T              call expect_change() at T, and end with the estimate one window later [s]\n"
    "  --window S          with --at: length of that window [s] (0.2)\n"
    "  --baseline B        T0:T1: the hand is known to be empty then, and declare_empty() is called at T1 [s]; auto\n"
    "                      (default) or none: no such call\n"
    "  --weights W.json    a network, whose guess is printed with --json at the end of each event\n";

/// An arm and the settings of its estimator.
template <int Dofs>
struct ArmSettings {
  RecordedArm<Dofs> arm;
  EstimatorConfig<double, Dofs> config;
  std::optional<UrdfChain> chain;  ///< of the arm; nothing: the built-in Panda
  bool corrected = false;          ///< the chain is that of the settings ("model") and not that of --urdf
  std::vector<std::string> notes;  ///< assumptions, one sentence each
};

/// Takes the options of kSettingsUsage out of `arguments`.
/// @throws ArgumentError naming what is wrong
template <int Dofs>
ArmSettings<Dofs> parse_settings(Arguments& arguments, const ArmRequest& arm);

/// The values of all options above.
template <int Dofs>
struct ReplayRequest {
  ReplayOptions<Dofs> options;
  std::optional<NetworkFile> weights;
  std::vector<std::string> notes;  ///< assumptions, one sentence each
};

/// Takes all options above out of `arguments`.
/// @throws ArgumentError naming what is wrong
template <int Dofs>
ReplayRequest<Dofs> parse_replay(Arguments& arguments, const ArmRequest& arm);

}  // namespace rme::examples
