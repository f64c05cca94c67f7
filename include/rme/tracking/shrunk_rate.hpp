#pragma once
/// How much of a measured rate of change is real: for rates that stand in a regressor.
#include <algorithm>
#include <cmath>

namespace rme {

/// Where the noise of a rate is known from.
enum class RateNoise {
  Known,    ///< the caller knows its variance
  Learned,  ///< the caller knows a lower bound; the rest shows in how much the rate changes from block to block
};

/// Posterior of a rate of change that is measured once per block, x = a + noise, under a prior that is learned:
/// zero as long as nothing changes, wide while something does (docs/theory.md, "Noise in the regressor").
///
/// An error of a regressor does not average out. It makes what the regressor multiplies look smaller, block after
/// block. The posterior mean k x, k = s^2 / (s^2 + noise), has no such effect: given k x, the error a - k x is zero on
/// average. The prior's variance s^2 is the mean product of successive rates, which contains no noise; as long as it is
/// not significantly above zero, s^2 and k are exactly zero. A single rate far above the noise counts at once, so that
/// an arm that starts is not held back.
///
/// The noise of a torque raises its rate as well: what stands beside the torque, and is multiplied by a lag, has the
/// same error as the torque. That makes any torque look late while it changes. So the mean of a learned rate contains
/// little of the block's own noise: it follows only changes that are clearly larger (docs/theory.md (T73)). Real time:
/// a few operations, no loop, nothing allocates.
template <typename Scalar, RateNoise Source>
class ShrunkRate {
 public:
  /// Of the rate in the last block.
  struct Posterior {
    Scalar share = Scalar(0);     ///< k: the posterior mean is k x; from 0 to 1
    Scalar variance = Scalar(0);  ///< of a - k x, in units of x squared
    Scalar mean = Scalar(0);      ///< posterior mean of a: k x, or k times the rate that is followed (Learned)
  };

  /// Takes in the rate of the next block.
  /// @param rate   x
  /// @param noise  variance of x's noise, or a lower bound of it (RateNoise), >= 0
  Posterior update(Scalar rate, Scalar noise) noexcept {
    const Scalar square = rate * rate, change = rate - last_;
    const Scalar blend = Scalar(1) / static_cast<Scalar>(std::min(blocks_ + 1, kMemory));
    // Where the noise is known, an arm that is shaken at first does not pass for a noisier one.
    const Scalar slow = Scalar(1) / static_cast<Scalar>(Source == RateNoise::Known ? kNoiseMemory : blocks_ + 1);
    // The noise that the past has shown. White noise of dq is known better from second differences, but noise that is
    // correlated over some samples shows here alone. In smooth motion this is far below s^2.
    const Scalar usual = std::max(noise, change_);
    const bool known = Source == RateNoise::Known || blocks_ > kFew;
    if (follows_) {
      product_ += blend * (rate * last_ - product_);
      // Limited, so that a start does not pass for noise. Nothing is known yet at first.
      const Scalar most = known ? Scalar(kLargestChange) * usual : Scalar(0.5) * change * change;
      change_ += slow * (std::min(Scalar(0.5) * change * change, most) - change_);
    }
    square_ += blend * (square - square_);
    last_ = rate;
    follows_ = true;
    if (blocks_ < kNoiseMemory - 1) ++blocks_;

    const Scalar level = std::max(noise, change_);
    const Scalar scatter = level / std::sqrt(Scalar(2) / blend - Scalar(1));  // standard deviation of the mean product
    Scalar prior = std::max(Scalar(0), product_ - Scalar(kSignificant) * scatter);
    const Scalar variance = Source == RateNoise::Known ? noise : level;
    if (known && square > Scalar(kOutstanding * kOutstanding) * usual) prior = std::max(prior, square - variance);
    // A motion that is over is forgotten sooner: after kFew rates no larger than their noise, each one halves it.
    quiet_ = square < 4 * level ? std::min(quiet_ + 1, kFew + 1) : 0;
    if (quiet_ > kFew && prior > 0) {
      product_ *= Scalar(0.5);
      square_ += Scalar(0.5) * (square - square_);
    }
    Posterior out;
    if (prior > 0) out.share = prior / (prior + variance);
    // k need not be the best factor, so not k variance, but the mean square of (1 - k) a - k noise. In the first term
    // any rate counts, also one whose sign changes from block to block; but a^2 is not above x^2 + variance on average,
    // however large rates were before.
    const Scalar off = rate - followed_, unclear = Scalar(kClear * kClear) * level;
    followed_ += std::max(blend, off * off > unclear ? Scalar(1) - unclear / (off * off) : Scalar(0)) * off;
    out.mean = out.share * (Source == RateNoise::Known ? rate : followed_);
    const Scalar missing = Scalar(1) - out.share;
    const Scalar rates = std::min(std::max(Scalar(0), square_ - variance), square + variance);
    out.variance = out.share * out.share * variance + missing * missing * rates;
    return out;
  }
  /// The next rate has no predecessor: a time without samples lies in between. What was learned is kept.
  void interrupt() noexcept { follows_ = false; }

 private:
  static constexpr int kMemory = 12;           // of the means of products and squares, in blocks
  static constexpr int kNoiseMemory = 50;      // of what noise shows, in blocks
  static constexpr int kFew = 4;               // blocks after which change_ is known
  static constexpr double kSignificant = 4;    // standard deviations of the mean product that count as zero
  static constexpr double kOutstanding = 4.5;  // standard deviations of the noise beyond which a single rate is real
  static constexpr double kLargestChange = 9;  // in multiples of what is usual
  static constexpr double kClear = 2;          // standard deviations of the noise up to which a change is not followed

  int blocks_ = 0;        // at most kNoiseMemory - 1
  int quiet_ = 0;         // rates in a row that were no larger than their noise, at most kFew + 1
  bool follows_ = false;  // last_ is of the block before
  Scalar last_ = Scalar(0);
  Scalar followed_ = Scalar(0);  // rate whose small changes count as noise
  // Exponentially forgotten means of x_k x_k-1, of (x_k - x_k-1)^2 / 2, and of x_k^2.
  Scalar product_ = Scalar(0), change_ = Scalar(0), square_ = Scalar(0);
};

}  // namespace rme
