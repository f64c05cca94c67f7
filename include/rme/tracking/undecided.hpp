#pragma once
/// Which part of a payload may be no weight but something rigid that holds the hand.
#include <algorithm>
#include <rme/core/types.hpp>

namespace rme {

/// A hand that is held by something rigid feels the robot's compensation as further weight, so that a robot which carries
/// all that it feels drives both up. Weight and support differ in one thing: what is rigid resists each millimetre of
/// motion with some newtons. So what is felt little by little is undecided until the hand has moved up or down with it
/// (docs/theory.md (T67)). What is felt at once is a payload, unless something undecided came before. Real time: nothing
/// allocates.
template <typename Scalar>
class Undecided {
 public:
  using Body = Vector4<Scalar>;  ///< (m, m r) [kg, kg m], end-effector axes

  /// Something is poured in from now on.
  /// @param certain  the host has said that the payload changes, so it is a weight
  void pour(bool certain) noexcept {
    begin(certain);
    pours_ = true;
  }
  /// The pour has ended.
  void end_pour() noexcept {
    kept_ = part();
    pours_ = weight_ = false;
  }
  /// The payload changes from now on. If this takes long, it is felt little by little.
  /// @param certain  as in pour()
  void change(bool certain) noexcept {
    all_ = !certain && (all_ || part()[0] > 0);
    begin(certain);
    changes_ = true;
  }
  /// A payload has taken the place of the one so far.
  void exchange() noexcept {
    const Undecided before = *this;
    *this = Undecided();
    all_ = before.all_ || before.part()[0] > 0;
    risen_ = before.risen_;
  }
  /// What was taken for a wrench is a payload; but it may be a wrench.
  void turn() noexcept {
    *this = Undecided();
    all_ = true;
  }
  /// A block has passed.
  /// @param payload   what is held
  /// @param poured    part of it that has been poured in since pour(), if something pours
  /// @param duration  of the block [s]
  /// @param risen     how far the hand has gone up in it [m]
  /// @param gravity   |g| [m/s^2]
  void update(const Body& payload, const Body& poured, Scalar duration, Scalar risen, Scalar gravity) noexcept {
    if (pours_) poured_ = poured;
    if (changes_ && !weight_) {
      lasts_ += duration;
      all_ = all_ || lasts_ > Scalar(kAtOnce);
    }
    risen_ += risen;
    const Scalar weight = std::max(Scalar(0), of(payload)[0]) * gravity;
    if (risen_ > -Scalar(kSlack) && risen_ < Scalar(kSlack) + weight / Scalar(kRigid)) return;
    const bool pours = pours_, changes = changes_;
    *this = Undecided();
    pours_ = pours;
    changes_ = changes;
    weight_ = pours || changes;
  }
  /// The part of the payload that is undecided.
  /// @param payload  what is held
  Body of(const Body& payload) const noexcept { return all_ ? payload : part(); }

  static constexpr double kShare = 0.2;  ///< share of it that is carried

 private:
  static constexpr double kRigid = 5000;   // least stiffness of what is rigid [N/m]
  static constexpr double kSlack = 0.001;  // its play, and the drift of the integral of dq [m]
  static constexpr double kAtOnce = 0.1;   // longest change that is felt at once [s]

  void begin(bool certain) noexcept {
    poured_.setZero();
    risen_ = lasts_ = Scalar(0);
    weight_ = certain;
    pours_ = changes_ = false;
  }
  Body part() const noexcept {
    Body sum = kept_;
    if (pours_ && !weight_) sum += poured_;
    if (!(sum[0] > 0)) sum.setZero();
    return sum;
  }
  Body kept_ = Body::Zero();         // of earlier pours
  Body poured_ = Body::Zero();       // of the present one
  Scalar risen_ = Scalar(0);         // how far the hand has gone up since it began, or was last decided [m]
  Scalar lasts_ = Scalar(0);         // how long the payload has changed [s]
  bool pours_ = false;               // something pours
  bool changes_ = false;             // the payload changes
  bool weight_ = false;              // what pours, or changes, is a weight
  bool all_ = false;                 // all of the payload is undecided
};

}  // namespace rme
