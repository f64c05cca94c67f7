#pragma once
/// Other methods' estimates of a payload's mass, on the same recordings and with the same knowledge as rme.
#include <string>
#include <vector>

#include "replay_log/options.hpp"
#include "rivals/least_squares.hpp"

namespace rme::examples {

/// An estimate of the mass in the hand at one instant.
struct MassAt {
  double t;          ///< [s], as in the log
  double mass;       ///< [kg]
  double deviation;  ///< its standard deviation [kg]; NaN if the method states none
};

/// A method and what it estimates during a log. A method that needs the whole log has one estimate, at its end.
struct Rival {
  std::string name;
  std::vector<MassAt> masses;
};

/// What a rival is given.
template <int Dofs>
struct RivalInput {
  const Log<Dofs>& log;
  const Samples<Dofs>& samples;  ///< of the log; they may contain simulated payloads
  const ArmSettings<Dofs>& settings;
  const Log<Dofs>* empty;      ///< log of the empty hand, which offset and friction come from; null: they are unknown
  const NetworkFile* network;  ///< of the published pipeline; null: it is left out
  bool simulated;              ///< the samples contain a simulated payload, which is not in log.tau
};

/// What each of them estimates:
///
/// - "recursive least squares": (m, m r) from the blocks of the last 5 s, on torque minus tare
/// - "observer-matched": ten inertial parameters from the samples of the last 5 s, on torque minus tare. The regressor
///   passes the observer's own filter, so that torque and regressor lag alike. What the method finds in the log of the
///   empty hand, a virtual object, is subtracted: Kurdas, Hamad, Vorndamme, Mansfeld, Abdolshah and Haddadin, "Online
///   Payload Identification for Tactile Robots Using the Momentum Observer", ICRA 2022
/// - "published pipeline": PublishedPipeline (docs/theory.md), on torque minus tare
/// - "KDL's wrench": if the log has measured torque: the force along gravity that Orocos KDL's
///   ChainExternalWrenchEstimator finds at the tip from the torque minus tare, averaged over 5 s, divided by gravity
/// - "batch least squares": (m, m r), offsets and friction from the whole log, after it. It does not run online
///
/// @throws LogError if the log of the empty hand has other columns
template <int Dofs>
std::vector<Rival> run_rivals(const RivalInput<Dofs>& input);

}  // namespace rme::examples
