#pragma once
/// What a call in the control loop reports instead of throwing.
#include <cstdint>

namespace rme {

/// Outcome of a real-time call. Unless the call says otherwise, any value but Ok means: the input was refused, the
/// object is as it was, and no output was written.
enum class [[nodiscard]] Status : std::uint8_t{
    Ok,
    NonFiniteInput,       ///< an input is NaN, infinite, or larger than any arm reports (plausible.hpp)
    NotARotation,         ///< a rotation matrix is not orthonormal with determinant +1
    NotReady,             ///< too little data yet for an answer
    NotPositiveDefinite,  ///< a matrix that must be positive definite is not
    NotConverged,         ///< the bound on iterations was reached; the best iterate is returned
    Infeasible,           ///< hard constraints contradict each other; the answer with the least violation is returned
    CapacityExceeded,     ///< no room for more in storage fixed at compile time
    WrongSize,            ///< a vector or a matrix does not have the size given at construction
    NotAMeasurement,      ///< a reading is frozen, or exactly zero though its noise rules that out (stale_torque.hpp)
    Unbounded,            ///< nothing bounds the answer, or a part of it; the other parts are returned
};

/// The enumerator's name, for logs.
constexpr const char* to_string(Status status) noexcept {
  switch (status) {
    case Status::Ok:
      return "Ok";
    case Status::NonFiniteInput:
      return "NonFiniteInput";
    case Status::NotARotation:
      return "NotARotation";
    case Status::NotReady:
      return "NotReady";
    case Status::NotPositiveDefinite:
      return "NotPositiveDefinite";
    case Status::NotConverged:
      return "NotConverged";
    case Status::Infeasible:
      return "Infeasible";
    case Status::CapacityExceeded:
      return "CapacityExceeded";
    case Status::WrongSize:
      return "WrongSize";
    case Status::NotAMeasurement:
      return "NotAMeasurement";
    case Status::Unbounded:
      return "Unbounded";
  }
  return "unknown";
}

}  // namespace rme
