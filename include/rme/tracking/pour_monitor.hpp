#pragma once
/// Whether something is poured into what is held, or out of it, and how fast.
#include <algorithm>
#include <cmath>
#include <rme/core/types.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme {

/// What *steady* and *filling* learn from each other (docs/theory.md, "Hypotheses").
///
/// A slow pour hides in the nuisances: block by block, *steady* explains it nearly as well as *filling* does. But its
/// innovations then lean towards the payload's own torque, and do so block after block: their average shows it (T22).
/// So do offsets that drift as the drives warm up under a load. What tells them apart is how fast *steady* has to
/// follow.
///
/// Once *filling* is believed, its random walk becomes as wide as what is poured needs (T23). One that is wide enough
/// for any pour would explain a slow one worse than *steady* does.
template <typename Scalar, int Dofs>
class PourMonitor {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< one number per joint

  /// Probability that the next block is *filling* where the last one was *steady*, beside that of kTransitions.
  Scalar onset() const noexcept {
    using std::abs;
    return abs(lean_) > Scalar(kSure) && abs(followed_) > Scalar(kDrift) ? Scalar(kOnset) : Scalar(0);
  }
  /// The same, that *filling* ends: hardly anything is poured any more.
  Scalar end() const noexcept { return std::abs(pace_) < Scalar(kOver) ? Scalar(kEnd) : Scalar(0); }

  /// Standard deviation of the mass that is poured within a block, of the rated payload.
  /// @param duration  of the block [s]
  Scalar spread(Scalar duration) const noexcept {
    using std::sqrt;
    const Scalar wanted = Scalar(kSpread) * std::abs(pace_);
    return std::max(Scalar(kLeast), std::min(Scalar(kMost), wanted)) * sqrt(duration / Scalar(kBlock));
  }

  /// After a block that *steady* took in.
  /// @param block       of samples
  /// @param phi         inertial parameters that are held
  /// @param rated       payload [kg], > 0
  /// @param innovation  e [N m]
  /// @param variance    S of e [(N m)^2], > 0
  /// @param noise       R, its part that is noise [(N m)^2]
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
  /// After a block in which *filling* was likelier than all else.
  /// @param change    of its mass, of the rated payload
  /// @param duration  of the block [s]
  void follow_filling(Scalar change, Scalar duration) noexcept {
    pace_ += Scalar(kLearn) * (change * Scalar(kBlock) / duration - pace_);
  }
  /// *Steady* is not what is believed: its innovations say nothing.
  void forget_lean() noexcept { lean_ = followed_ = Scalar(0); }
  /// *Filling* is not what is believed: the next pour may be any.
  void forget_pace() noexcept { pace_ = Scalar(kMost / kSpread); }

 private:
  static constexpr double kBlock = 0.02;        // [s], for which the following are
  static constexpr double kKeep = 0.96;         // of an average, a block: half a second
  static constexpr double kMostOfOne = 3;       // standard deviations that a block counts for: one is not a pour
  static constexpr double kSure = 3;            // standard deviations, which chance makes once in 400 averages
  static constexpr double kDrift = 0.00003;     // of the rated payload: offsets drift as fast, 4.5 g/s on a Panda
  static constexpr double kOnset = 0.2;         // within five blocks, if the blocks do not contradict
  static constexpr double kOver = 0.0001;       // of the rated payload: 15 g/s
  static constexpr double kEnd = 0.03;          // within two thirds of a second
  static constexpr double kMost = 0.0027;       // of the rated payload: 8 g on a Panda, 0.4 kg/s if all go one way
  static constexpr double kLeast = kMost / 10;  // 40 g/s
  static constexpr double kSpread = 3;          // steps of a pour, to follow it within a few blocks
  static constexpr double kLearn = 0.1;         // of a new block, in the pace

  Scalar lean_ = Scalar(0);                // average of z, of variance 1 if nothing is poured
  Scalar followed_ = Scalar(0);            // by which steady follows along the load; mass in a block, of the rated one
  Scalar pace_ = Scalar(kMost / kSpread);  // of filling, likewise
};

}  // namespace rme
