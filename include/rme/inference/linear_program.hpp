#pragma once
/// Small linear programs, in storage fixed at compile time.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// What LinearProgram::maximise() has found.
template <typename Scalar, int Size>
struct LinearProgramResult {
  Eigen::Matrix<Scalar, Size, 1> x = Eigen::Matrix<Scalar, Size, 1>::Zero();  ///< where the maximum is attained
  Scalar value = Scalar(0);                                                   ///< c.x there
  /// At least the maximum, whatever the rounding: value and a margin of some machine epsilons of the terms
  /// multiplier * bound that it consists of. For maxima of which nothing may be missed.
  Scalar upper = Scalar(0);
  int pivots = 0;  ///< steps from vertex to vertex
};

/// max c.x subject to a_i.x <= b_i, x free, for few unknowns and many more rows: the simplex method from vertex to
/// vertex, started from a point that keeps all rows (docs/theory.md, "A bound instead of a probability").
///
/// At each vertex, Size rows are active. One of them is left along the edge on which c.x grows fastest, up to the first
/// row that blocks the step. An unknown that no row fixes yet is held at its starting value, and is released first. So
/// the rows may have any rank, and a set without a vertex (a strip, a half space) is no special case. The inverse of
/// the active rows is refined at each step, so that errors do not add up. No rule prevents cycling at a degenerate
/// vertex; with the steepest edge, none has been seen, and the number of steps is bounded.
///
/// The caller provides the starting point. With one more unknown that loosens all rows, any point will do, and the
/// least value of that unknown says whether the rows can be kept, as in PayloadEnclosure.
///
/// Real time: no allocation; at most kMaxPivots steps of O(Size (MaxRows + Size^2)).
/// @tparam Size     number of unknowns
/// @tparam MaxRows  most rows
template <typename Scalar, int Size, int MaxRows>
class LinearProgram {
 public:
  using Vector = Eigen::Matrix<Scalar, Size, 1>;     ///< x, c, or a row's a
  using Result = LinearProgramResult<Scalar, Size>;  ///< of maximise()
  static constexpr int kMaxPivots = 40 * Size;       ///< bound on the steps of maximise()

  /// Removes all rows. A start() is needed afterwards.
  void clear() noexcept {
    size_ = 0;
    started_ = false;
  }
  /// Appends a.x <= b, divided by |a|. A start() is needed afterwards.
  /// @return Ok; NonFiniteInput, also if |a| or b / |a| overflows; CapacityExceeded; Infeasible for a = 0 and b < 0.
  ///         Unless Ok, the row is not added. A row with a = 0 and b >= 0 constrains nothing and takes no room.
  Status add(const Vector& a, Scalar b) noexcept;
  int size() const noexcept { return size_; }  ///< number of rows

  /// Says where to start.
  /// @param x     keeps all rows but for rounding, which is not checked
  /// @param held  the last `held` unknowns stay what they are in x, 0 to Size - 1
  /// @return Ok, or NonFiniteInput
  Status start(const Vector& x, int held = 0) noexcept;

  /// Maximises c.x from where the last call stopped, or from start().
  /// @param c            Size x 1, finite
  /// @param[out] result  as it was unless the status is Ok
  /// @return Ok; Unbounded; NotReady (no start() since the last row); NonFiniteInput; NotConverged: kMaxPivots steps
  ///         were not enough, which no test has seen
  Status maximise(const Vector& c, Result& result) noexcept;

 private:
  static constexpr int kHeld = -1;
  static constexpr Scalar kEpsilon = std::numeric_limits<Scalar>::epsilon();
  /// An edge along which c.x grows by less, per unit of way and of |c|, is level.
  static constexpr Scalar kLevel = 128 * kEpsilon;
  /// A row whose normal is this nearly perpendicular to the step does not block it: as an active row it would be
  /// linearly dependent on the others, but for rounding. About epsilon^(2/3); the result may violate a row by this
  /// share of the step, outwards.
  static constexpr Scalar kParallel = Scalar(kEpsilon < Scalar(1e-10) ? 4e-11 : 2.5e-5);

  struct Step {
    int row = kHeld;  // that blocks the step; kHeld if none does
    Scalar length = Scalar(0);
  };

  static bool finite(const Vector& v) noexcept {
    bool good = true;
    for (int k = 0; k < Size; ++k) good &= std::isfinite(v[k]);
    return good;
  }
  Scalar coefficient(int row, int k) const noexcept {
    return a_[static_cast<std::size_t>(k)][static_cast<std::size_t>(row)];
  }
  Scalar bound(int row) const noexcept { return b_[static_cast<std::size_t>(row)]; }
  Step first_in_the_way(const Vector& direction) noexcept;
  void exchange(int slot, int row) noexcept;

  // By unknown, then by row, so that the loops over all rows run over neighbours.
  std::array<std::array<Scalar, MaxRows>, Size> a_ = {};
  std::array<Scalar, MaxRows> b_ = {}, slope_ = {}, room_ = {};
  int size_ = 0, free_ = Size;
  bool started_ = false;
  // The active set: slot k has a row, or holds unknown k at start_[k]. D has the inverse of the active rows: along
  // -D.col(k) only the row of slot k is left.
  std::array<int, Size> active_ = {};
  Eigen::Matrix<Scalar, Size, Size> D_ = Eigen::Matrix<Scalar, Size, Size>::Identity();
  Vector start_ = Vector::Zero(), x_ = Vector::Zero();
};

template <typename Scalar, int Size, int MaxRows>
Status LinearProgram<Scalar, Size, MaxRows>::add(const Vector& a, Scalar b) noexcept {
  using std::sqrt;
  if (!finite(a) || !std::isfinite(b)) return Status::NonFiniteInput;
  Scalar largest = Scalar(0);
  for (int k = 0; k < Size; ++k) largest = a[k] > largest ? a[k] : -a[k] > largest ? -a[k] : largest;
  if (!(largest > 0)) return b < 0 ? Status::Infeasible : Status::Ok;
  if (size_ == MaxRows) return Status::CapacityExceeded;
  Scalar squared = Scalar(0);  // of a / largest, which neither overflows nor underflows
  for (int k = 0; k < Size; ++k) squared += (a[k] / largest) * (a[k] / largest);
  const Scalar norm = largest * sqrt(squared);
  if (!std::isfinite(norm) || !std::isfinite(b / norm)) return Status::NonFiniteInput;
  const auto row = static_cast<std::size_t>(size_);
  for (int k = 0; k < Size; ++k) a_[static_cast<std::size_t>(k)][row] = a[k] / norm;
  b_[row] = b / norm;
  ++size_;
  started_ = false;
  return Status::Ok;
}

template <typename Scalar, int Size, int MaxRows>
Status LinearProgram<Scalar, Size, MaxRows>::start(const Vector& x, int held) noexcept {
  if (!finite(x)) return Status::NonFiniteInput;
  active_.fill(kHeld);
  D_.setIdentity();
  start_ = x_ = x;
  free_ = Size - held;
  started_ = true;
  return Status::Ok;
}

/// The row that the point meets first. A row that is missed by rounding alone may be passed, so that of rows met at
/// nearly the same point the steepest is taken: the active rows stay well apart.
template <typename Scalar, int Size, int MaxRows>
auto LinearProgram<Scalar, Size, MaxRows>::first_in_the_way(const Vector& direction) noexcept -> Step {
  using std::abs;
  Scalar magnitude = Scalar(0);  // of a.x, with |a| = 1
  for (int k = 0; k < Size; ++k) magnitude += abs(x_[k]);
  const auto rows = static_cast<std::size_t>(size_);
  for (std::size_t i = 0; i < rows; ++i) slope_[i] = Scalar(0);
  for (std::size_t i = 0; i < rows; ++i) room_[i] = b_[i];
  for (int k = 0; k < Size; ++k) {
    const auto& column = a_[static_cast<std::size_t>(k)];
    const Scalar d = direction[k], x = x_[k];
    for (std::size_t i = 0; i < rows; ++i) slope_[i] += column[i] * d;
    for (std::size_t i = 0; i < rows; ++i) room_[i] -= column[i] * x;
  }
  // The limit is bound.room / bound.slope, compared without a division.
  Scalar room = Scalar(1), slope = Scalar(0);
  for (std::size_t i = 0; i < rows; ++i) {
    if (!(slope_[i] > kParallel)) continue;
    if (room_[i] < 0) room_[i] = Scalar(0);
    const Scalar loose = room_[i] + 16 * kEpsilon * (abs(b_[i]) + magnitude);
    if (loose * slope < room * slope_[i]) {
      room = loose;
      slope = slope_[i];
    }
  }
  Step step;
  if (!(slope > 0)) return step;
  Scalar steepest = Scalar(0);
  for (std::size_t i = 0; i < rows; ++i) {
    if (!(slope_[i] > kParallel) || room_[i] * slope > room * slope_[i]) continue;
    if (slope_[i] > steepest) {
      steepest = slope_[i];
      step = {static_cast<int>(i), room_[i] / slope_[i]};
    }
  }
  return step;
}

template <typename Scalar, int Size, int MaxRows>
void LinearProgram<Scalar, Size, MaxRows>::exchange(int slot, int row) noexcept {
  active_[static_cast<std::size_t>(slot)] = row;
  Vector product;  // of the new row with the edges
  for (int k = 0; k < Size; ++k) {
    product[k] = Scalar(0);
    for (int i = 0; i < Size; ++i) product[k] += coefficient(row, i) * D_(i, k);
  }
  for (int i = 0; i < Size; ++i) D_(i, slot) /= product[slot];
  for (int k = 0; k < Size; ++k) {
    if (k == slot) continue;
    for (int i = 0; i < Size; ++i) D_(i, k) -= product[k] * D_(i, slot);
  }
  // One Newton step for the inverse, and one for the vertex: D += D (1 - A D), x += D (b - A x).
  Eigen::Matrix<Scalar, Size, Size> off;
  Vector missed;
  for (int r = 0; r < Size; ++r) {
    const int active = active_[static_cast<std::size_t>(r)];
    for (int k = 0; k < Size; ++k) off(r, k) = Scalar(r == k);
    if (active == kHeld) {
      for (int k = 0; k < Size; ++k) off(r, k) -= D_(r, k);
      missed[r] = start_[r] - x_[r];
    } else {
      missed[r] = bound(active);
      for (int i = 0; i < Size; ++i) {
        for (int k = 0; k < Size; ++k) off(r, k) -= coefficient(active, i) * D_(i, k);
        missed[r] -= coefficient(active, i) * x_[i];
      }
    }
  }
  const Eigen::Matrix<Scalar, Size, Size> before = D_;
  for (int i = 0; i < Size; ++i) {
    for (int r = 0; r < Size; ++r) {
      for (int k = 0; k < Size; ++k) D_(i, k) += before(i, r) * off(r, k);
      x_[i] += before(i, r) * missed[r];
    }
  }
}

template <typename Scalar, int Size, int MaxRows>
Status LinearProgram<Scalar, Size, MaxRows>::maximise(const Vector& c, Result& result) noexcept {
  using std::abs;
  using std::sqrt;
  if (!finite(c)) return Status::NonFiniteInput;
  if (!started_) return Status::NotReady;
  Scalar squared = Scalar(0);
  for (int k = 0; k < Size; ++k) squared += c[k] * c[k];
  const Scalar least = kLevel * sqrt(squared);
  for (int pivots = 0;; ++pivots) {
    // Multipliers, and the growth of c.x per unit of way along each edge.
    Vector multiplier;
    int slot = kHeld;
    bool held = false;
    Scalar best = Scalar(0), norm = Scalar(1), level = Scalar(0);
    for (int k = 0; k < Size; ++k) {
      Scalar length = Scalar(0);
      multiplier[k] = Scalar(0);
      for (int i = 0; i < Size; ++i) {
        multiplier[k] += c[i] * D_(i, k);
        length += D_(i, k) * D_(i, k);
      }
      if (k >= free_) continue;
      length = sqrt(length);
      const bool is_held = active_[static_cast<std::size_t>(k)] == kHeld;
      const Scalar growth = (is_held ? abs(multiplier[k]) : -multiplier[k]) / length;
      if (growth > 0) level += growth;
      if (!(growth > least) || (held && !is_held)) continue;
      if (growth > best || (is_held && !held)) {
        slot = k;
        held = is_held;
        best = growth;
        norm = length;
      }
    }
    if (slot == kHeld) {  // no edge leads up
      Scalar value = Scalar(0), length = Scalar(0), terms = Scalar(0);
      for (int k = 0; k < Size; ++k) {
        value += c[k] * x_[k];
        length += abs(x_[k]);
        const int row = active_[static_cast<std::size_t>(k)];
        Scalar magnitude = abs(row == kHeld ? start_[k] : bound(row));
        for (int i = 0; i < Size; ++i) magnitude += abs((row == kHeld ? Scalar(i == k) : coefficient(row, i)) * x_[i]);
        terms += abs(multiplier[k]) * magnitude;
      }
      // Rounding of the terms, and edges that are level only by rounding, with x for their length.
      const Scalar margin = 4 * kEpsilon * terms + 2 * level * length;
      result = {x_, value, value + margin, pivots};
      return Status::Ok;
    }
    if (pivots == kMaxPivots) return Status::NotConverged;
    const Scalar sign = held && multiplier[slot] > 0 ? Scalar(1) : Scalar(-1);
    Vector direction;
    for (int i = 0; i < Size; ++i) direction[i] = sign / norm * D_(i, slot);
    const Step step = first_in_the_way(direction);
    if (step.row == kHeld) return Status::Unbounded;
    for (int i = 0; i < Size; ++i) x_[i] += step.length * direction[i];
    exchange(slot, step.row);
  }
}

}  // namespace rme
