#pragma once
/// A sum that does not lose small terms to rounding.
#include <cmath>

namespace rme::detail {

/// Kahan's summation: the rounding error of the sum is kept and added to the next term. So the error does not grow with
/// the number of terms. The rounding error is Knuth's exact one, for which it does not matter whether sum or term is
/// larger.
template <typename Scalar>
class CompensatedSum {
 public:
  explicit CompensatedSum(Scalar start = Scalar(0)) noexcept : sum_(start) {}
  void add(Scalar term) noexcept {
    const Scalar x = term + rest_, sum = sum_ + x, of_x = sum - sum_;
    rest_ = (sum_ - (sum - of_x)) + (x - of_x);
    sum_ = sum;
  }
  Scalar value() const noexcept { return sum_ + rest_; }
  /// The sum minus x, without losing what is small compared with both.
  Scalar minus(Scalar x) const noexcept { return (sum_ - x) + rest_; }

 private:
  Scalar sum_;
  Scalar rest_ = Scalar(0);
};

}  // namespace rme::detail
