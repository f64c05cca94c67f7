#pragma once
/// What the network sees of a collection: a few pseudo-wrenches, evenly spread over it.
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/network/weights.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/sensing/pseudo_wrench.hpp>

namespace rme {

/// The M uniformly spaced pseudo-wrenches out of N samples (paper, Section 4.1 and Table 4): the newest of each of M
/// equal parts. That is where training takes them; the paper does not say.
/// @param count    N, samples in the window
/// @param at       callable (int i) -> Proprioception<Scalar, Dofs>, noexcept, i from 0 (the oldest) to count - 1
/// @param damping  lambda of pseudo_wrench(), > 0; the paper's value is 1e-2
/// @param frame    axes of the wrenches: world as in the paper, or end effector
/// @param[out] sequence  M x 6, oldest first: force [N], moment [N m]; of no use unless the status is Ok
/// @return Ok; NotReady (fewer samples than M); NonFiniteInput; NotPositiveDefinite: a Jacobian too large for the
/// damping to be felt
template <typename Scalar, int Dofs, typename At, typename NetworkScalar, int M>
Status pseudo_wrench_sequence(int count, const At& at, Scalar damping, InputFrame frame,
                              Eigen::Matrix<NetworkScalar, M, 6>& sequence) noexcept {
  if (count < M) return Status::NotReady;
  for (int i = 0; i < M; ++i) {
    const Proprioception<Scalar, Dofs>& sample = at((i + 1) * count / M - 1);
    Wrench<Scalar> wrench;
    const Status status = pseudo_wrench<Scalar, Dofs>(sample.jacobian, sample.tau_ext, damping, wrench);
    if (status != Status::Ok) return status;
    if (frame == InputFrame::EndEffector) wrench = in_end_effector_axes<Scalar>(wrench, sample.rotation);
    sequence.row(i) = wrench.vector().transpose().template cast<NetworkScalar>();
  }
  return Status::Ok;
}

}  // namespace rme
