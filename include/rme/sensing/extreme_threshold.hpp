#pragma once
/// A threshold that is exceeded as seldom as is stated. In: the largest values of a statistic in windows of a second. Out:
/// the threshold, (T63) and (T64).
#include <algorithm>
#include <cmath>

namespace rme {

/// The threshold of a statistic that exceeds it as seldom as is stated, from the largest values that it has shown.
///
/// The maxima of windows of one second follow Gumbel's law, whatever the correlation time of the statistic: P(max > x) =
/// exp(-(x - mu) / beta) for large x. mu and beta come from the mean and the variance of the maxima; beta has been seen in
/// n windows only, so with its posterior the tail is (docs/theory.md (T63))
///
///     P(max > x) = (1 + (x - mu) / (n beta))^-n
///
/// The prior is that of chi-square with `Degrees` degrees of freedom. No call allocates.
template <typename Scalar, int Degrees>
class ExtremeThreshold {
 public:
  /// @param per_window  stated probability that the threshold is exceeded in a window, above 0 and below 1
  explicit ExtremeThreshold(double per_window) noexcept : per_window_(per_window) {
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
    const double blend = 1.0 / (kPrior + windows_), away = largest - mean_;
    mean_ += blend * away;
    variance_ += blend * ((1 - blend) * away * away - variance_);
    solve();
  }
  Scalar threshold() const noexcept { return threshold_; }  ///< exceeded as seldom as is stated
  Scalar usual() const noexcept { return usual_; }          ///< mu: exceeded about once in a window

  static constexpr double kWindow = 1;  ///< duration of a window [s]

 private:
  static constexpr double kEuler = 0.5772156649015329, kPi = 3.141592653589793;
  static constexpr int kPrior = 20;    // windows that the prior counts as
  static constexpr int kMemory = 600;  // windows that are remembered: 10 min
  // Standard normal quantiles of exp(-1 / 50) and of exp(-1 / (50 e)): 50 independent numbers in a window.
  static constexpr double kLocation = 2.058, kLocationAndScale = 2.441;

  void solve() noexcept {
    const double n = kPrior + windows_;
    const double beta = std::sqrt(6 * variance_) / kPi, mu = mean_ - kEuler * beta;
    usual_ = static_cast<Scalar>(mu);
    threshold_ = static_cast<Scalar>(mu + n * beta * (std::pow(per_window_, -1 / n) - 1));
  }

  double per_window_;
  double mean_ = 0, variance_ = 0;  // of the maxima
  int windows_ = 0;
  Scalar threshold_ = Scalar(0), usual_ = Scalar(0);
};

}  // namespace rme
