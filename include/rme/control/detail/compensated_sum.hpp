#pragma once
/// A sum of many small terms that float does not lose.
#include <cmath>

namespace rme::detail {

/// What rounding takes from the sum is kept and added to the next term (Kahan, with Knuth's exact difference, which
/// does not ask which of the two is larger): a million terms err by as much as one.
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
  /// The sum less x, without losing what is small beside both.
  Scalar minus(Scalar x) const noexcept { return (sum_ - x) + rest_; }

 private:
  Scalar sum_;
  Scalar rest_ = Scalar(0);
};

}  // namespace rme::detail
