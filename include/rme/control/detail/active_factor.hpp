#pragma once
/// The orthogonal factorisation of active constraint normals in the metric of a quadratic program.
#include <array>
#include <cmath>
#include <limits>
#include <rme/core/types.hpp>

namespace rme::detail {

/// With P = B^T B, each active normal n_k has the image g_k = B n_k. A soft row has in addition an axis of its own,
/// with the entry sqrt(c_k). The columns [g_k; sqrt(c_k) e_k] = sum_l q_l R_lk are orthogonalised by the Gram-Schmidt
/// method, a second time if the first leaves little of a column. So S = R^T D R, D = diag(|q_l|^2), and the error grows
/// only with the square root of S's condition number (docs/theory_control.md (C9)). The q_l keep their lengths and R
/// has ones on its diagonal, which saves a square root per column. Each q_l has a part `top` in the space of g and a
/// part `beside` on the axes of the soft rows among the first l.
/// @tparam Size      dimension of n
/// @tparam Capacity  most columns
template <typename Scalar, int Size, int Capacity>
class ActiveFactor {
 public:
  // Its length is a multiple of four, for vector instructions; the surplus is zero.
  using Image = Eigen::Matrix<Scalar, (Size + 3) / 4 * 4, 1>;
  using Column = std::array<Scalar, static_cast<std::size_t>(Capacity)>;

  /// A column as its part in the span of others and the part that is orthogonal to them.
  struct Split {
    Column within;   // R_l, l < count: coefficients of the part in the span
    Image top;       // the orthogonal part in the space of g
    Column beside;   // the orthogonal part on the axes of the soft rows, if `soft`
    Scalar squared;  // squared length of the orthogonal part
    bool cancelled;  // whether less than a tenth of the column's length is orthogonal
    bool soft;       // whether `beside` is set
  };

  void clear() noexcept { soft_ = false; }

  /// Splits a column against the first `count` columns.
  /// @param squared  |g|^2
  void split(const Image& g, Scalar squared, Scalar compliance, int count, Split& s) const noexcept {
    s.top = g;
    s.soft = soft_ || compliance > 0;
    if (s.soft) {
      for (int j = 0; j < count; ++j) s.beside[at(j)] = 0;
      s.beside[at(count)] = std::sqrt(compliance);
    }
    s.squared = squared + compliance;
    s.cancelled = false;
    if (count == 0) return;
    for (int l = 0; l < count; ++l) s.within[at(l)] = q_[at(l)].dot(g) * inverse_[at(l)];
    subtract(s.within, count, s);
    s.squared = squared_length(s, count);
    s.cancelled = s.squared < Scalar(0.01) * (squared + compliance);
    if (s.cancelled) {
      Column again{};
      for (int l = 0; l < count; ++l) {
        again[at(l)] = q_[at(l)].dot(s.top);
        if (soft_) {
          for (int j = 0; j <= l; ++j) again[at(l)] += beside_[at(l)][at(j)] * s.beside[at(j)];
        }
        again[at(l)] *= inverse_[at(l)];
        s.within[at(l)] += again[at(l)];
      }
      subtract(again, count, s);
      s.squared = squared_length(s, count);
    }
  }

  /// The same without a root of P: g is P n, each q_l is P times a combination of normals, and the product of two
  /// columns is q_l^T n. This is Cholesky's method on S, with an error that grows with S's condition number itself. All
  /// columns of a factor have to be split by the same of the two functions.
  /// @param n          the normal, padded with zeros
  /// @param curvature  n P n
  void split_without_root(const Image& g, const Image& n, Scalar curvature, Scalar compliance, int count,
                          Split& s) const noexcept {
    s.top = g;
    s.squared = curvature + compliance;
    s.cancelled = s.soft = false;  // a new column has no part on the axes of the others
    if (count == 0) return;
    for (int l = 0; l < count; ++l) s.within[at(l)] = q_[at(l)].dot(n) * inverse_[at(l)];
    Image top = g;  // in registers
    for (int l = 0; l < count; ++l) top -= s.within[at(l)] * q_[at(l)];
    s.top = top;
    s.squared = n.dot(top) + compliance;
  }

  /// Stores a column that was split against the first k as column k.
  void set(int k, const Split& s) noexcept {
    inverse_[at(k)] = Scalar(1) / s.squared;
    q_[at(k)] = s.top;
    for (int l = 0; l < k; ++l) r_[at(k)][at(l)] = s.within[at(l)];
    if (s.soft && !soft_) {
      for (int l = 0; l < k; ++l) {
        for (int j = 0; j <= l; ++j) beside_[at(l)][at(j)] = 0;
      }
      soft_ = true;
    }
    if (soft_) {
      for (int j = 0; j <= k; ++j) beside_[at(k)][at(j)] = s.beside[at(j)];
    }
  }

  /// y <- R^-T y, element k, given those before it.
  void forward(Column& y, int k) const noexcept {
    for (int l = 0; l < k; ++l) y[at(k)] -= r_[at(k)][at(l)] * y[at(l)];
  }
  /// y <- D^-1 y, element k
  void scale(Column& y, int k) const noexcept { y[at(k)] *= inverse_[at(k)]; }
  /// y <- R^-1 y
  void backward(Column& y, int count) const noexcept {
    for (int k = count - 1; k > 0; --k) {
      for (int l = 0; l < k; ++l) y[at(l)] -= r_[at(k)][at(l)] * y[at(k)];
    }
  }
  /// sum_k y_k q_k, in the space of g
  Image combine(const Column& y, int count) const noexcept {
    Image z = Image::Zero();
    for (int k = 0; k < count; ++k) z += y[at(k)] * q_[at(k)];
    return z;
  }

 private:
  static constexpr std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }

  void subtract(const Column& r, int count, Split& s) const noexcept {
    Image top = s.top;  // in registers
    for (int l = 0; l < count; ++l) top -= r[at(l)] * q_[at(l)];
    s.top = top;
    if (!soft_) return;
    for (int l = 0; l < count; ++l) {
      for (int j = 0; j <= l; ++j) s.beside[at(j)] -= r[at(l)] * beside_[at(l)][at(j)];
    }
  }
  static Scalar squared_length(const Split& s, int count) noexcept {
    Scalar sum = s.top.squaredNorm();
    if (s.soft) {
      for (int j = 0; j <= count; ++j) sum += s.beside[at(j)] * s.beside[at(j)];
    }
    return sum;
  }

  std::array<Image, static_cast<std::size_t>(Capacity)> q_;
  std::array<Column, static_cast<std::size_t>(Capacity)> r_;       // R by columns, above the diagonal
  std::array<Column, static_cast<std::size_t>(Capacity)> beside_;  // set if soft_
  Column inverse_;                                                 // 1 / |q_k|^2
  bool soft_ = false;                                              // whether a column since clear() was soft
};

}  // namespace rme::detail
