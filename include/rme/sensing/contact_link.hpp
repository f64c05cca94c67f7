#pragma once
/// Tells on which link a contact acts. In: residual torque, its variance and the Jacobian. Out: the probability of each
/// link, (T66).
#include <algorithm>
#include <cmath>
#include <rme/core/cholesky.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// The evidence of a force of any direction somewhere on link k, of which the joints beyond k show nothing:
///
///     log p(s | link k) = -1/2 s^T (V + S_k)^-1 s - 1/2 log det (V + S_k)               (docs/theory.md (T66))
///
/// One call computes that of one link, so that a tick costs O(Dofs^3), and after the last link the probabilities of
/// all. Nothing allocates or throws.
template <typename Scalar, int Dofs>
class ContactLink {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< one number per joint

  /// @param J            Jacobian, 6 x Dofs, world axes, linear rows first
  /// @param residual     s [N m]
  /// @param variance     of s while nothing touches the arm, the diagonal of V [(N m)^2], > 0
  /// @param probability  of a contact on link j + 1, the one that joint j moves; after each round of Dofs calls
  void update(const Jacobian<Scalar, Dofs>& J, const Vector& residual, const Vector& variance,
              Vector& probability) noexcept {
    const int k = next_;
    next_ = k + 1 == Dofs ? 0 : k + 1;
    // The foot of the perpendicular from the end-effector origin to a joint's axis, as seen from the origin: a point of
    // the axis. A link lies between its own axis and the next one; the last one reaches to the end-effector origin.
    const auto foot = [&J](int j) { return Vector3<Scalar>(angular(J, j).cross(linear(J, j))); };
    Vector3<Scalar> middle = Vector3<Scalar>::Zero();
    if (k + 1 < Dofs) middle = Scalar(0.5) * (foot(k) + foot(k + 1));
    // The size of the force: one that makes a torque as large as the residual over the arm's mean lever.
    Scalar lever = Scalar(1e-6);
    for (int j = 0; j < Dofs; ++j) lever += linear(J, j).squaredNorm();
    const Scalar force = detail::dot(residual, residual) * Scalar(3) / lever;
    Eigen::Matrix<Scalar, Dofs, Dofs> S = Eigen::Matrix<Scalar, Dofs, Dofs>::Zero(), turn = S;
    for (int axis = 0; axis < 3; ++axis) {
      Vector push = Vector::Zero(), twist = Vector::Zero();
      for (int j = 0; j <= k; ++j) {
        const Vector3<Scalar> z = angular(J, j), velocity = linear(J, j) + z.cross(middle);  // of the link's middle
        push[j] = velocity[axis];
        twist[j] = z[axis];
      }
      detail::add_outer(S, detail::scaled(force, push), push);
      detail::add_outer(turn, detail::scaled(force, twist), twist);
    }
    for (int j = 0; j < Dofs; ++j) S(j, j) += variance[j];
    // Near the middle or anywhere on the link: the mean of both.
    Scalar evidence[2];
    for (int i = 0; i < 2; ++i) {
      detail::add_scaled(S, Scalar(kReach[i] * kReach[i]), turn);
      const Cholesky<Scalar, Dofs> factor(S);
      if (!factor.positive_definite()) return;
      const Vector white = factor.solve_lower(residual);
      evidence[i] = Scalar(-0.5) * detail::dot(white, white) - factor.log_det_lower();
    }
    const Scalar larger = std::max(evidence[0], evidence[1]), smaller = std::min(evidence[0], evidence[1]);
    log_evidence_[k] = larger + std::log1p(std::exp(smaller - larger));
    if (k + 1 < Dofs) return;
    // Hand and payload are touched as often as all other links together.
    log_evidence_[k] += static_cast<Scalar>(std::log(std::max(1, Dofs - 1)));
    const Scalar best = log_evidence_.maxCoeff();
    for (int j = 0; j < Dofs; ++j) probability[j] = std::exp(log_evidence_[j] - best);
    probability /= probability.sum();
  }

 private:
  // Standard deviation of a contact's distance from the middle of its link, along each axis [m]; of two kinds of
  // contacts.
  static constexpr double kReach[2] = {0.01, 0.1};

  static Vector3<Scalar> linear(const Jacobian<Scalar, Dofs>& J, int j) noexcept { return {J(0, j), J(1, j), J(2, j)}; }
  static Vector3<Scalar> angular(const Jacobian<Scalar, Dofs>& J, int j) noexcept {
    return {J(3, j), J(4, j), J(5, j)};
  }

  int next_ = 0;  // the link whose evidence comes next
  Vector log_evidence_ = Vector::Zero();
};

}  // namespace rme
