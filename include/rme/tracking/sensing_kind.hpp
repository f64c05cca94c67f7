#pragma once
/// The kinds of torque sensing, as rows of a table.
#include <array>
#include <cstddef>
#include <cstdint>

namespace rme {

/// Kinds of torque sensing. The tracker finds out which kind an arm has, and remembers it.
enum class Sensing : std::uint8_t {
  LinkSide,       ///< sensed behind the gears: tau_ext contains no joint friction
  JointFriction,  ///< tau_ext contains joint friction
  RoughModel,     ///< friction, and large errors of the arm's model: motor currents, heavy gears, quick motion
};
inline constexpr std::size_t kSensings = 3;  ///< number of kinds of torque sensing

/// What distinguishes one kind from another: which nuisances a joint has, how large they are, and how they change.
/// docs/theory.md, "Numbers", says where each number is from.
struct SensingKind {
  double evidence;          ///< log probability of the kind before the first sample, up to a constant [nats]
  double friction;          ///< share of ArmPrior's friction that tau_ext contains
  double lag;               ///< standard deviation of the lag beyond the stated observer, in its time constants
  double tool;              ///< standard deviation of the tool's mass error, as a share of the rated payload
  double residual;          ///< standard deviation of the residual at first, times the joint's scale [N m]
  double least_residual;    ///< its lower bound
  double largest_residual;  ///< its upper bound
  double way;               ///< correlation length of the residual [rad]
  double turn;              ///< how much of the residual is drawn anew when a joint turns over
  double creep;             ///< rate at which stiction is drawn anew while the arm moves [1/s]
  double creep_at_rest;     ///< the same while it rests
  double stiction;          ///< variance of the stiction, in residual variances
  double turn_noise;        ///< noise of a joint that starts, stops or turns back, in residual variances
  double stop_noise;        ///< further noise of such a joint at rest
  double slow;              ///< velocity at which a joint is half at rest [rad/s]; 0: it rests or moves
  double own;               ///< weight of a joint's own innovations in learning its residual
  double common;            ///< weight of all joints' innovations
  double size;              ///< weight of the innovations' size, beside their correlation
  double memory;            ///< factor per block of the average of innovations
  double settles;           ///< blocks of motion from which the residual is learned more slowly
  double change;            ///< probability per block that the payload changes
  double takes_up;          ///< probability per block that an empty hand begins to take up something
  double jolt;              ///< probability per block that something shakes single joints
  double slowly;            ///< what begins softly, relative to an arm whose torque shows it: pours, contact
  double faint;             ///< share of what pulls lightly, relative to an arm whose torque shows it: touches, swings
  double depth;             ///< log odds at which a story is given up [nats]
  double tails;             ///< degrees of freedom of the noise, as stories are weighed by it; 0: it is Gaussian
  double spread;            ///< reported standard deviations, relative to the filters'
  double gain;              ///< relative error of the torque: no payload is known better
  double quiet;             ///< innovation squared per joint below which a block is explained; 0: never
  bool draws;               ///< one block shows a new payload; otherwise a block of a change shows nothing
};

/// The kinds, in the order of Sensing.
inline constexpr std::array<SensingKind, kSensings> kSensingKinds = {{
    // evidence friction lag tool; residual least largest way; turn creep creep_at_rest stiction turn_noise stop_noise
    // slow; own common size memory settles; change takes_up jolt slowly faint depth; tails spread gain quiet draws
    {-8, 0, 0.05, 0.003, 0.015, 0.005, 0.1,  0.7, 0, 0,  0, 0, 0,    0, 0,   4,
     0,  0, 0.96, 100,   1e-3,  1e-6,  1e-3, 1,   1, 20, 0, 1, 1e-3, 2, true},
    {0, 1, 0.05, 0.003, 0.015, 0.005, 0.1,  0.7, 0, 0.05, 0, 0, 0,    0,   0,   4,
     0, 0, 0.96, 100,   1e-3,  2e-4,  1e-3, 1,   0, 20,   0, 1, 1e-3, 1.5, true},
    {-40, 1,   0,   0.003, 0.3,     0.1,    4,    1.2,  1, 0.5, 0.5, 16,  6,    20, 0.003, 0,
     1,   0.5, 0.9, 1e9,   1.25e-5, 2.5e-5, 1e-2, 0.01, 0, 25,  8,   1.5, 0.02, 0,  false},
}};

/// The row of a kind.
constexpr const SensingKind& kind_of(Sensing sensing) noexcept {
  return kSensingKinds[static_cast<std::size_t>(sensing)];
}

}  // namespace rme
