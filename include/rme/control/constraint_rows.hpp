#pragma once
/// Linear inequalities for the control loop, in storage fixed at compile time.
#include <array>
#include <limits>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Up to MaxRows two-sided rows `lower <= a x <= upper` (docs/theory_control.md (C1)). A free side has an infinite
/// bound. A row has two sides because both limits of a joint have the same gradient and are never active together.
///
/// A row with a = 0 constrains nothing; it is refused if zero is not within its bounds. A row is hard, or soft with a
/// weight w: a soft row may be violated by a slack s >= 0, at the cost w s^2.
template <typename Scalar, int Size, int MaxRows>
class ConstraintRows {
 public:
  using Vector = Eigen::Matrix<Scalar, Size, 1>;  ///< x, or a row's a

  /// lower <= a x <= upper.
  struct Row {
    Vector a;             ///< Size x 1
    Scalar lower;         ///< of a x; -infinity for none
    Scalar upper;         ///< of a x; infinity for none
    Scalar weight;        ///< w > 0; infinite for a hard row
    Scalar squared_norm;  ///< |a|^2
    int axis;             ///< j where a = e_j, else -1
  };

  static constexpr Scalar kFree = std::numeric_limits<Scalar>::infinity();  ///< upper bound of a free side
  static constexpr Scalar kHard = std::numeric_limits<Scalar>::infinity();  ///< weight of a hard row

  /// Appends lower <= a x <= upper.
  /// @param a       Size x 1
  /// @param lower   -infinity for none
  /// @param upper   kFree for none
  /// @param weight  w > 0 [cost per squared unit of a x]; kHard for a hard row
  /// @return Ok: the row has been added; otherwise it has not. NonFiniteInput for a NaN, an infinite a or |a|^2, or a
  ///         weight that is not above 0; Infeasible for lower > upper, lower = infinity or upper = -infinity, and for
  ///         a = 0 if zero is not within the bounds; CapacityExceeded
  Status add(const Vector& a, Scalar lower, Scalar upper = kFree, Scalar weight = kHard) noexcept {
    return add({a, lower, upper, weight, a.squaredNorm(), -1});
  }
  /// Appends lower <= x_axis <= upper, 0 <= axis < Size: the same as add() with a = e_axis, and Cpic needs less time
  /// for it.
  Status add_axis(int axis, Scalar lower, Scalar upper = kFree, Scalar weight = kHard) noexcept {
    return add({Vector::Unit(axis), lower, upper, weight, Scalar(1), axis});
  }
  void clear() noexcept { size_ = 0; }  ///< removes all rows

  int size() const noexcept { return size_; }  ///< number of rows, at most MaxRows
  /// Row i in the order of add(), 0 <= i < size().
  const Row& operator[](int i) const noexcept { return rows_[static_cast<std::size_t>(i)]; }

 private:
  Status add(const Row& row) noexcept {
    if (!row.a.allFinite() || !(row.weight > 0) || !(row.squared_norm < kFree)) return Status::NonFiniteInput;
    if (row.lower != row.lower || row.upper != row.upper) return Status::NonFiniteInput;
    if (!(row.lower <= row.upper) || row.lower == kFree || row.upper == -kFree) return Status::Infeasible;
    if (!(row.squared_norm > 0) && (row.lower > 0 || row.upper < 0)) return Status::Infeasible;
    if (size_ == MaxRows) return Status::CapacityExceeded;
    rows_[static_cast<std::size_t>(size_++)] = row;
    return Status::Ok;
  }

  std::array<Row, static_cast<std::size_t>(MaxRows)> rows_{};
  int size_ = 0;
};

}  // namespace rme
