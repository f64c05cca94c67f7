#pragma once
/// Which part of a payload may be no weight but something rigid that holds the hand.
#include <algorithm>
#include <cmath>

namespace rme {

/// If something rigid holds the hand, the robot's compensation appears as further weight, so that a robot which carries
/// all of it drives both up. Weight and support differ in one thing: something rigid resists each millimetre of motion
/// with some newtons. So what appears little by little is undecided until the hand has moved up or down with it
/// (docs/theory.md (T67)), also just before it was noticed. What appears at once is a payload, unless something
/// undecided came before. What takes its place later, before the hand has moved with it, is as heavy at most: several steps
/// are little by little as well. Real time: nothing allocates.
template <typename Scalar>
class Undecided {
 public:
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
    all_ = !certain && (all_ || part() > 0);
    begin(certain);
    changes_ = true;
  }
  /// A payload has taken the place of the one so far.
  /// @param certain  as in pour()
  void exchange(bool certain) noexcept {
    const Undecided before = *this;
    *this = Undecided();
    all_ = !certain && (before.all_ || before.part() > 0);
    steps_ = !certain && (before.steps_ || (before.fresh_ && before.age_ > Scalar(kAtOnce)));
    first_ = before.first_;
    age_ = before.fresh_ ? before.age_ : Scalar(0);
    fresh_ = !certain && !before.weight_;
    risen_ = before.risen_;
  }
  /// Nothing is held any more.
  void let_go() noexcept {
    const Scalar risen = risen_;
    *this = Undecided();
    risen_ = risen;
  }
  /// A block has passed.
  /// @param mass      of the payload [kg]
  /// @param poured    mass that has been poured in since pour(), if something pours [kg]
  /// @param duration  of the block [s]
  /// @param risen     how far the hand has gone up in it [m]
  /// @param gravity   |g| [m/s^2]
  void update(Scalar mass, Scalar poured, Scalar duration, Scalar risen, Scalar gravity) noexcept {
    if (pours_) poured_ = poured;
    if (!steps_ && !changes_) first_ = mass;
    if (fresh_) age_ += duration;
    if (changes_ && !weight_) {
      lasts_ += duration;
      all_ = all_ || lasts_ > Scalar(kAtOnce);
    }
    risen_ += risen;
    if (!pours_ && !changes_ && !fresh_ && !(of(mass) > 0)) {  // a load makes the hand sink before it is noticed
      risen_ = std::min(Scalar(0), risen_ * std::exp(-duration / Scalar(kRecent)));
      return;
    }
    const Scalar weight = (fresh_ ? std::max(Scalar(0), mass) : of(mass)) * gravity;
    if (risen_ > -Scalar(kSlack) && risen_ < Scalar(kSlack) + weight / Scalar(kRigid)) return;
    kept_ = poured_ = risen_ = lasts_ = Scalar(0);
    all_ = fresh_ = steps_ = false;
    weight_ = true;  // also what is still to come
  }
  /// How much of the payload's mass is undecided [kg].
  /// @param mass  of the payload [kg]
  Scalar of(Scalar mass) const noexcept {
    const Scalar stepped = steps_ ? std::max(Scalar(0), mass - first_) : Scalar(0);
    return std::max(Scalar(0), all_ ? mass : std::min(mass, part() + stepped));
  }

  /// Share of a payload that is carried.
  /// @param undecided  share of it that is undecided
  static Scalar carried(Scalar undecided) noexcept { return Scalar(1) - Scalar(1 - kShare) * undecided; }

 private:
  static constexpr double kShare = 0.2;    // share that is carried of what is undecided
  static constexpr double kRigid = 5000;   // least stiffness of what is rigid [N/m]
  static constexpr double kSlack = 0.001;  // its play, and the drift of the integral of dq [m]
  static constexpr double kRecent = 0.2;   // memory of a hand that sinks [s]
  static constexpr double kAtOnce = 0.1;   // longest change that is felt at once [s]

  void begin(bool certain) noexcept {
    if (!(part() > 0)) risen_ = std::min(Scalar(0), risen_);
    poured_ = lasts_ = Scalar(0);
    weight_ = certain;
    pours_ = changes_ = false;
  }
  Scalar part() const noexcept { return std::max(Scalar(0), kept_ + (pours_ && !weight_ ? poured_ : Scalar(0))); }

  Scalar kept_ = Scalar(0);    // mass of earlier pours [kg]
  Scalar poured_ = Scalar(0);  // of the present one [kg]
  Scalar risen_ = Scalar(0);   // how far the hand has gone up since it began, or was last decided [m]
  Scalar lasts_ = Scalar(0);   // how long the payload has changed [s]
  bool pours_ = false;         // something pours
  bool changes_ = false;       // the payload changes
  bool weight_ = false;        // what pours, or changes, is a weight
  bool all_ = false;           // all of the payload is undecided
  bool fresh_ = false;         // it has appeared at once, and the hand has not moved since
  bool steps_ = false;         // and it took the place of another one of which that was so
  Scalar first_ = Scalar(0);   // mass of the first of them [kg]
  Scalar age_ = Scalar(0);     // since that appeared [s]
};

}  // namespace rme
