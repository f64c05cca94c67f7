#pragma once
/// The sums of a window that grows tick by tick, from which PayloadStatistics about any centre of mass follow.
#include <array>
#include <cstddef>
#include <rme/core/types.hpp>
#include <rme/inference/payload_regressor.hpp>
#include <rme/inference/payload_statistics.hpp>

namespace rme {

/// Collects a window's ticks, in means over `block` of them. What varies from tick to tick is averaged out there: it
/// would look like noise of another kind than SensorModel's, and the evidence of the sensor models would be about that.
///
/// The payload's inertia force is quadratic in r. The window keeps the Gram matrix with the quadratic columns Q in it,
/// so that the linear model about a centre of mass r0 that is known only later,
///
///     a + B r + Q p(r) = (a - Q p(r0)) + (B + Q p'(r0)) r + O(|r - r0|^2),      p = products(r)
///
/// follows without the samples. Real time: add() is O(Dofs), and nothing depends on the length of the window.
template <typename Scalar, int Dofs>
class WindowStatistics {
 public:
  /// @param block  ticks, >= 1
  explicit WindowStatistics(int block) noexcept : block_(block) { clear(); }

  void clear() noexcept {
    for (Gram& g : gram_) g.setZero();
    count_ = 0;
    unfinished_ = PayloadObservation<Scalar, Dofs>();
    ticks_ = 0;
  }

  /// Adds one tick. The caller vouches for finite numbers.
  void add(const PayloadObservation<Scalar, Dofs>& observation) noexcept {
    unfinished_ += observation;
    if (++ticks_ < block_) return;
    for (int j = 0; j < Dofs; ++j) add_block(j, gram_[static_cast<std::size_t>(j)]);
    count_ += ticks_;
    unfinished_ = PayloadObservation<Scalar, Dofs>();
    ticks_ = 0;
  }

  /// Ticks so far.
  int count() const noexcept { return count_ + ticks_; }

  /// The sums of the model that is linear about r0 = com_guess [m], end-effector axes.
  PayloadStatistics<Scalar, Dofs> about(const Vector3<Scalar>& com_guess) const noexcept {
    if (count() == 0) return PayloadStatistics<Scalar, Dofs>();
    const Vector3<Scalar>& r = com_guess;
    Eigen::Matrix<Scalar, 6, 4> U;  // what Q adds to a and to B
    U.col(0) = -products(r);
    // clang-format off
    U.template rightCols<3>() << 2 * r[0],  Scalar(0), Scalar(0),
                                 r[1],      r[0],      Scalar(0),
                                 r[2],      Scalar(0), r[0],
                                 Scalar(0), 2 * r[1],  Scalar(0),
                                 Scalar(0), r[2],      r[1],
                                 Scalar(0), Scalar(0), 2 * r[2];
    // clang-format on
    typename PayloadStatistics<Scalar, Dofs>::Grams linear;
    for (int j = 0; j < Dofs; ++j) {
      const auto joint = static_cast<std::size_t>(j);
      Gram g = gram_[joint];
      if (ticks_ > 0) add_block(j, g);
      Eigen::Matrix<Scalar, kLinear, 4> cross;
      cross.noalias() = g.template topRightCorner<kLinear, 6>().lazyProduct(U);
      Eigen::Matrix<Scalar, 6, 4> half;
      half.noalias() = g.template bottomRightCorner<6, 6>().lazyProduct(U);
      auto& out = linear[joint];
      out = g.template topLeftCorner<kLinear, kLinear>();
      out.template middleCols<4>(1) += cross;
      out.template middleRows<4>(1) += cross.transpose();
      out.template block<4, 4>(1, 1) += U.transpose().lazyProduct(half);
    }
    return PayloadStatistics<Scalar, Dofs>(linear, count());
  }

 private:
  static constexpr int kLinear = PayloadStatistics<Scalar, Dofs>::kColumns;
  using Gram = Eigen::Matrix<Scalar, kLinear + 6, kLinear + 6>;

  /// Adds the mean of the unfinished block to a joint's sums, as often as it has ticks.
  void add_block(int joint, Gram& gram) const noexcept {
    const Scalar weight = Scalar(1) / Scalar(ticks_);
    Eigen::Matrix<Scalar, kLinear + 6, 1> z;
    z.template head<kLinear>() = PayloadStatistics<Scalar, Dofs>::row(unfinished_, joint);
    z[kConstant] = Scalar(ticks_);
    z.template tail<6>() = unfinished_.regressor.Q.row(joint).transpose();
    gram.noalias() += (weight * z) * z.transpose();
  }
  static constexpr int kConstant = PayloadStatistics<Scalar, Dofs>::kConstant;

  int block_;
  std::array<Gram, Dofs> gram_;  // of (y, a, B, 1, -direction, -velocity, Q), per joint
  int count_ = 0;
  PayloadObservation<Scalar, Dofs> unfinished_;  // sum over its ticks
  int ticks_ = 0;
};

}  // namespace rme
