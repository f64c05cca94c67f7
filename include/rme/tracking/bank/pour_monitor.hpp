#pragma once
/// Finds out whether something is poured into the payload or out of it, and how fast.
#include <algorithm>
#include <cmath>
#include <rme/core/types.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme::bank {

/// Adapts the hypothesis *filling* to the pour: its transition probabilities and its process noise (docs/theory.md,
/// "Hypotheses").
///
/// A slow pour hides in the nuisances: in each block, *steady* explains it nearly as well as *filling* does. But the
/// innovations of *steady* then have a component along the payload's torque, with the same sign in block after block.
/// Their average shows the pour (T22). Offsets that drift while the drives warm up under a load look the same, but are
/// slower: *steady* then changes its mass by less per block.
///
/// While *filling* is the most likely, its process noise is adapted to the pour (T23). With a process noise that is
/// large enough for any pour, *filling* would explain a slow one worse than *steady* does. No call allocates.
template <typename Scalar, int Dofs>
class PourMonitor {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< one number per joint

  /// What is added to the transition probability from *steady* to *filling* in kTransitions.
  Scalar onset() const noexcept {
    using std::abs;
    return abs(lean_) > Scalar(kSure) && abs(followed_) > Scalar(kDrift) ? Scalar(kOnset) : Scalar(0);
  }
  /// What is added to the transition probability from *filling* to *steady*, when hardly anything is poured any more.
  Scalar end() const noexcept { return std::abs(pace_) < Scalar(kOver) ? Scalar(kEnd) : Scalar(0); }

  /// Standard deviation of the mass that is poured within a block, as a share of the rated payload (T23).
  /// @param duration  of the block [s], > 0
  Scalar spread(Scalar duration) const noexcept {
    using std::sqrt;
    const Scalar wanted = Scalar(kSpread) * std::abs(pace_);
    return std::max(Scalar(kLeast), std::min(Scalar(kMost), wanted)) * sqrt(duration / Scalar(kBlock));
  }

  /// Updates the averages of (T22). To be called after a block while *steady* is believed; all arguments are of
  /// *steady*.
  /// @param block       the block
  /// @param phi         mean of the inertial parameters
  /// @param rated       rated payload [kg], > 0
  /// @param innovation  e of each joint [N m]
  /// @param variance    S of each joint [(N m)^2], > 0
  /// @param noise       R of each joint, the part of S that is noise [(N m)^2]
  void follow_steady(const TorqueBlock<Scalar, Dofs>& block, const InertialVector<Scalar>& phi, Scalar rated,
                     const Vector& innovation, const Vector& variance, const Vector& noise) noexcept {
    using std::sqrt;
    Scalar along = Scalar(0), moved = Scalar(0), square = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      Scalar load = Scalar(0);
      for (int i = 0; i < kInertial; ++i) load += block.regressor(j, i) * phi[i];
      const Scalar share = load * innovation[j] / variance[j];
      along += share;
      moved += share * std::max(Scalar(0), Scalar(1) - noise[j] / variance[j]);
      square += load * load / variance[j];
    }
    const bool shows = square > Scalar(1e-12);
    const Scalar keep = Scalar(kKeep), most = Scalar(kMostOfOne), z = shows ? along / sqrt(square) : Scalar(0);
    lean_ = keep * lean_ + sqrt(1 - keep * keep) * std::max(-most, std::min(most, z));
    const Scalar mass = shows ? phi[0] * moved / square : Scalar(0);
    followed_ = keep * followed_ + (1 - keep) * mass / rated * (Scalar(kBlock) / block.duration);
  }
  /// Updates the pace of the pour. To be called after a block while *filling* is believed.
  /// @param change    change of its mass in this block, as a share of the rated payload
  /// @param duration  of the block [s], > 0
  void follow_filling(Scalar change, Scalar duration) noexcept {
    pace_ += Scalar(kLearn) * (change * Scalar(kBlock) / duration - pace_);
  }
  /// To be called instead of follow_steady() while *steady* is not believed: its innovations then show nothing.
  void forget_lean() noexcept { lean_ = followed_ = Scalar(0); }
  /// To be called instead of follow_filling() while *filling* is not believed: the next pour may have any pace.
  void forget_pace() noexcept { pace_ = Scalar(kMost / kSpread); }

 private:
  // Numbers per block are for blocks of kBlock. Masses are shares of the rated payload per block; g/s are for a Panda.
  static constexpr double kBlock = 0.02;        // [s]
  static constexpr double kKeep = 0.96;         // factor of an average per block: it looks half a second back
  static constexpr double kMostOfOne = 3;       // bound of a single z: one block alone shows no pour
  static constexpr double kSure = 3;            // bound of z's average in standard deviations: by chance, 1 in 400
  static constexpr double kDrift = 0.00003;     // mass that the drift of offsets may feign: 4.5 g/s
  static constexpr double kOnset = 0.2;         // what onset() adds: filling begins within about five blocks
  static constexpr double kOver = 0.0001;       // pace below which hardly anything is poured: 15 g/s
  static constexpr double kEnd = 0.03;          // what end() adds: filling ends within about 0.7 s
  static constexpr double kMost = 0.0027;       // largest spread(): 8 g per block, 0.4 kg/s if all have the same sign
  static constexpr double kLeast = kMost / 10;  // smallest spread(): 40 g/s
  static constexpr double kSpread = 3;          // spread() over pace: the pour is followed within a few blocks
  static constexpr double kLearn = 0.1;         // weight of a new block in the pace

  Scalar lean_ = Scalar(0);                // average of z, scaled to variance 1 if nothing is poured
  Scalar followed_ = Scalar(0);            // average of f (T22)
  Scalar pace_ = Scalar(kMost / kSpread);  // average change of the mass of *filling*
};

}  // namespace rme::bank
