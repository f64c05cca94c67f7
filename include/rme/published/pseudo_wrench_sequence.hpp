#pragma once
/// The network's input: pseudo-wrenches, evenly spaced over a collection.
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/network/weights.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/sensing/pseudo_wrench.hpp>

namespace rme {

/// M uniformly spaced pseudo-wrenches (docs/theory.md (T36)) out of N samples (paper, Section 4.1 and Table 4). The
/// window is divided into M equal parts, and the newest sample of each part is taken, as in training. The paper does
/// not say which sample it takes.
/// @param count          N, samples in the window
/// @param at             callable (int i) -> Proprioception<Scalar, Dofs>, noexcept, i from 0 (the oldest) to count - 1
/// @param damping        lambda of pseudo_wrench() [m^2], > 0; the paper's value is 1e-2
/// @param frame          axes of the wrenches: world as in the paper, or end effector
/// @param[out] sequence  M x 6, oldest first: force [N], moment [N m]; not usable unless the status is Ok
/// @return Ok; NotReady (fewer samples than M); NonFiniteInput; NotPositiveDefinite (the damping is not > 0, or the
///         Jacobian is so large that the damping is lost to rounding)
template <typename Scalar, int Dofs, typename At, typename NetworkScalar, int M>
Status pseudo_wrench_sequence(int count, const At& at, Scalar damping, InputFrame frame,
                              Eigen::Matrix<NetworkScalar, M, 6>& sequence) noexcept {
  if (count < M) return Status::NotReady;
  for (int i = 0; i < M; ++i) {
    const Proprioception<Scalar, Dofs>& sample = at((i + 1) * count / M - 1);
    Wrench<Scalar> wrench;
    const Status status = pseudo_wrench(sample.jacobian, sample.tau_ext, damping, wrench);
    if (status != Status::Ok) return status;
    if (frame == InputFrame::EndEffector) wrench = in_end_effector_axes<Scalar>(wrench, sample.rotation);
    sequence.row(i) = wrench.vector().transpose().template cast<NetworkScalar>();
  }
  return Status::Ok;
}

}  // namespace rme
