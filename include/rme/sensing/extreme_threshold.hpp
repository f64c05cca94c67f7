#pragma once
/// A threshold that is exceeded as seldom as is stated. In: the largest values of a statistic in windows of a second.
/// Out: the threshold, (T63) and (T64).
#include <algorithm>
#include <cmath>

namespace rme {

/// The threshold of a statistic that exceeds it as seldom as is stated, from the largest values that it has shown.
///
/// The maxima x of windows of one second follow a law of extremes, whatever the correlation time of the statistic. If
/// the variances that the statistic is divided by were known, it would be Gumbel's, with location mu and scale beta.
/// But an arm's error is not equally large in all motions, and the largest maxima come from the motions in which it is
/// larger than its learned variance says: a variance that is learned from 2 n motions makes a tail of exponent n
/// (docs/theory.md (T63)),
///
///     P(max > x) = (1 + (x - mu) / (n beta))^-n
///
/// mu and beta come from the mean and the variance of the maxima. The prior is that of chi-square with `Degrees`
/// degrees of freedom. No call allocates.
template <typename Scalar, int Degrees>
class ExtremeThreshold {
 public:
  /// @param per_window  stated probability that the threshold is exceeded in a window, above 0 and below 1
  explicit ExtremeThreshold(double per_window) noexcept : reach_(kTail * (std::pow(per_window, -1.0 / kTail) - 1)) {
    // Wilson and Hilferty's quantiles of chi-square. The largest of 50 independent numbers is below mu with
    // probability 1 / e, and below mu + beta with exp(-1 / e).
    const auto quantile = [](double z) {
      const double a = 2.0 / (9.0 * Degrees), root = 1 - a + z * std::sqrt(a);
      return Degrees * root * root * root;
    };
    const double mu = quantile(kLocation), beta = quantile(kLocationAndScale) - mu;
    mean_ = mu + kEuler * beta;
    variance_ = kPi * kPi / 6 * beta * beta;
    solve();
  }
  /// Takes in the largest value of a window in which nothing happened.
  void learn(double largest) noexcept {
    windows_ = std::min(windows_ + 1, kMemory);
    const double blend = 1.0 / windows_, away = largest - mean_;
    mean_ += blend * away;
    variance_ += blend * ((1 - blend) * away * away - variance_);
    solve();
  }
  Scalar threshold() const noexcept { return threshold_; }  ///< exceeded as seldom as is stated
  /// mu: exceeded about once in a window; not below what chi-square is on average.
  Scalar usual() const noexcept { return usual_; }

  static constexpr double kWindow = 1;  ///< duration of a window [s]

 private:
  static constexpr double kEuler = 0.5772156649015329, kPi = 3.141592653589793;
  static constexpr double kTail = 10;  // n
  static constexpr int kPrior = 20;    // windows that the prior counts as
  static constexpr int kMemory = 600;  // windows that are remembered: 10 min
  // Standard normal quantiles of exp(-1 / 50) and of exp(-1 / (50 e)): 50 independent numbers in a window.
  static constexpr double kLocation = 2.058, kLocationAndScale = 2.441;

  void solve() noexcept {
    const double beta = std::sqrt(6 * variance_) / kPi, mu = mean_ - kEuler * beta;
    usual_ = static_cast<Scalar>(std::max(static_cast<double>(Degrees), mu));
    threshold_ = static_cast<Scalar>(mu + reach_ * beta);
  }

  double reach_;                    // of the threshold above mu, in units of beta
  double mean_ = 0, variance_ = 0;  // of the maxima
  int windows_ = kPrior;
  Scalar threshold_ = Scalar(0), usual_ = Scalar(0);
};

}  // namespace rme
