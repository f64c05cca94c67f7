#pragma once
/// The running sums from which a payload is inferred.
#include <array>
#include <rme/core/types.hpp>
#include <rme/inference/payload_likelihood.hpp>
#include <rme/inference/payload_regressor.hpp>

namespace rme {

/// One tick: y = m (a + B r) + noise, per joint.
template <typename Scalar, int Dofs>
struct PayloadObservation {
  JointVector<Scalar, Dofs> tau = JointVector<Scalar, Dofs>::Zero();  ///< y, external torque [N m]
  PayloadRegressor<Scalar, Dofs> regressor;                           ///< a, B
};

/// Sums over a window, per joint: the Gram matrix of z = (y, a, B_x, B_y, B_z). They do not depend on the noise level,
/// which is needed only for an inference. A tick costs O(Dofs), however long the window is.
template <typename Scalar, int Dofs>
class PayloadStatistics {
 public:
  PayloadStatistics() noexcept {
    for (Products& g : gram_) g.setZero();
  }

  /// Adds one tick. The numbers must be finite, which is not checked.
  void add(const PayloadObservation<Scalar, Dofs>& o) noexcept {
    for (int j = 0; j < Dofs; ++j) {
      const auto& [a, B] = o.regressor;
      Eigen::Matrix<Scalar, 5, 1> z;
      z << o.tau[j], a[j], B(j, 0), B(j, 1), B(j, 2);
      gram_[static_cast<std::size_t>(j)].noalias() += z * z.transpose();
    }
  }

  /// The likelihood of a payload: all error of the torque is white noise.
  /// @param precision  per joint and sample [1/(N m)^2], > 0
  PayloadLikelihood<Scalar> likelihood(const JointVector<Scalar, Dofs>& precision) const noexcept {
    Products total = Products::Zero();
    for (int j = 0; j < Dofs; ++j) total += precision[j] * gram_[static_cast<std::size_t>(j)];
    return PayloadLikelihood<Scalar>::from_products(total);
  }

 private:
  using Products = Eigen::Matrix<Scalar, 5, 5>;

  std::array<Products, Dofs> gram_;
};

}  // namespace rme
