#pragma once
/// What a host can read of a wrench that the payload does not explain, as plain structs.
#include <Eigen/Core>
#include <cstdint>
#include <rme/core/types.hpp>
#include <rme/core/wrench.hpp>

namespace rme {

/// What a contact turned out to be. An object that is put into the hand, and a hand that pushes, look the same at
/// first.
enum class ContactCause : std::uint8_t {
  Undecided,  ///< it goes on, or the estimator has not decided yet
  Contact,    ///< something touched the arm; the payload is the same as before
  Payload,    ///< the payload was attached, exchanged, removed or filled
  Arm,        ///< it lasts, and the estimator takes it for an error of the arm's own model or for a small payload
};

/// The enumerator's name, for logs.
constexpr const char* to_string(ContactCause cause) noexcept {
  switch (cause) {
    case ContactCause::Undecided:
      return "undecided";
    case ContactCause::Contact:
      return "contact";
    case ContactCause::Payload:
      return "payload";
    case ContactCause::Arm:
      return "arm";
  }
  return "unknown";
}

/// A contact, from its onset to its end. Times count from the estimator's construction or reset [s].
template <typename Scalar>
struct ContactEvent {
  int number = 0;                                ///< number of contacts so far, this one included; 0 before the first
  ContactCause cause = ContactCause::Undecided;  ///< what it turned out to be
  double onset = 0;                              ///< when the residual left what is usual
  double noticed = 0;                            ///< when `contact` became true
  double over = 0;                               ///< when `contact` became false; 0 while it goes on
  Scalar peak_torque = Scalar(0);                ///< largest norm of the residual torque so far [N m]
  Scalar peak_force = Scalar(0);                 ///< largest norm of the force of the wrench at the tip so far [N]
};

/// What acts on the arm and is explained neither by the payload nor by what the arm has shown so far.
template <typename Scalar, int Dofs>
struct ContactState {
  using Vector = JointVector<Scalar, Dofs>;                        ///< joint torque [N m]
  static constexpr int kSize = Dofs == Eigen::Dynamic ? 0 : Dofs;  ///< number of joints, 0 if known at run time only

  /// Whether a contact would be noticed: not in the first second, and not while tau_ext is no measurement.
  bool ready = false;
  bool contact = false;  ///< whether something touches the arm, or its payload changes
  /// How much of the residual there is: 1 is the threshold at which `contact` becomes true (docs/theory.md (T64)).
  Scalar statistic = Scalar(0);
  /// External torque that is not explained [N m]. It lags by the observer's time constant and 4 ms.
  Vector residual = Vector::Zero(kSize);
  Vector variance =
      Vector::Zero(kSize);  ///< of `residual`, while nothing touches the arm [(N m)^2]; the joints are independent
  /// Residual torque of each joint that would be a contact if the other joints showed none [N m].
  Vector threshold = Vector::Zero(kSize);
  /// The wrench at the tip that explains `residual` best (T65): world axes, moment about the end-effector origin. While
  /// nothing touches the arm, it is computed each 10 ms.
  Wrench<Scalar> wrench;
  Matrix6<Scalar> wrench_covariance = Matrix6<Scalar>::Identity();  ///< of (force, moment) [N, N m]
  /// Probability that the contact is on link j + 1, the one that joint j moves; the last one includes hand and payload
  /// (T66). Sum 1; zero while `contact` is false.
  Vector link = Vector::Zero(kSize);
  ContactEvent<Scalar> last;  ///< the contact that goes on, or the last one

  /// Number of the link that the contact is most probably on, 1 to Dofs; 0 while there is none.
  int likeliest_link() const noexcept {
    if (!contact) return 0;
    int best = 0;
    for (int j = 1; j < static_cast<int>(link.size()); ++j)
      if (link[j] > link[best]) best = j;
    return best + 1;
  }
};

}  // namespace rme
