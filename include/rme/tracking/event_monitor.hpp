#pragma once
/// Events, from the probabilities of the modes.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <rme/core/cholesky.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/tracking/mode.hpp>

namespace rme {

/// Kinds of events.
enum class EventKind : std::uint8_t {
  None,       ///< nothing has happened yet
  Attached,   ///< something is in a hand that was empty
  Exchanged,  ///< the payload is heavier or lighter than before
  Removed,    ///< the hand is empty again
  Filling,    ///< the payload's mass has drifted
  Pushed,     ///< something pushed; the payload is the same as before
  Moved,      ///< the payload is as heavy as before, and its centre of mass is elsewhere: it has slipped or turned
};

/// The enumerator's name, for logs.
constexpr const char* to_string(EventKind kind) noexcept {
  switch (kind) {
    case EventKind::None:
      return "none";
    case EventKind::Attached:
      return "attached";
    case EventKind::Exchanged:
      return "exchanged";
    case EventKind::Removed:
      return "removed";
    case EventKind::Filling:
      return "filling";
    case EventKind::Pushed:
      return "pushed";
    case EventKind::Moved:
      return "moved";
  }
  return "unknown";
}

/// The last event that is over. Times count from the estimator's construction or reset.
struct Event {
  int number = 0;                    ///< number of events that are over, this one included; 0 before the first
  EventKind kind = EventKind::None;  ///< its kind
  double onset = 0;                  ///< when it began, to within a block [s]
  double noticed = 0;                ///< when it was noticed [s]
  double over = 0;                   ///< when it was found to be over [s]
};

/// Derives events from the likeliest mode (docs/theory.md, "What is reported"). An event begins when a change, a
/// disturbance or a pour is likeliest, or when the hand is found empty that held something, or the reverse. It is over
/// once Empty or Held has been likeliest for 0.1 s. It is also over 0.4 s after Changing was likeliest for the last
/// time, unless Disturbed is likeliest then. If the payload is then the same as before and nothing pushed, it does not
/// count as an event. A mass or a centre of mass has changed if it differs by more than the uncertainties before and
/// after explain, and by more than 2 % or 1 cm. No call allocates.
template <typename Scalar>
class EventMonitor {
 public:
  /// Advances by one block.
  /// @param probability  of each mode after the block
  /// @param begin        time at which the block begins [s]
  /// @param end          time at which the block ends [s]
  /// @param now          present time [s], later than `end` by the computation of the block
  /// @param payload      estimate after the block; of an empty hand, it does not matter
  void update(const PerMode<Scalar>& probability, double begin, double end, double now,
              const PayloadGaussian<Scalar>& payload) noexcept {
    Mode likeliest = Mode::Empty;
    for (std::size_t i = 1; i < kModes; ++i)
      if (probability.values[i] > probability[likeliest]) likeliest = static_cast<Mode>(i);
    const bool empty = likeliest == Mode::Empty, steady = likeliest == Mode::Held;
    const bool settled = empty || steady;
    if (!changing_) {
      if (settled && empty == was_empty_) {
        // The payload of a block that may belong to an event already is a mixture of those before and after it.
        if (probability[likeliest] > Scalar(kSure)) before_ = payload;
        return;
      }
      changing_ = true;
      exchanged_ = pushed_ = filled_ = false;
      onset_ = begin;
      noticed_ = now;
      quiet_ = 0;
      exchanged_at_ = -1;
    }
    if (likeliest == Mode::Changing || (settled && empty != was_empty_ && exchanged_at_ < 0)) {
      exchanged_ = true;
      exchanged_at_ = end;
    }
    pushed_ = pushed_ || likeliest == Mode::Disturbed;
    filled_ = filled_ || likeliest == Mode::Pouring;
    quiet_ = settled ? quiet_ + (end - begin) : 0;
    const bool known = exchanged_ && likeliest != Mode::Disturbed && end - exchanged_at_ > kKnown;
    if (quiet_ > kQuiet - 1e-9 || known) finish(empty, now, payload);
  }
  void reset() noexcept { *this = EventMonitor(); }  ///< an empty hand, no event

  bool changing() const noexcept { return changing_; }  ///< an event is going on
  double onset() const noexcept { return onset_; }      ///< when the current or the last change began [s]
  double noticed() const noexcept { return noticed_; }  ///< when that change was noticed [s]
  const Event& last() const noexcept { return last_; }  ///< the last event that is over
  /// The host says what is in the hand: an event that is going on is dropped.
  /// @param empty  whether the hand is empty
  void believe(bool empty) noexcept {
    changing_ = false;
    was_empty_ = empty;
  }

 private:
  static constexpr double kQuiet = 0.1;  // how long Empty or Held has to be likeliest at the end of an event [s]
  static constexpr double kKnown = 0.4;  // how long after a change the event is over in any case [s]
  static constexpr double kSure = 0.9;   // probability of Empty or Held below which a block may belong to an event
  // A centre of mass that is this near is the same [m], and so is one whose distance, squared and in standard
  // deviations, is not above kUnlike: three numbers exceed it as rarely as one number exceeds three standard
  // deviations.
  static constexpr double kNear = 0.01, kUnlike = 14.16;

  void finish(bool empty, double now, const PayloadGaussian<Scalar>& payload) noexcept {
    changing_ = false;
    EventKind kind = EventKind::None;
    if (empty != was_empty_)
      kind = empty ? EventKind::Removed : EventKind::Attached;
    else if (!empty && another_mass(payload))
      kind = filled_ && !exchanged_ ? EventKind::Filling : EventKind::Exchanged;
    else if (!empty && another_com(payload))
      kind = EventKind::Moved;
    else if (pushed_)
      kind = EventKind::Pushed;
    was_empty_ = empty;
    if (kind != EventKind::Pushed) before_ = payload;
    if (kind != EventKind::None) last_ = {last_.number + 1, kind, onset_, noticed_, now};
  }
  bool another_mass(const PayloadGaussian<Scalar>& after) const noexcept {
    using std::abs;
    using std::sqrt;
    const Scalar doubt = sqrt(before_.covariance(0, 0) + after.covariance(0, 0));  // about the difference
    return abs(after.mean[0] - before_.mean[0]) > std::max(3 * doubt, Scalar(0.02) * before_.mean[0]);
  }
  bool another_com(const PayloadGaussian<Scalar>& after) const noexcept {
    Vector3<Scalar> away;
    Matrix3<Scalar> doubt;
    for (int i = 0; i < 3; ++i) {
      away[i] = after.mean[1 + i] - before_.mean[1 + i];
      for (int j = 0; j < 3; ++j) doubt(i, j) = after.covariance(1 + i, 1 + j) + before_.covariance(1 + i, 1 + j);
    }
    if (!(detail::dot(away, away) > Scalar(kNear * kNear))) return false;
    const Cholesky<Scalar, 3> factor(doubt);
    if (!factor.positive_definite()) return false;
    const Vector3<Scalar> white = factor.solve_lower(away);
    return detail::dot(white, white) > Scalar(kUnlike);
  }

  Event last_;
  bool was_empty_ = true;
  PayloadGaussian<Scalar> before_{Vector4<Scalar>::Zero(), Matrix4<Scalar>::Zero()};  // the payload before the event
  // of the current event: whether it goes on, and whether a change, a push and a pour were likeliest in it
  bool changing_ = false, exchanged_ = false, pushed_ = false, filled_ = false;
  double onset_ = 0, noticed_ = 0, quiet_ = 0, exchanged_at_ = -1;  // [s]
};

}  // namespace rme
