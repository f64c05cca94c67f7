#pragma once
/// The orthogonal factorisation of active constraint normals in the metric of a quadratic program.
#include <array>
#include <cmath>
#include <limits>
#include <rme/core/types.hpp>

namespace rme::detail {

/// With P = B^T B, each active normal n_k has the image g_k = B n_k, and a soft one its own axis beside it, of length
/// sqrt(c_k). The columns [g_k; sqrt(c_k) e_k] = sum_l q_l R_lk are orthogonalised by Gram and Schmidt, a second time
/// where the first leaves little, so that S = R^T D R, D = diag(|q_l|^2), with an error that grows with the root of S's
/// condition only (docs/theory_control.md (C9)). The q_l keep their lengths and R has ones on its diagonal, which spares
/// a square root per column. Every q_l has the part `top` in the space of g and the part `beside` on the axes of the
/// soft rows among the first l.
/// @tparam Size      dimension of n
/// @tparam Capacity  most columns
template <typename Scalar, int Size, int Capacity>
class ActiveFactor {
 public:
  // Of a length that vector instructions like; the surplus is zero.
  using Image = Eigen::Matrix<Scalar, (Size + 3) / 4 * 4, 1>;
  using Column = std::array<Scalar, static_cast<std::size_t>(Capacity)>;

  /// What a column has within the span of others, and what it adds to them.
  struct Split {
    Column within;   // R_l, l < count
    Image top;       // its part orthogonal to them
    Column beside;   // the same on the axes of the soft rows; set if it has such a part
    Scalar squared;  // length of the orthogonal part, squared
    bool cancelled;  // whether nine tenths and more of the column lay in the span
    bool soft;       // whether `beside` is set
  };

  void clear() noexcept { soft_ = false; }

  /// Splits a column against the first `count`.
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

  /// The same without a root of P: g is P n, each q_l is P times a combination of normals, and a product of two columns
  /// is that of q_l and n. This is Cholesky's method on S, with an error of its condition itself. All columns of a
  /// factor are split either this way or that.
  /// @param n          the normal, padded with zeros
  /// @param curvature  n P n
  void split_without_root(const Image& g, const Image& n, Scalar curvature, Scalar compliance, int count,
                          Split& s) const noexcept {
    s.top = g;
    s.squared = curvature + compliance;
    s.cancelled = s.soft = false;  // what a soft row has beside g meets no other row's n
    if (count == 0) return;
    for (int l = 0; l < count; ++l) s.within[at(l)] = q_[at(l)].dot(n) * inverse_[at(l)];
    Image top = g;  // in registers
    for (int l = 0; l < count; ++l) top -= s.within[at(l)] * q_[at(l)];
    s.top = top;
    s.squared = n.dot(top) + compliance;
  }

  /// Makes a column that was split against the first k the one with number k.
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
  bool soft_ = false;                                              // whether any column has been soft since clear()
};

}  // namespace rme::detail
