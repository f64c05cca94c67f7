#pragma once
/// Notices a contact within milliseconds. In: the external torque that neither the payload nor anything else explains,
/// each tick. Out: whether it is more than the arm has shown so far by itself, (T61) to (T64), and the wrench at the
/// tip that explains it (T65).
#include <algorithm>
#include <cmath>
#include <rme/core/cholesky.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/core/wrench.hpp>
#include <rme/sensing/contact_link.hpp>
#include <rme/sensing/contact_state.hpp>
#include <rme/sensing/extreme_threshold.hpp>
#include <rme/sensing/friction_regression.hpp>

namespace rme {

/// Watches the residual torque s of an arm on two scales: averaged over 4 ms against its mean over the last 0.15 s, and
/// over 25 ms against the last second. The first one is fast; the second one finds what is small, and what comes
/// slowly.
///
///     d = sum over joints of (y_j - m_j)^2 / v_j,   contact if d > threshold             (docs/theory.md (T61, T64))
///
/// The variance v_j consists of what noise, speed, change of speed and a turn-over of the joint have shown so far
/// (T62), and of what is known of the errors of the payload. While there is a contact, nothing is learned, unless the
/// estimator says that payload and arm explain what happens: then the means follow.
///
/// Real time: update() is O(Dofs), O(36 Dofs) each 10 ms; O(Dofs^3) during a contact. Nothing allocates or throws.
template <typename Scalar, int Dofs>
class ContactMonitor {
 public:
  using Vector = JointVector<Scalar, Dofs>;                    ///< [N m], unless something else is said
  static constexpr int kScales = 2;                            ///< number of scales
  static constexpr double kAverage[kScales] = {0.004, 0.025};  ///< time constants of the averages y [s]
  static constexpr double kMean[kScales] = {0.15, 1.0};        ///< of the means m that they are compared with [s]

  /// @param false_alarms  how often `contact` may be true while nothing touches the arm [1/h], > 0
  /// @param scale         of each joint: size of its noise and errors relative to a Panda's (ArmPrior::residual), > 0
  /// @param friction      of each joint, of which nothing is known but its size
  ContactMonitor(double false_alarms, const Vector& scale, const FrictionRegression<Scalar, Dofs>& friction) noexcept
      : scales_{Scale(false_alarms, scale, 0), Scale(false_alarms, scale, 1)}, scale_(scale), friction_(friction) {}

  /// Advances by one tick.
  /// @param residual  s, external torque minus what is explained, both filtered by the observer, finite
  /// @param jacobian  J, 6 x Dofs, world axes, linear rows first
  /// @param dq        joint velocity [rad/s]
  /// @param dt        time since the last sample [s], > 0
  /// @param time      of this sample [s]
  void update(const Vector& residual, const Jacobian<Scalar, Dofs>& jacobian, const Vector& dq, double dt,
              double time) noexcept;

  /// What the estimator makes of a block of samples.
  /// @param explained  whether payload and arm explain it: nothing changes or disturbs
  /// @param begin      when the block began [s]
  void judge(bool explained, double begin) noexcept {
    settled_ = explained;
    if (!explained || !state_.contact || begin < state_.last.noticed) explained_since_ = begin;
    explained_ = explained && state_.contact && begin - explained_since_ >= kPatience;
  }
  /// The same payload is known better: residual and mean change together, unless there is a contact.
  /// @param change  of what is explained now
  /// @param usual   of what was explained on average over the means of the scales
  void refine(const Vector& change, const Vector (&usual)[kScales]) noexcept {
    for (int i = 0; i < kScales; ++i) {
      Scale& s = scales_[i];
      s.average -= change;
      if (state_.contact) continue;
      s.mean -= usual[i];
      s.usual -= change;
    }
  }
  /// How much of the residual the mean of each joint has taken in since the last call, 0 to 1.
  /// @param scale  0 or 1
  Vector taken_in(int scale) noexcept {
    const Vector share = scales_[scale].taken_in;
    scales_[scale].taken_in.setZero();
    return share;
  }
  /// The payload is another one: the residual changes. Without a contact, the mean becomes what the residual shows, as
  /// far as the payload's errors leave it open.
  /// @param change  of what is explained
  void replace(const Vector& change) noexcept {
    for (Scale& s : scales_) s.average -= change;
    if (!state_.contact) take_over();
  }
  /// What is known of the errors of the explanation.
  /// @param variance  what errors of the payload's parameters add to the variance on each scale [(N m)^2]
  /// @param noise     the same for the noise of its acceleration. The arm's own noise comes from the same velocities, so
  ///                  that the two add up before they are squared
  void expect(const Vector (&variance)[kScales], const Vector (&noise)[kScales]) noexcept {
    for (int i = 0; i < kScales; ++i)
      for (int j = 0; j < Dofs; ++j)
        scales_[i].known[j] = variance[i][j] + noise[i][j] + 2 * std::sqrt(noise[i][j] * scales_[i].part[0][j]);
  }
  /// What the estimator knows of the arm.
  /// @param friction  probability that the torque contains joint friction; 0 at first
  /// @param turn      variance of the error of a joint of scale 1 that turns over, as long as none was seen [(N m)^2]; 0
  ///                  at first
  void expect_arm(Scalar friction, Scalar turn) noexcept {
    friction_share_ = friction;
    turn_ = turn;
  }
  /// The next sample has no predecessor; what was learned stays. Until it comes, the state is not ready.
  void interrupt() noexcept { started_ = state_.ready = false; }
  /// The torque changes at once for a reason that the host has given. A contact that goes on is over.
  void reopen() noexcept {
    interrupt();
    finish(state_.last.noticed);
    watched_ = 0;
  }
  /// What the last contact turned out to be. One that was the arm's own error raises the threshold.
  void decide(ContactCause cause) noexcept {
    state_.last.cause = cause;
    if (cause != ContactCause::Arm) return;
    for (Scale& s : scales_) s.threshold.learn(static_cast<double>(s.threshold.threshold()));
  }
  /// Whether the last contact ended because the mean followed it, not because the residual came back.
  bool followed() const noexcept { return followed_; }

  const ContactState<Scalar, Dofs>& state() const noexcept { return state_; }  ///< what the host reads

 private:
  static constexpr double kWarmUp = 1;      // time before the first contact can be noticed [s]
  static constexpr double kLearn = 0.02;    // time between two samples that variances are learned from [s]
  static constexpr int kMemory = 1000;      // such samples that are remembered: 20 s
  static constexpr double kFirst = 10;      // samples that the variance counts as before anything was seen
  static constexpr double kPatience = 0.2;  // how long the estimator has to explain a contact before a mean follows [s]
  static constexpr double kFollow = 0.2;    // time constant of a mean that follows what the estimator explains [s]
  static constexpr double kRevert = 1;      // time constant with which a mean that is kept becomes uncertain [s]
  static constexpr double kUsual = 30;      // memory of what is usual in the long run [s]
  static constexpr double kQuiet = 0.02;    // how long the statistic has to be usual at the end of a contact [s]
  // After a contact its tail is still in the averages, and the arm swings back: for a while the means follow quickly,
  // and only a residual twice as large as usual is another contact.
  // The averages lag by up to 25 ms, so that seven time constants leave less than 1 % of their change in the means.
  static constexpr double kSettle = 0.2, kQuick = 0.03;  // how long, and the time constant [s]
  static constexpr double kAgain = 4;                    // threshold of the statistic meanwhile, relative to the usual
  static constexpr double kChange = 0.1;    // memory of dq, whose difference from it is the change of speed [s]
  static constexpr double kStill = 0.02;    // speed of a joint below which it turns over [rad/s]
  static constexpr double kTurned = 0.1;    // how long after that friction still settles [s]
  static constexpr double kLargest = 9;     // bound of a squared error in multiples of its variance
  static constexpr double kRefresh = 0.01;  // time between two wrenches while nothing touches the arm [s]
  static constexpr double kForce = 100, kMoment = 20;  // prior standard deviations of the wrench [N], [N m]
  // Standard deviations before anything was seen, for a joint of scale 1: noise [N m], errors in motion [N m s/rad],
  // errors of friction that turns over [N m].
  static constexpr double kNoise = 0.05, kMotion = 0.1, kFriction = 0.05;
  static constexpr int kParts = 4;  // of a variance: noise, speed, change of speed, turn-over

  struct Scale {
    Scale(double false_alarms, const Vector& scale, int index) noexcept
        : threshold(std::min(0.5, false_alarms * ExtremeThreshold<Scalar, Dofs>::kWindow / 3600 / kScales)),
          smooth(static_cast<Scalar>(kAverage[index])),
          slow(static_cast<Scalar>(kMean[index])) {
      const double first[kParts] = {kNoise, kMotion, kMotion, kFriction};
      for (int p = 0; p < kParts; ++p) {
        seen[p].setZero();
        part[p] = detail::scaled(static_cast<Scalar>(first[p] * first[p]), Vector(scale.cwiseProduct(scale)));
      }
    }
    ExtremeThreshold<Scalar, Dofs> threshold;
    Scalar smooth, slow;                                     // time constants of y and m [s]
    Vector average = Vector::Zero(), mean = Vector::Zero();  // y, m
    Vector taken_in = Vector::Zero();                        // taken_in()
    Vector usual = Vector::Zero(), spread = Vector::Zero();  // of y in the long run: mean and variance
    Vector part[kParts];                                     // parts of the variance per unit of what causes them
    Vector seen[kParts];                                     // samples that each was learned from
    Vector unseen = Vector::Zero();                          // added to the last part, as long as little was seen of it
    Vector known = Vector::Zero();                           // errors of the payload [(N m)^2]
    Vector loose = Vector::Zero();                           // the part of v that is an error of the mean
    Vector variance = Vector::Ones();                        // v
    Scalar statistic = Scalar(0), largest = Scalar(0);       // d, and its maximum in this window
  };

  static Scalar blend(double dt, Scalar time) noexcept {  // of a first-order filter, without a call of exp
    const auto h = static_cast<Scalar>(dt);
    return h / (h + time);
  }
  /// As far as the mean is not known, it is what the residual shows.
  void take_over() noexcept {
    for (Scale& s : scales_) {
      for (int j = 0; j < Dofs; ++j) {
        const Scalar loose = std::max(s.loose[j], s.known[j]), share = loose / std::max(s.variance[j], loose);
        s.mean[j] += share * (s.average[j] - s.mean[j]);
        s.taken_in[j] += share * (Scalar(1) - s.taken_in[j]);
      }
    }
  }
  void begin(double time) noexcept;
  void finish(double time) noexcept;
  void learn(Scale& scale) noexcept;
  void find_wrench() noexcept;

  Scale scales_[kScales];
  Vector scale_;
  FrictionRegression<Scalar, Dofs> friction_;
  Scalar friction_share_ = Scalar(0);  // probability that there is any
  Scalar turn_ = Scalar(0);            // expect_arm() [(N m)^2]
  ContactState<Scalar, Dofs> state_;
  bool started_ = false;
  Vector cause_[kParts];             // what the parts of the variance are multiplied by
  Vector slow_dq_ = Vector::Zero();  // dq, averaged over kChange
  Vector turned_ = Vector::Zero();   // 1 while a joint turns over, then fading
  Jacobian<Scalar, Dofs> jacobian_ = Jacobian<Scalar, Dofs>::Zero();
  double watched_ = 0;  // time that was watched since construction or reopen() [s]
  double since_learned_ = 0, since_wrench_ = 0, window_ = 0, quiet_ = 0, age_ = 0;  // [s]
  double usual_at_ = 0;  // when the fast statistic was usual last [s]
  int learned_ = 0;      // samples that variances were learned from
  bool clean_ = true;    // nothing has happened in this window
  bool settled_ = true, explained_ = false, followed_ = false;
  double settle_ = 0;           // how long the last contact still settles [s]
  double explained_since_ = 0;  // [s]
  ContactLink<Scalar, Dofs> link_;
};

template <typename Scalar, int Dofs>
void ContactMonitor<Scalar, Dofs>::update(const Vector& residual, const Jacobian<Scalar, Dofs>& jacobian,
                                          const Vector& dq, double dt, double time) noexcept {
  jacobian_ = jacobian;
  friction_.update(dq, static_cast<Scalar>(dt));
  const Vector friction = friction_.torque(), unexplained = detail::difference(residual, friction);
  if (!started_) {
    started_ = true;
    const bool first = watched_ == 0;
    slow_dq_ = dq;
    for (Scale& s : scales_) {
      s.average = unexplained;
      if (first) s.mean = s.usual = unexplained;
    }
  }
  watched_ += dt;
  const bool contact = state_.contact;
  age_ = contact ? age_ + dt : 0;
  Scalar speed = Scalar(0), change = Scalar(0), moved = Scalar(0);
  detail::add_scaled(slow_dq_, blend(dt, Scalar(kChange)), detail::difference(dq, slow_dq_));
  for (int j = 0; j < Dofs; ++j) {
    const Scalar away = dq[j] - slow_dq_[j];
    speed += dq[j] * dq[j];
    change += away * away;
    moved += slow_dq_[j] * slow_dq_[j];
  }
  // A joint that hardly moves while the arm moves, or has just moved, turns over, stops, or is about to break away.
  const Scalar still = Scalar(kStill * kStill), fade = Scalar(1) - blend(dt, Scalar(kTurned));
  const Scalar moves = (moved + change) / (moved + change + Scalar(0.25) * still);
  for (int j = 0; j < Dofs; ++j) turned_[j] = std::max(fade * turned_[j], moves * friction_.rest()[j]);
  cause_[0].setOnes();
  cause_[1].setConstant(speed);
  cause_[2].setConstant(change);
  cause_[3] = turned_;
  Scalar largest = Scalar(0);
  settle_ = std::max(0.0, settle_ - dt);
  const Scalar doubt = Scalar(1) + Scalar(10) / static_cast<Scalar>(learned_ + 1);
  const Scalar grown = contact ? std::min(Scalar(1), static_cast<Scalar>(2 * age_ / kRevert)) : Scalar(0);
  const Vector stuck = friction_.variance(friction_share_);
  for (Scale& s : scales_) {
    detail::add_scaled(s.average, blend(dt, s.smooth), detail::difference(unexplained, s.average));
    Scalar follow = blend(dt, settle_ > 0 ? Scalar(kQuick) : s.slow);
    if (contact) follow = explained_ ? blend(dt, Scalar(kFollow)) : Scalar(0);
    Scalar statistic = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      Scalar v = s.part[0][j] + s.unseen[j] * cause_[kParts - 1][j];
      for (int p = 1; p < kParts; ++p) v += s.part[p][j] * cause_[p][j];
      s.loose[j] = s.known[j] + grown * s.spread[j];
      s.variance[j] = doubt * v + stuck[j] + s.loose[j];
      const Scalar e = s.average[j] - s.mean[j];
      statistic += e * e / s.variance[j];
      s.mean[j] += follow * e;
      s.taken_in[j] += follow * (Scalar(1) - s.taken_in[j]);
    }
    s.statistic = statistic;
    largest = std::max(largest, statistic / s.threshold.threshold());
    s.largest = std::max(s.largest, statistic);
  }
  state_.statistic = largest;
  if (scales_[0].statistic <= scales_[0].threshold.usual()) usual_at_ = time;
  if (!state_.ready && watched_ >= kWarmUp - 1e-9) {
    state_.ready = true;
    clean_ = false;
  }
  if (state_.ready && !contact && largest > Scalar(settle_ > 0 ? kAgain : 1)) begin(time);
  if (state_.contact) {
    bool usual = true;
    for (const Scale& s : scales_) usual &= s.statistic <= s.threshold.usual();
    quiet_ = usual ? quiet_ + dt : 0;
    if (quiet_ >= kQuiet - 1e-9) finish(time);
  }
  clean_ &= !state_.contact && settled_ && !(settle_ > 0);

  since_learned_ += dt;
  if (since_learned_ >= kLearn - 1e-9) {
    since_learned_ = 0;
    if ((!state_.contact && settled_) || explained_) {
      learned_ = std::min(learned_ + 1, kMemory);
      for (Scale& s : scales_) learn(s);
      if (!state_.contact) {
        friction_.learn(residual);
        const Vector step = detail::difference(friction_.torque(), friction);
        refine(step, {step, step});
      }
    }
  }
  window_ += dt;
  if (window_ >= ExtremeThreshold<Scalar, Dofs>::kWindow - 1e-9) {
    for (Scale& s : scales_) {
      if (clean_) s.threshold.learn(static_cast<double>(s.largest));
      s.largest = Scalar(0);
    }
    window_ = 0;
    clean_ = state_.ready && !state_.contact && settled_;
  }

  const Scale& fast = scales_[0];
  state_.residual = detail::difference(fast.average, fast.mean);
  state_.variance = fast.variance;
  since_wrench_ += dt;
  if (state_.contact || since_wrench_ >= kRefresh - 1e-9) {
    since_wrench_ = 0;
    for (int j = 0; j < Dofs; ++j) {
      Scalar least = fast.variance[j] * fast.threshold.threshold();
      least = std::min(least, scales_[1].variance[j] * scales_[1].threshold.threshold());
      state_.threshold[j] = std::sqrt(least);
    }
    find_wrench();
    if (state_.contact) {
      link_.update(jacobian_, state_.residual, state_.variance, state_.link);
      state_.last.peak_torque =
          std::max(state_.last.peak_torque, std::sqrt(detail::dot(state_.residual, state_.residual)));
      state_.last.peak_force = std::max(state_.last.peak_force, state_.wrench.force.norm());
    }
  }
}

template <typename Scalar, int Dofs>
void ContactMonitor<Scalar, Dofs>::begin(double time) noexcept {
  state_.contact = true;
  state_.last = ContactEvent<Scalar>{state_.last.number + 1, ContactCause::Undecided, usual_at_, time};
  quiet_ = age_ = 0;
  explained_ = followed_ = false;
  link_ = ContactLink<Scalar, Dofs>();
  state_.link.setConstant(Scalar(1) / Scalar(Dofs));
  for (int j = 0; j < Dofs; ++j) link_.update(jacobian_, state_.residual, state_.variance, state_.link);
}

template <typename Scalar, int Dofs>
void ContactMonitor<Scalar, Dofs>::finish(double time) noexcept {
  if (!state_.contact) return;
  state_.contact = false;
  state_.last.over = time;
  state_.link.setZero();
  followed_ = explained_;
  explained_ = false;
  take_over();
  settle_ = kSettle;
}

/// Updates the parts of the variance of one scale: each has the share of the error that it has of the variance (T62).
template <typename Scalar, int Dofs>
void ContactMonitor<Scalar, Dofs>::learn(Scale& s) noexcept {
  const Scalar long_run = Scalar(std::max(kLearn / kUsual, 1.0 / (learned_ + 1)));
  for (int j = 0; j < Dofs; ++j) {
    const Scalar v = s.variance[j], e = s.average[j] - s.mean[j];
    const Scalar excess = std::min(e * e / v, Scalar(kLargest)) - Scalar(1);
    for (int p = 0; p < kParts; ++p) {
      const Scalar part = s.part[p][j] + (p == kParts - 1 ? s.unseen[j] : Scalar(0)), share = part * cause_[p][j] / v;
      s.seen[p][j] = std::min(s.seen[p][j] + share, Scalar(kMemory));
      s.part[p][j] *= Scalar(1) + 2 * share * excess / (s.seen[p][j] + Scalar(kFirst));
      // The floor keeps a part alive that was not needed so far.
      s.part[p][j] = std::max(s.part[p][j], Scalar(1e-8) * scale_[j] * scale_[j]);
    }
    s.unseen[j] = turn_ * scale_[j] * scale_[j] * Scalar(kFirst) / (s.seen[kParts - 1][j] + Scalar(kFirst));
    const Scalar away = s.average[j] - s.usual[j];
    s.usual[j] += long_run * away;
    s.spread[j] += long_run * (away * away - s.spread[j]);
  }
}

/// w = P J V^-1 s,   P = (W^-1 + J V^-1 J^T)^-1 (T65).
template <typename Scalar, int Dofs>
void ContactMonitor<Scalar, Dofs>::find_wrench() noexcept {
  Matrix6<Scalar> information = Matrix6<Scalar>::Zero();
  for (int i = 0; i < 6; ++i) {
    const double size = i < 3 ? kForce : kMoment;
    information(i, i) = Scalar(1 / (size * size));
  }
  Vector6<Scalar> sum = Vector6<Scalar>::Zero();
  for (int j = 0; j < Dofs; ++j) {
    const Scalar precision = Scalar(1) / state_.variance[j];
    const Vector6<Scalar> row = detail::column(jacobian_, j);
    detail::add_outer(information, detail::scaled(precision, row), row);
    detail::add_scaled(sum, precision * state_.residual[j], row);
  }
  const Cholesky<Scalar, 6> factor(information);
  if (!factor.positive_definite()) return;
  state_.wrench_covariance = factor.inverse();
  state_.wrench = Wrench<Scalar>::from_vector(detail::product(state_.wrench_covariance, sum));
}

}  // namespace rme
