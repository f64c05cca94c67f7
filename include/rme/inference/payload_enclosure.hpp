#pragma once
/// All payloads that agree with readings at rest whose errors stay within stated bounds: a bound instead of a
/// probability.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/linear_program.hpp>
#include <rme/inference/payload_regressor.hpp>

namespace rme {

/// What is stated about the errors of a reading, per joint, and about what can be held. A reading is the external
/// torque of an arm at rest, in practice the mean over a window:
///
///     tau = (1 + gain error) A phi + offset + friction + link error      (docs/theory.md (T46))
///
/// These are bounds, not standard deviations: a single error beyond its bound can put the true payload outside the set.
/// Infinite means that nothing is stated. drift has to be set.
template <typename Scalar, int Dofs>
struct PayloadEnclosureConfig {
  using Vector = JointVector<Scalar, Dofs>;                                 ///< one bound per joint
  static constexpr Scalar kNone = std::numeric_limits<Scalar>::infinity();  ///< nothing is stated

  /// The most by which the sensor's offset differs between any two of the readings, with the noise that is left in the
  /// two [N m], > 0.
  Vector drift = Vector::Zero();
  /// |friction| of each reading, as far as the sensor sees it [N m], >= 0. At rest it may have either sign, and another
  /// one in each reading.
  Vector friction = Vector::Zero();
  /// |offset| of each reading [N m], > 0. With it a reading also counts by itself, not only in differences.
  Vector offset = Vector::Constant(kNone);
  /// |link error|: gravity torque of the arm's own links that its model has wrong [N m], >= 0. It is the same in all
  /// readings of a pose, so that it cancels in their difference, and unrelated from one pose to another.
  Vector link = Vector::Constant(kNone);
  /// |gain error|, of the sensor, or for lengths of links that the model has wrong; it scales with the payload. At least
  /// 0, below 1.
  Vector gain = Vector::Zero();
  Scalar mass_limit = kNone;                                      ///< 0 <= m <= this [kg], > 0
  Vector3<Scalar> com_lower = Vector3<Scalar>::Constant(-kNone);  ///< of the centre of mass [m], end-effector axes
  Vector3<Scalar> com_upper = Vector3<Scalar>::Constant(kNone);   ///< [m], at least com_lower
};

/// The smallest box around the enclosure, end-effector axes, about the end-effector origin: each end is attained by a
/// payload that agrees with every reading, but for rounding, which is always outwards. An end is infinite where nothing
/// bounds it.
template <typename Scalar>
struct PayloadBox {
  Scalar mass_lower = Scalar(0);                           ///< [kg], >= 0
  Scalar mass_upper = Scalar(0);                           ///< [kg]
  Vector3<Scalar> moment_lower = Vector3<Scalar>::Zero();  ///< of the first moment m r [kg m]
  Vector3<Scalar> moment_upper = Vector3<Scalar>::Zero();  ///< [kg m]
  Vector3<Scalar> com_lower =
      Vector3<Scalar>::Zero();  ///< of the centre of mass r [m]; as stated if m may be 0, or is unbounded
  Vector3<Scalar> com_upper = Vector3<Scalar>::Zero();  ///< [m]
  /// The least factor by which all stated bounds (not those of mass and centre of mass) could be multiplied so that
  /// some payload still agrees with every reading, >= 0. Above 1 the enclosure is empty: some bound was violated.
  Scalar scale = Scalar(0);
};

/// The set of all payloads phi = (m, m r) that agree with the readings (docs/theory.md (T46) to (T48)). A payload at
/// rest is linear in phi, so the set is a polytope. That of the *differences* of readings needs no bound on the offset:
/// what is the same before and after an attachment cancels. The errors are eliminated exactly: a payload is in the
/// set if and only if some errors within the bounds explain all readings together. With gain > 0 that holds for one
/// pose; over several poses the set may be larger than needed, never smaller.
///
/// The pose of an object in the hand, and the object, must not change between loaded readings. "The same pose" means
/// that the arm may sag, as long as the change of the link error stays within `drift`.
///
///     PayloadEnclosure<double, 7> enclosure(config);
///     enclosure.add_change(before, after, payload_regressor<double, 7>(jacobian, rotation, gravity));
///     PayloadBox<double> box;
///     if (enclosure.solve(box) == Status::Infeasible) ...  // a stated bound was violated
///
/// Real time: no allocation; every call is bounded. Not small: 27 KB in double for seven joints and four poses.
/// @tparam Dofs      number of joints
/// @tparam MaxPoses  most calls of add_change(), add_loaded() and add_empty() together
template <typename Scalar, int Dofs, int MaxPoses = 4>
class PayloadEnclosure {
 public:
  using Vector = JointVector<Scalar, Dofs>;             ///< joint torque [N m]
  using Regressor = PayloadRegressor<Scalar, Dofs>;     ///< of a pose
  using Config = PayloadEnclosureConfig<Scalar, Dofs>;  ///< what is stated

  /// @throws std::invalid_argument naming the field out of range
  explicit PayloadEnclosure(const Config& config);

  /// Adds two readings in the same pose.
  /// @param before     tau_ext with the empty hand [N m]
  /// @param after      tau_ext with the payload [N m]
  /// @param regressor  of the pose: payload_regressor()
  /// @return Ok; NonFiniteInput, also beyond kLargestPlausible; CapacityExceeded. Unless Ok, nothing has been added.
  Status add_change(const Vector& before, const Vector& after, const Regressor& regressor) noexcept;
  /// Adds a reading with the payload in a pose of its own; the same status. Without a bound on link it is of no use.
  Status add_loaded(const Vector& after, const Regressor& regressor) noexcept;
  /// Adds a reading with the empty hand in a pose of its own; the same status. Without a bound on link it is of no use.
  Status add_empty(const Vector& before) noexcept;
  /// Forgets all readings.
  void clear() noexcept;

  /// The box around the set: some 25 small linear programs.
  /// @param[out] box  as it was for NotReady. Infeasible: all intervals are empty, from infinity to -infinity, and
  ///                  `scale` is by how much the bounds are too small at least
  /// @return Ok; Unbounded: some end is infinite, the others are right; Infeasible: no payload agrees with the readings,
  ///         so some stated bound was violated; NotReady: no loaded reading that a bound applies to; NotConverged: as
  ///         Unbounded, but an end is infinite because there were too few steps
  Status solve(PayloadBox<Scalar>& box) noexcept;

  /// The worst cases of quantities that are linear in phi: least and largest map phi over the set, each row by itself.
  /// To be called after solve(), each tick if need be. With the regressor's rows (see the other overload) it is the
  /// torque of the payload; with M^-1 times these, what an acceleration that was predicted without it lacks.
  /// @param map         Rows x 4, for (m, m r)
  /// @param[out] lower  Rows x 1, and
  /// @param[out] upper  are as they were unless the status is Ok or Unbounded: then some end is infinite
  /// @return Ok; Unbounded; NonFiniteInput; NotReady (no solve() since the last reading); Infeasible (the set is empty);
  ///         NotConverged
  template <int Rows>
  Status range(const Eigen::Matrix<Scalar, Rows, 4>& map, Eigen::Matrix<Scalar, Rows, 1>& lower,
               Eigen::Matrix<Scalar, Rows, 1>& upper) noexcept;
  /// The payload's torque of each joint in a pose, which may be another one than those of the readings: least and
  /// largest [N m]. The same status.
  Status range(const Regressor& regressor, Vector& lower, Vector& upper) noexcept {
    return range(matrix(regressor), lower, upper);
  }

 private:
  // The unknowns of the program are (m, m r, unit_ s): s is the factor of the stated bounds.
  static constexpr int kSize = 5;
  static constexpr int kPairs = MaxPoses * (3 * MaxPoses - 1) / 2;  // of readings, at least one of them loaded
  static constexpr int kRows = 2 * Dofs * (kPairs + MaxPoses) + 8;
  static constexpr int kReadings = 2 * MaxPoses;
  static constexpr Scalar kNone = Config::kNone;
  static constexpr Scalar kEpsilon = std::numeric_limits<Scalar>::epsilon();
  using Unknowns = Eigen::Matrix<Scalar, kSize, 1>;
  using Map = Eigen::Matrix<Scalar, Dofs, 4>;

  struct Reading {
    Vector torque;
    Map A;  // tau = A phi; zero for the empty hand
    bool loaded;
    int pose;
  };

  static Map matrix(const Regressor& regressor) noexcept {
    Map A;
    for (int j = 0; j < Dofs; ++j) {
      A(j, 0) = regressor.a[j];
      for (int i = 0; i < 3; ++i) A(j, 1 + i) = regressor.B(j, i);
    }
    return A;
  }
  Status add(const Vector* before, const Vector* after, const Map& A) noexcept;
  void constrain(const Reading& a, const Reading* b) noexcept;
  void constrain(const Vector4<Scalar>& row, Scalar lower, Scalar upper) noexcept;
  void constrain(const Unknowns& row, Scalar b) noexcept;
  void limit() noexcept;
  Status find_start(Scalar& scale) noexcept;
  Status end(const Unknowns& c, Scalar& upper) noexcept;
  Status com_end(int axis, Scalar sign, Scalar lightest, Scalar& upper) noexcept;

  Config config_;
  Scalar unit_;  // that makes the coefficients of s as large as those of the payload
  std::array<Reading, kReadings> readings_;
  int count_ = 0, poses_ = 0;
  bool ready_ = false;              // some row has a payload
  Scalar least_scale_ = Scalar(0);  // by what has no payload: two readings of the empty hand
  Scalar loosest_ = Scalar(1);      // a factor with which the empty hand keeps all rows
  LinearProgram<Scalar, kSize, kRows> program_;
  Status solved_ = Status::NotReady;
};

template <typename Scalar, int Dofs, int MaxPoses>
PayloadEnclosure<Scalar, Dofs, MaxPoses>::PayloadEnclosure(const Config& config) : config_(config) {
  using detail::require;
  for (int j = 0; j < Dofs; ++j) {
    require(config.drift[j] > 0 && plausible(double(config.drift[j])), "PayloadEnclosureConfig::drift", "> 0 N m",
            config.drift[j]);
    require(config.friction[j] >= 0 && plausible(double(config.friction[j])), "PayloadEnclosureConfig::friction",
            ">= 0 N m", config.friction[j]);
    require(config.offset[j] > 0, "PayloadEnclosureConfig::offset", "> 0 N m", config.offset[j]);
    require(config.link[j] >= 0, "PayloadEnclosureConfig::link", ">= 0 N m", config.link[j]);
    require(config.gain[j] >= 0 && config.gain[j] < 1, "PayloadEnclosureConfig::gain", "at least 0, below 1",
            config.gain[j]);
  }
  require(config.mass_limit > 0, "PayloadEnclosureConfig::mass_limit", "> 0 kg", config.mass_limit);
  for (int i = 0; i < 3; ++i) {
    require(config.com_lower[i] < kNone, "PayloadEnclosureConfig::com_lower", "a finite number or -infinity",
            config.com_lower[i]);
    require(config.com_upper[i] > -kNone && config.com_upper[i] >= config.com_lower[i],
            "PayloadEnclosureConfig::com_upper", ">= com_lower", config.com_upper[i]);
  }
  unit_ = config.drift.minCoeff() / 10;  // an arm's A has some 10 N m/kg
  clear();
}

template <typename Scalar, int Dofs, int MaxPoses>
void PayloadEnclosure<Scalar, Dofs, MaxPoses>::clear() noexcept {
  count_ = poses_ = 0;
  ready_ = false;
  least_scale_ = Scalar(0);
  loosest_ = Scalar(1);
  solved_ = Status::NotReady;
  program_.clear();
  limit();
}

template <typename Scalar, int Dofs, int MaxPoses>
Status PayloadEnclosure<Scalar, Dofs, MaxPoses>::add_change(const Vector& before, const Vector& after,
                                                            const Regressor& regressor) noexcept {
  return add(&before, &after, matrix(regressor));
}

template <typename Scalar, int Dofs, int MaxPoses>
Status PayloadEnclosure<Scalar, Dofs, MaxPoses>::add_loaded(const Vector& after, const Regressor& regressor) noexcept {
  return add(nullptr, &after, matrix(regressor));
}

template <typename Scalar, int Dofs, int MaxPoses>
Status PayloadEnclosure<Scalar, Dofs, MaxPoses>::add_empty(const Vector& before) noexcept {
  return add(&before, nullptr, Map::Zero());
}

template <typename Scalar, int Dofs, int MaxPoses>
Status PayloadEnclosure<Scalar, Dofs, MaxPoses>::add(const Vector* before, const Vector* after, const Map& A) noexcept {
  if ((before && !plausible(*before)) || (after && !plausible(*after)) || !plausible(A)) return Status::NonFiniteInput;
  if (poses_ == MaxPoses) return Status::CapacityExceeded;
  solved_ = Status::NotReady;
  for (const Vector* torque : {before, after}) {
    if (!torque) continue;
    Reading& reading = readings_[static_cast<std::size_t>(count_)];
    reading.torque = *torque;
    reading.loaded = torque == after;
    reading.A = reading.loaded ? A : Map::Zero();
    reading.pose = poses_;
    constrain(reading, nullptr);
    for (int i = 0; i < count_; ++i) constrain(reading, &readings_[static_cast<std::size_t>(i)]);
    ++count_;
  }
  ++poses_;
  return Status::Ok;
}

/// Bounds of mass and centre of mass, which the factor s does not loosen: 0 <= m <= limit, lower m <= m r <= upper m.
template <typename Scalar, int Dofs, int MaxPoses>
void PayloadEnclosure<Scalar, Dofs, MaxPoses>::limit() noexcept {
  constrain(-Unknowns::Unit(0), Scalar(0));
  if (config_.mass_limit < kNone) constrain(Unknowns::Unit(0), config_.mass_limit);
  for (int i = 0; i < 3; ++i) {
    if (config_.com_lower[i] > -kNone)
      constrain(config_.com_lower[i] * Unknowns::Unit(0) - Unknowns::Unit(1 + i), Scalar(0));
    if (config_.com_upper[i] < kNone)
      constrain(Unknowns::Unit(1 + i) - config_.com_upper[i] * Unknowns::Unit(0), Scalar(0));
  }
}

template <typename Scalar, int Dofs, int MaxPoses>
void PayloadEnclosure<Scalar, Dofs, MaxPoses>::constrain(const Unknowns& row, Scalar b) noexcept {
  const Status status = program_.add(row, b);  // there is room for all, and the numbers are finite
  (void)status;                                // without a row the set would only be larger: its bounds stay valid
}

/// What the difference of two readings says, or, without b, a reading by itself (T47).
template <typename Scalar, int Dofs, int MaxPoses>
void PayloadEnclosure<Scalar, Dofs, MaxPoses>::constrain(const Reading& a, const Reading* b) noexcept {
  using std::abs;
  const bool same_pose = b && a.pose == b->pose;
  for (int j = 0; j < Dofs; ++j) {
    Scalar error = b ? std::min(config_.drift[j], 2 * config_.offset[j]) + 2 * config_.friction[j]
                     : config_.offset[j] + config_.friction[j];
    if (!same_pose) error += b ? 2 * config_.link[j] : config_.link[j];
    if (!(error <= Scalar(kLargestPlausible))) continue;
    const Scalar difference = b ? a.torque[j] - b->torque[j] : a.torque[j];
    const Vector4<Scalar> row = b ? Vector4<Scalar>(a.A.row(j) - b->A.row(j)) : Vector4<Scalar>(a.A.row(j));
    // Rounding of the torques, and of A with the payloads that the limits allow: else a truth at the bounds could be
    // outside. Where no limit is stated, only the torque says how large the terms of A phi are.
    Scalar terms = error + abs(a.torque[j]) + (b ? abs(b->torque[j]) : Scalar(0));
    if (config_.mass_limit < kNone) {
      for (int i = 0; i < 4; ++i) {
        const Scalar arm = i == 0 ? Scalar(1) : std::max(abs(config_.com_lower[i - 1]), abs(config_.com_upper[i - 1]));
        if (arm < kNone) terms += config_.mass_limit * arm * (abs(a.A(j, i)) + (b ? abs(b->A(j, i)) : Scalar(0)));
      }
    }
    error += 2 * kEpsilon * terms;
    const bool a_loaded = a.loaded, b_loaded = b && b->loaded;
    if (!a_loaded && !b_loaded) {
      least_scale_ = std::max(least_scale_, abs(difference) / error);
      continue;
    }
    const Scalar gain = config_.gain[j];
    if (a_loaded && b_loaded && gain > 0) continue;  // two gain errors: no linear row describes this
    // (1 + g) row.phi is within error of the difference for some |g| <= gain: an interval as well.
    Scalar lower = difference - error, upper = difference + error;
    // With b loaded and a empty, the row is minus that of the payload, and so are both ends: the same division.
    lower /= lower > 0 ? 1 + gain : 1 - gain;
    upper /= upper > 0 ? 1 - gain : 1 + gain;
    constrain(row, lower, upper);
  }
}

/// |row.phi - middle| <= s half.
template <typename Scalar, int Dofs, int MaxPoses>
void PayloadEnclosure<Scalar, Dofs, MaxPoses>::constrain(const Vector4<Scalar>& row, Scalar lower,
                                                         Scalar upper) noexcept {
  using std::abs;
  const Scalar middle = (lower + upper) / 2, half = (upper - lower) / 2;
  Unknowns coefficients;
  for (int i = 0; i < 4; ++i) coefficients[i] = row[i];
  coefficients[4] = -half / unit_;
  constrain(coefficients, middle);
  for (int i = 0; i < 4; ++i) coefficients[i] = -row[i];
  constrain(coefficients, -middle);
  loosest_ = std::max(loosest_, abs(middle) / half);
  ready_ = true;
}

/// The least s, from the empty hand and an s that explains it; then s is held at 1.
template <typename Scalar, int Dofs, int MaxPoses>
Status PayloadEnclosure<Scalar, Dofs, MaxPoses>::find_start(Scalar& scale) noexcept {
  Unknowns point = Unknowns::Zero();
  point[4] = unit_ * loosest_;
  Status status = program_.start(point);
  if (status != Status::Ok) return status;
  typename decltype(program_)::Result least;
  status = program_.maximise(-Unknowns::Unit(4), least);
  if (status != Status::Ok) return status;
  scale = std::max(-least.value / unit_, least_scale_);
  // Empty only if that is certain: -upper is a lower bound of the least s.
  if (std::max(-least.upper / unit_, least_scale_) > 1) return Status::Infeasible;
  least.x[4] = std::max(least.x[4], unit_);
  return program_.start(least.x, 1);
}

template <typename Scalar, int Dofs, int MaxPoses>
Status PayloadEnclosure<Scalar, Dofs, MaxPoses>::end(const Unknowns& c, Scalar& upper) noexcept {
  typename decltype(program_)::Result result;
  const Status status = program_.maximise(c, result);
  upper = status == Status::Ok ? result.upper : kNone;
  return status;
}

/// The largest sign * r_i = (m r)_i / m over the set (T48), if its lightest payload has a mass above zero. For every
/// rho, sign * r_i <= rho + max(sign (m r)_i - rho m) / m; with rho of the maximiser the next bound is lower
/// (Dinkelbach, Management Science 1967). Every step gives a valid bound; the number of steps decides only how close it
/// is.
template <typename Scalar, int Dofs, int MaxPoses>
Status PayloadEnclosure<Scalar, Dofs, MaxPoses>::com_end(int axis, Scalar sign, Scalar lightest,
                                                         Scalar& upper) noexcept {
  constexpr int kSteps = 12;
  typename decltype(program_)::Result result;
  Scalar rho = Scalar(0);
  Unknowns c = sign * Unknowns::Unit(1 + axis);
  upper = sign > 0 ? config_.com_upper[axis] : -config_.com_lower[axis];
  for (int step = 0; step < kSteps; ++step) {
    c[0] = -rho;
    const Status status = program_.maximise(c, result);
    if (status != Status::Ok) return status;  // without a bound of m r there is none of m, and the stated limit is left
    upper = std::min(upper, rho + std::max(result.upper, Scalar(0)) / lightest);
    const Scalar next = sign * result.x[1 + axis] / result.x[0];
    if (step > 0 && !(next > rho)) break;
    rho = next;
  }
  return Status::Ok;
}

template <typename Scalar, int Dofs, int MaxPoses>
Status PayloadEnclosure<Scalar, Dofs, MaxPoses>::solve(PayloadBox<Scalar>& box) noexcept {
  if (!ready_) return Status::NotReady;
  PayloadBox<Scalar> found;
  solved_ = find_start(found.scale);
  if (solved_ == Status::Infeasible) {
    const Vector3<Scalar> none = Vector3<Scalar>::Constant(kNone);
    box = {kNone, -kNone, none, -none, none, -none, found.scale};
  }
  if (solved_ != Status::Ok) return solved_;
  Status all = Status::Ok;
  const auto note = [&all](Status status) noexcept {
    if (status != Status::Ok && all != Status::NotConverged) all = status;
  };
  const auto both = [&](int k, Scalar& lower, Scalar& upper) noexcept {
    note(end(Unknowns::Unit(k), upper));
    note(end(-Unknowns::Unit(k), lower));
    lower = -lower;
  };
  both(0, found.mass_lower, found.mass_upper);
  found.mass_lower = std::max(found.mass_lower, Scalar(0));
  for (int i = 0; i < 3; ++i) both(1 + i, found.moment_lower[i], found.moment_upper[i]);
  found.com_lower = config_.com_lower;
  found.com_upper = config_.com_upper;
  for (int i = 0; i < 3; ++i) {
    if (found.mass_lower > 0) {
      note(com_end(i, Scalar(1), found.mass_lower, found.com_upper[i]));
      note(com_end(i, Scalar(-1), found.mass_lower, found.com_lower[i]));
      found.com_lower[i] = -found.com_lower[i];
    }
    if (!(found.com_lower[i] > -kNone && found.com_upper[i] < kNone)) note(Status::Unbounded);
  }
  box = found;
  return all;
}

template <typename Scalar, int Dofs, int MaxPoses>
template <int Rows>
Status PayloadEnclosure<Scalar, Dofs, MaxPoses>::range(const Eigen::Matrix<Scalar, Rows, 4>& map,
                                                       Eigen::Matrix<Scalar, Rows, 1>& lower,
                                                       Eigen::Matrix<Scalar, Rows, 1>& upper) noexcept {
  if (!plausible(map)) return Status::NonFiniteInput;
  if (solved_ != Status::Ok) return solved_;
  Eigen::Matrix<Scalar, Rows, 1> low, high;
  Status all = Status::Ok;
  for (int r = 0; r < Rows; ++r) {
    Unknowns c = Unknowns::Zero();
    for (int k = 0; k < 4; ++k) c[k] = map(r, k);
    const Status up = end(c, high[r]), down = end(-c, low[r]);
    low[r] = -low[r];
    for (const Status status : {up, down}) {
      if (status == Status::NotConverged) return status;
      if (status != Status::Ok) all = status;
    }
  }
  lower = low;
  upper = high;
  return all;
}

}  // namespace rme
