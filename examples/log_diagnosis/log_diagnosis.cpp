#include "log_diagnosis/log_diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <optional>

#include "log_diagnosis/advice.hpp"
#include "log_diagnosis/torque_fit.hpp"
#include "log_format/zero_phase.hpp"

namespace rme::examples {

namespace {

constexpr double kPi = 3.141592653589793, kDegree = kPi / 180, kRpm = kPi / 30;
constexpr double kStandardGravity = 9.81;  // [m/s^2]

/// printf into a string.
template <typename... Values>
std::string say(const char* format, Values... values) {
  char text[400];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

bool near(double value, double target, double tolerance) {
  return std::abs(value - target) <= tolerance * std::abs(target);
}

std::string list(const std::vector<Eigen::Index>& joints) {
  std::string out;
  for (const Eigen::Index j : joints) out += (out.empty() ? "" : ", ") + std::to_string(j + 1);
  return out;
}

double median_step(const std::vector<double>& t) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < t.size(); ++i) steps.push_back(t[i] - t[i - 1]);
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

// --- dq against the differences of q -----------------------------------------------------------------------------

/// Increments of q over some hundred windows, and the integrals of dq over the same.
struct Increments {
  Eigen::MatrixXd q, dq;
};

Increments increments(const DiagnosedLog& log) {
  constexpr std::size_t kWindows = 400, kLeast = 4;  // windows; rows in one
  const std::size_t rows = log.t.size(), width = std::max(kLeast, rows / kWindows), n = (rows - 1) / width;
  Increments out{Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), log.q.cols()),
                 Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), log.q.cols())};
  for (std::size_t k = 0; k < n; ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    const std::size_t begin = k * width, end = begin + width;
    out.q.row(row) = log.q.row(static_cast<Eigen::Index>(end)) - log.q.row(static_cast<Eigen::Index>(begin));
    for (std::size_t i = begin; i < end; ++i)
      out.dq.row(row) += 0.5 * (log.t[i + 1] - log.t[i]) *
                         (log.dq.row(static_cast<Eigen::Index>(i)) + log.dq.row(static_cast<Eigen::Index>(i + 1)));
  }
  return out;
}

/// Finds what is wrong with dq or the unit of t, and mends it in `log`.
void judge_velocity(DiagnosedLog& log, const Advice& advice, std::vector<Finding>& findings) {
  constexpr double kLike = 0.9, kUnlike = 0.7, kSame = 0.2;  // correlations; tolerance of a factor
  const auto unit = [&](double factor, const char* name) {
    for (double& t : log.t) t *= factor;
    findings.push_back({Fault::TimeUnit, say("t is in %s, not in s", name), advice.scaled("t", factor)});
  };
  if (const double step = median_step(log.t); log.differentiated && step > 0.11) {
    constexpr std::pair<double, const char*> kUnits[] = {{1e-3, "ms"}, {1e-6, "us"}, {1e-9, "ns"}};
    for (const auto& [factor, name] : kUnits) {
      if (step * factor > 0.11) continue;
      unit(factor, name);
      log.dq /= factor;
      return;
    }
  }
  if (log.differentiated) return;
  const Increments by = increments(log);
  const Eigen::Index n = log.q.cols();
  const Eigen::VectorXd moved = by.q.colwise().norm(), said = by.dq.colwise().norm();
  const double most = moved.maxCoeff();
  if (!(most > 0)) return;
  std::vector<Eigen::Index> moving;
  for (Eigen::Index j = 0; j < n; ++j)
    if (moved[j] > 0.05 * most) moving.push_back(j);
  const auto like = [&](Eigen::Index v, Eigen::Index p) {
    return said[v] > 0 ? by.dq.col(v).dot(by.q.col(p)) / (said[v] * moved[p]) : 0;
  };
  const auto factor_of = [&](Eigen::Index v, Eigen::Index p) {
    return by.dq.col(v).dot(by.q.col(p)) / (moved[p] * moved[p]);
  };
  std::vector<double> factors;
  bool alike = true;
  for (const Eigen::Index j : moving) {
    alike = alike && std::abs(like(j, j)) > kLike;
    factors.push_back(factor_of(j, j));
  }
  const auto add = [&](const std::string& what, const std::string& option) {
    findings.push_back({Fault::Velocity, what, option});
  };
  const auto differentiate = [&] {
    std::vector<Eigen::VectorXd> q;
    for (Eigen::Index i = 0; i < log.q.rows(); ++i) q.emplace_back(log.q.row(i).transpose());
    for (Eigen::Index j = 0; j < n; ++j) {
      std::vector<Eigen::Matrix<double, 1, 1>> one(q.size());
      for (std::size_t i = 0; i < q.size(); ++i) one[i][0] = q[i][j];
      const auto slopes = zero_phase_derivative(log.t, one);
      for (std::size_t i = 0; i < q.size(); ++i) log.dq(static_cast<Eigen::Index>(i), j) = slopes[i][0];
    }
  };
  if (alike) {
    std::vector<double> sizes = factors;
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
    const double common = sizes[sizes.size() / 2];
    const bool same = std::all_of(factors.begin(), factors.end(), [&](double f) { return near(f, common, kSame); });
    if (same && near(common, 1, kSame)) return;
    if (same) {
      if (near(common, 1e3, kSame)) return unit(1e-3, "ms");
      if (near(common, 1e6, kSame)) return unit(1e-6, "us");
      if (near(common, 1e9, kSame)) return unit(1e-9, "ns");
      if (near(common, kDegree, kSame)) {
        log.q *= kDegree;
        findings.push_back({Fault::Degrees, "q is in degrees, dq is not", advice.scaled("q", kDegree)});
        return;
      }
      if (near(common, 1 / kDegree, kSame))
        add("dq is in degrees per second, q is not", advice.scaled("dq", kDegree));
      else if (near(common, 1 / kRpm, kSame))
        add("dq is in rpm", advice.scaled("dq", kRpm));
      else if (near(common, -1, kSame))
        add("dq has the opposite sign of q's differences", advice.scaled("dq", -1));
      else
        add(say("dq is %.3g times what q's differences say", common), advice.none("dq"));
      log.dq /= common;
      return;
    }
    std::vector<Eigen::Index> turned, other;
    for (std::size_t k = 0; k < moving.size(); ++k) {
      if (near(factors[k], -1, kSame)) turned.push_back(moving[k]);
      if (!near(std::abs(factors[k]), 1, kSame)) other.push_back(moving[k]);
    }
    if (other.empty()) {
      add("dq of joint " + list(turned) + " has the opposite sign of q's differences", advice.turned("dq", turned));
      for (const Eigen::Index j : turned) log.dq.col(j) *= -1;
      return;
    }
    add("dq of joint " + list(other) + " is not what q's differences say", advice.none("dq"));
    differentiate();
    return;
  }
  // Is it another joint's?
  std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), Eigen::Index(0));
  bool found = true;
  for (const Eigen::Index p : moving) {
    Eigen::Index best = 0;
    for (Eigen::Index v = 1; v < n; ++v)
      if (like(v, p) > like(best, p)) best = v;
    found = found && like(best, p) > kLike;
    order[static_cast<std::size_t>(p)] = best;
  }
  std::vector<Eigen::Index> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  found = found && std::unique(sorted.begin(), sorted.end()) == sorted.end();
  if (found) {
    add("dq has its joints in another order than q", advice.reordered({"dq"}, order));
    const Eigen::MatrixXd was = log.dq;
    for (Eigen::Index j = 0; j < n; ++j) log.dq.col(j) = was.col(order[static_cast<std::size_t>(j)]);
    return;
  }
  std::vector<Eigen::Index> unlike;
  for (const Eigen::Index j : moving)
    if (std::abs(like(j, j)) < kUnlike) unlike.push_back(j);
  if (unlike.empty()) return;  // noise
  const bool zero = said.maxCoeff() < 1e-9;
  add(zero ? "dq is zero although the arm moves" : "dq of joint " + list(unlike) + " is not the derivative of q",
      advice.none("dq"));
  differentiate();
}

// --- Torque -------------------------------------------------------------------------------------------------------

/// A log at some hundred instants, each from the rows around it.
class Instants {
 public:
  explicit Instants(const DiagnosedLog& log) : log_(log), half_(std::max(0.04, 3 * median_step(log.t))) {
    constexpr std::size_t kMost = 400;
    constexpr double kMargin = 0.15;  // [s]: torque is looked up so much earlier and later
    const std::size_t stride = std::max<std::size_t>(1, log.t.size() / kMost);
    for (std::size_t i = stride / 2; i < log.t.size(); i += stride) {
      const double t = log.t[i];
      if (t < log.t.front() + kMargin || t > log.t.back() - kMargin) continue;
      const auto [first, last] = rows(t);
      if (last - first < 4 || log.t[last - 1] - log.t[first] < 1.2 * half_) continue;  // a gap
      at_.push_back(t);
    }
    const auto n = static_cast<Eigen::Index>(at_.size());
    for (Eigen::MatrixXd* m : {&motion_.q, &motion_.dq, &motion_.ddq}) m->resize(n, log.q.cols());
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < log.q.cols(); ++j) {
        const LocalQuadratic velocity = around(log.dq, at_[static_cast<std::size_t>(i)], j);
        motion_.q(i, j) = around(log.q, at_[static_cast<std::size_t>(i)], j).value;
        motion_.dq(i, j) = velocity.value;
        motion_.ddq(i, j) = velocity.slope;
      }
    }
  }

  Eigen::Index size() const { return motion_.q.rows(); }
  const Motion& motion() const { return motion_; }
  /// The torque `delay` seconds later [N m].
  Eigen::MatrixXd torque(double delay) const {
    Eigen::MatrixXd out(size(), log_.tau.cols());
    for (Eigen::Index i = 0; i < size(); ++i)
      for (Eigen::Index j = 0; j < out.cols(); ++j)
        out(i, j) = around(log_.tau, at_[static_cast<std::size_t>(i)] + delay, j).value;
    return out;
  }

 private:
  std::pair<std::size_t, std::size_t> rows(double t) const {
    const auto first = std::lower_bound(log_.t.begin(), log_.t.end(), t - half_);
    const auto last = std::upper_bound(first, log_.t.end(), t + half_);
    return {static_cast<std::size_t>(first - log_.t.begin()), static_cast<std::size_t>(last - log_.t.begin())};
  }
  LocalQuadratic around(const Eigen::MatrixXd& of, double t, Eigen::Index j) const {
    auto [first, last] = rows(t);
    if (first == last) {  // in a gap
      first = std::min(first, log_.t.size() - 1);
      last = first + 1;
    }
    return local_quadratic(log_.t, first, last, t, [&](std::size_t i) { return of(static_cast<Eigen::Index>(i), j); });
  }

  const DiagnosedLog& log_;
  double half_;  // [s]
  std::vector<double> at_;
  Motion motion_;
};

/// Which columns of the log a joint's position and torque may come from in truth, and how.
struct JointMap {
  std::vector<Eigen::Index> position, torque;
  Eigen::VectorXd sign, offset, torque_sign;  // offset [rad]

  explicit JointMap(Eigen::Index n)
      : position(static_cast<std::size_t>(n)),
        torque(static_cast<std::size_t>(n)),
        sign(Eigen::VectorXd::Ones(n)),
        offset(Eigen::VectorXd::Zero(n)),
        torque_sign(Eigen::VectorXd::Ones(n)) {
    std::iota(position.begin(), position.end(), Eigen::Index(0));
    torque = position;
  }
  bool moves_as(const JointMap& other) const {
    return position == other.position && sign == other.sign && offset == other.offset;
  }
  Motion apply(const Motion& motion) const {
    Motion out = motion;
    for (Eigen::Index j = 0; j < sign.size(); ++j) {
      const Eigen::Index from = position[static_cast<std::size_t>(j)];
      out.q.col(j) = sign[j] * motion.q.col(from).array() + offset[j];
      out.dq.col(j) = sign[j] * motion.dq.col(from);
      out.ddq.col(j) = sign[j] * motion.ddq.col(from);
    }
    return out;
  }
  Eigen::MatrixXd apply(const Eigen::MatrixXd& tau) const {
    Eigen::MatrixXd out = tau;
    for (Eigen::Index j = 0; j < sign.size(); ++j)
      out.col(j) = torque_sign[j] * tau.col(torque[static_cast<std::size_t>(j)]);
    return out;
  }
};

/// An explanation of the log, with its cost.
struct Explanation {
  double cost;
  std::optional<Finding> finding;  // nothing: the log is right
};

/// How far outside of the limits the joints go, as a number of joints that do so clearly.
int beyond_limits(const Eigen::MatrixXd& q, const DiagnosedArm& arm) {
  constexpr double kTolerance = 0.2;  // [rad]
  int joints = 0;
  for (Eigen::Index j = 0; j < arm.joints(); ++j)
    joints += q.col(j).maxCoeff() > arm.q_max[j] + kTolerance || q.col(j).minCoeff() < arm.q_min[j] - kTolerance;
  return joints;
}

class TorqueJudge {
 public:
  TorqueJudge(const DiagnosedLog& log, const DiagnosedArm& arm, const GivenOptions& given, const Advice& advice)
      : log_(log),
        arm_(arm),
        given_(given),
        advice_(advice),
        instants_(log),
        fit_(log.t.back() - log.t.front()),
        tau_(instants_.torque(0)),
        model_(arm.torque(instants_.motion(), true)) {}

  /// The explanation that costs least, if it is a fault.
  std::optional<Finding> find() {
    constexpr double kClear = 8, kClearWithLoad = 30;  // [nats]; a load that comes and goes fits nothing well
    if (instants_.size() < 10) {
      remarks_.push_back("the log is too short to compare its torque with the model");
      return std::nullopt;
    }
    asis_ = fit_.fit(explained(model_));
    const FitQuality& right = asis_;
    right_ = right.cost + kBeyond * beyond_limits(instants_.motion().q, arm_);
    load();
    const double spread = (model_.gravity.rowwise() - model_.gravity.colwise().mean()).norm() /
                          std::sqrt(static_cast<double>(instants_.size()));
    if (!(spread > 0.02 * model_.gravity.cwiseAbs().maxCoeff()) || !(spread > 0))
      remarks_.push_back("gravity hardly changes in this log: it shows little of the torque's sign, unit and order");
    degrees();
    if (log_.measured) {
      gains();
      gravity();
      joint_maps();
      delay();
    } else {
      contained_gravity();
    }
    if (!best_ || best_->cost > right_ - (log_.may_hold ? kClearWithLoad : kClear)) return std::nullopt;
    return best_->finding;
  }
  /// What the log does not show for certain.
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  static constexpr double kBeyond = 10;  // what a joint beyond its limits costs [nats]

  Explained explained(const ModelTorque& model) const { return explained(model, instants_.motion(), tau_); }
  Explained explained(const ModelTorque& model, const Motion& motion, const Eigen::MatrixXd& tau) const {
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(tau.rows(), tau.cols());
    return {tau, motion, log_.measured ? Eigen::MatrixXd(model.inertial + model.gravity) : none, model.gravity,
            log_.measured};
  }
  void offer(double cost, Fault fault, const std::string& sentence, const std::string& option) {
    const bool beyond_too = fault != Fault::Degrees && fault != Fault::PositionSign && fault != Fault::PositionOffset &&
                            fault != Fault::JointOrder;
    if (beyond_too) cost += kBeyond * beyond_limits(instants_.motion().q, arm_);
    if (best_ && best_->cost <= cost) return;
    best_ = Explanation{cost, Finding{fault, sentence, option}};
  }

  void degrees() {
    Motion motion = instants_.motion();
    for (Eigen::MatrixXd* m : {&motion.q, &motion.dq, &motion.ddq}) *m *= kDegree;
    const double cost = fit_.fit(explained(arm_.torque(motion, false), motion, tau_), 1).cost;
    offer(cost + kBeyond * beyond_limits(motion.q, arm_), Fault::Degrees,
          log_.differentiated ? "q is in degrees" : "q and dq are in degrees", "--degrees");
  }

  void gains() {
    constexpr double kRelative = 0.12;  // greatest relative deviation of a gain that is known
    // Least |log| of a gain that is off, and what friction adds to it. Good logs of rough models reach two thirds of it.
    constexpr double kOff = 0.15, kOffByFriction = 0.45;
    // Friction over the model's torque, from which on a gain, or its sign, says nothing.
    constexpr double kFriction = 0.7, kSignFriction = 2;
    constexpr double kSure = 4;  // deviations
    // How much likelier the opposite sign has to be, if the gain is not known [nats]. Good logs say at least 2 for their own
    // sign, and 20 to 200 if friction shows.
    constexpr double kOpposite = 15;
    constexpr double kCommon = 0.12;  // tolerance of a gain that all joints have
    constexpr double kUnit = 0.5;     // tolerance of a unit, or of the opposite sign
    const Explained data = explained(model_);
    const std::vector<GainFit> fits = fit_.fit_gains(data);
    const Eigen::Index n = arm_.joints();
    std::vector<Eigen::Index> known, off, turned;  // joints; turned: of these, nothing is known but the sign
    for (Eigen::Index j = 0; j < n; ++j) {
      const GainFit& f = fits[static_cast<std::size_t>(j)];
      if (!(f.deviation < kRelative * std::abs(f.gain)) || !(f.friction < (f.gain < 0 ? kSignFriction : kFriction))) {
        if (f.opposite > kOpposite) turned.push_back(j);
        continue;
      }
      known.push_back(j);
      const bool wrong = f.gain < 0 || std::abs(std::log(f.gain)) > kOff + kOffByFriction * f.friction;
      if (wrong && std::abs(f.gain - 1) > kSure * f.deviation) off.push_back(j);
    }
    if (off.empty() && turned.empty()) return;
    const auto cost_of = [&](const Eigen::VectorXd& k, int parameters) {
      Explained scaled = data;
      for (Eigen::Index j = 0; j < n; ++j) {
        scaled.tau.col(j) *= k[j] < 0 ? -1 : 1;
        scaled.base.col(j) *= std::abs(k[j]);
      }
      return fit_.fit(scaled, parameters).cost;
    };
    // The same for all?
    const auto all_near = [&](const Eigen::VectorXd& unit, double tolerance) {
      return known.size() > 1 && std::all_of(known.begin(), known.end(), [&](Eigen::Index j) {
               return near(fits[static_cast<std::size_t>(j)].gain, unit[j], tolerance);
             });
    };
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(n);
    if (all_near(-ones, kUnit)) {
      offer(cost_of(-ones, 1), Fault::TorqueSign, "the torque has the opposite sign",
            std::string("--torque-sign ") + (given_.external_sign ? "reaction" : "external"));
      return;
    }
    for (const double milli : {1e3, -1e3}) {
      if (!all_near(milli * ones, kUnit)) continue;
      offer(cost_of(milli * ones, 1), Fault::TorqueUnit,
            std::string("the torque is in mN m") + (milli < 0 ? ", with the opposite sign" : ""),
            advice_.gains(given_.gains / milli));
      return;
    }
    if (arm_.tau_max.allFinite() && (arm_.tau_max.array() > 0).all()) {
      for (const auto& [parts, name] : {std::pair<double, const char*>{1000, "thousandths"}, {100, "hundredths"}}) {
        const Eigen::VectorXd unit = parts * arm_.tau_max.cwiseInverse();
        if (!all_near(unit, kUnit)) continue;
        offer(cost_of(unit, 1), Fault::TorqueUnit, say("the torque is in %s of the rated torque", name),
              advice_.gains(given_.gains.cwiseQuotient(unit)));
        return;
      }
    }
    std::vector<double> values;
    values.reserve(known.size());
    for (const Eigen::Index j : known) values.push_back(fits[static_cast<std::size_t>(j)].gain);
    std::sort(values.begin(), values.end());
    const double common = known.empty() ? 1 : values[values.size() / 2];
    if (all_near(common * ones, kCommon))
      offer(cost_of(common * ones, 1), Fault::TorqueUnit,
            say("all joints' torque is %.3g times what the arm needs", common), advice_.gains(given_.gains / common));
    Eigen::VectorXd k = ones;
    std::string sizes, what;
    for (const Eigen::Index j : off) {
      const GainFit& f = fits[static_cast<std::size_t>(j)];
      k[j] = f.gain;
      sizes += (sizes.empty() ? "" : ", ") + say("%.2f +- %.2f", f.gain, f.deviation);
    }
    if (!off.empty()) what = "the torque of joint " + list(off) + " is " + sizes + " times what the arm needs";
    for (const Eigen::Index j : turned) k[j] = -1;
    if (!turned.empty())
      what += (off.empty() ? "" : ", and ") + ("the torque of joint " + list(turned)) + " has the opposite sign";
    offer(cost_of(k, static_cast<int>(off.size() + turned.size())), Fault::Gain, what,
          advice_.gains(given_.gains.cwiseQuotient(k)));
  }

  void gravity() {
    constexpr double kTurned = 8 * kDegree, kSize = 0.2, kNone = 0.25;
    Explained data = explained(model_);
    data.base = model_.inertial;
    Eigen::VectorXd x, deviation;
    const double cost =
        fit_.fit_shared(data, {model_.per_gravity.begin(), model_.per_gravity.end()}, x, deviation).cost;
    const Eigen::Vector3d found = x, expected = arm_.gravity;
    const double size = found.norm() / expected.norm();
    const double angle = std::acos(std::clamp(found.dot(expected) / (found.norm() * expected.norm()), -1.0, 1.0));
    if (size < kNone) {
      offer(cost, Fault::LacksGravity, "tau is without gravity", "--tau-lacks-gravity");
      return;
    }
    if (deviation.maxCoeff() > 0.15 * expected.norm()) return;
    if (angle < kTurned && std::abs(size - 1) < kSize) return;
    // Its size is known: only a direction is left.
    Eigen::Vector3d direction = found.normalized();
    for (int i = 0; i < 3; ++i)
      if (std::abs(direction[i]) > std::cos(kTurned / 2))
        direction = std::copysign(1.0, direction[i]) * Eigen::Vector3d::Unit(i);
    Explained turned = explained(model_);
    turned.base = model_.inertial;
    for (std::size_t i = 0; i < 3; ++i)
      turned.base += kStandardGravity * direction[static_cast<Eigen::Index>(i)] * model_.per_gravity[i];
    const Eigen::Vector3d g = kStandardGravity * direction;
    const std::string option = say("--gravity %.2f,%.2f,%.2f", g[0] + 0.0, g[1] + 0.0, g[2] + 0.0);
    if (angle >= kTurned)
      offer(std::min(cost, fit_.fit(turned, 2).cost), Fault::Gravity,
            say("gravity is turned by %.0f degrees against the z axis of the base link", angle / kDegree), option);
    else if (!near(expected.norm(), kStandardGravity, kSize))
      offer(cost, Fault::Gravity, say("gravity is %.1f times the one given", size), option);
  }

  void contained_gravity() {
    constexpr double kContained = 0.3, kTurned = 8 * kDegree;
    const Explained data = explained(model_);
    Eigen::VectorXd x, deviation;
    const double cost = fit_.fit_shared(data, {model_.gravity}, x, deviation).cost;
    if (std::abs(x[0]) > kContained)
      offer(cost, Fault::ContainsGravity, say("tau_ext contains gravity, %.2f times the model's", x[0]),
            advice_.moved("tau_ext", "tau") +
                (x[0] < 0 ? std::string(" --torque-sign ") + (given_.external_sign ? "reaction" : "external") : ""));
    const double tilted =
        fit_.fit_shared(data, {model_.per_gravity.begin(), model_.per_gravity.end()}, x, deviation).cost;
    const Eigen::Vector3d truth = arm_.gravity - Eigen::Vector3d(x);
    const double angle =
        std::acos(std::clamp(truth.dot(arm_.gravity) / (truth.norm() * arm_.gravity.norm()), -1.0, 1.0));
    if (angle > kTurned && near(truth.norm(), arm_.gravity.norm(), 0.3))
      offer(tilted, Fault::Gravity,
            say("tau_ext was computed with gravity along -z of the base link, which is turned by %.0f degrees; record "
                "tau and dq, and use --gravity %.2f,%.2f,%.2f",
                angle / kDegree, truth[0], truth[1], truth[2]),
            say("--gravity %.2f,%.2f,%.2f", truth[0], truth[1], truth[2]));
  }

  void load() {
    // Lightest load, as a share of the rated payload, and what it grows by with friction, as a share of the model's
    // torque: links of arms whose torque is motor current are known less well.
    constexpr double kLight = 0.05, kLightByFriction = 0.2, kMostFriction = 0.5;
    constexpr double kSure = 4, kFar = 0.6;  // deviations; [m]
    const Explained data = explained(model_);
    std::vector<Eigen::MatrixXd> shared(model_.per_load.begin(), model_.per_load.end());
    if (!log_.measured)
      for (Eigen::MatrixXd& m : shared) m *= -1;  // external torque is what the load exerts on the arm
    Eigen::VectorXd x, deviation;
    const double cost = fit_.fit_shared(data, shared, x, deviation).cost;
    if (log_.may_hold) {
      right_ = std::min(right_, cost + kBeyond * beyond_limits(instants_.motion().q, arm_));
      return;
    }
    const double m = std::abs(x[0]);
    const double spread = (model_.gravity.rowwise() - model_.gravity.colwise().mean()).norm() /
                          std::sqrt(static_cast<double>(instants_.size()));
    const double friction = spread > 0 ? std::min(asis_.friction.norm() / spread, kMostFriction) : kMostFriction;
    if (m < (kLight + kLightByFriction * friction) * arm_.rated_payload || m < kSure * deviation[0]) return;
    if (x[0] < 0 && log_.measured) return;
    const Eigen::Vector3d centre = x.tail<3>() / x[0];
    if (centre.norm() > kFar) return;
    const std::string what = say("the hand holds %.2f +- %.2f kg at (%.0f, %.0f, %.0f) +- (%.0f, %.0f, %.0f) mm", m,
                                 deviation[0], 1e3 * centre[0], 1e3 * centre[1], 1e3 * centre[2],
                                 1e3 * deviation[1] / m, 1e3 * deviation[2] / m, 1e3 * deviation[3] / m);
    if (x[0] < 0)
      offer(cost, Fault::TorqueSign, what + " if tau_ext has the opposite sign",
            std::string("--torque-sign ") + (given_.external_sign ? "reaction" : "external"));
    else
      offer(cost, Fault::Load, what + ", or the model lacks a tool",
            say("--tool %.3f,%.3f,%.3f,%.3f", m, centre[0], centre[1], centre[2]));
  }

  void delay() {
    constexpr double kStep = 0.005, kMost = 0.1, kLate = 0.008;  // [s]
    // What is gained by it [nats]: in all, and of each independent sample. Errors of the model do not average out, and
    // filters of motor currents make the torque of good logs late by 20 ms.
    constexpr double kLikely = 8, kClear = 0.4;
    Explained data = explained(model_);
    data.friction_error = 0;  // the instants at which friction changes its sign tell
    const double as_it_is = fit_.fit(data).cost;
    double least = as_it_is, late = 0;
    for (double d = -kMost; d <= kMost + 1e-9; d += kStep) {
      data.tau = instants_.torque(d);
      const double cost = fit_.fit(data, 1).cost;
      if (cost < least) {
        least = cost;
        late = d;
      }
    }
    if (std::abs(late) < kLate || least > as_it_is - kLikely) return;
    const std::string what = say("%.0f ms %s than q", 1e3 * std::abs(late), late > 0 ? "later" : "earlier");
    const std::string option = say("--torque-delay %.3f", late);
    if (least > as_it_is - kClear * fit_.samples())
      remarks_.push_back("the torque may be " + what + ": " + option);
    else
      offer(right_ - kBeyond * beyond_limits(instants_.motion().q, arm_) + least - as_it_is, Fault::Delay,
            "the torque is " + what, option);
  }

  /// Orders, signs and zeros of the joints: from the log as it is, changes that help most are made one after another.
  void joint_maps() {
    constexpr int kChanges = 3;
    constexpr double kHelps = 15;  // [nats]: there are many candidates
    const Eigen::Index n = arm_.joints();
    JointMap best(n);
    double cost = right_;
    Motion motion = instants_.motion();
    ModelTorque model = model_;
    std::vector<JointMap> starts;
    JointMap turned_round(n), next(n), previous(n);
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto i = static_cast<std::size_t>(j);
      turned_round.position[i] = n - 1 - j;
      next.position[i] = (j + 1) % n;
      previous.position[i] = (j + n - 1) % n;
    }
    for (JointMap* map : {&turned_round, &next, &previous}) {
      JointMap own = *map;
      own.torque = own.position;
      starts.push_back(own);
      starts.push_back(*map);
    }
    for (int change = 0; change < kChanges; ++change) {
      std::vector<JointMap> candidates = change == 0 ? starts : std::vector<JointMap>();
      for (Eigen::Index a = 0; a < n; ++a) {
        const auto i = static_cast<std::size_t>(a);
        for (Eigen::Index b = a + 1; b < n; ++b) {
          const auto k = static_cast<std::size_t>(b);
          JointMap q = best, tau = best;
          std::swap(q.position[i], q.position[k]);
          std::swap(tau.torque[i], tau.torque[k]);
          JointMap both = q;
          std::swap(both.torque[i], both.torque[k]);
          candidates.insert(candidates.end(), {both, q, tau});
        }
        JointMap sign = best;
        sign.sign[a] *= -1;
        JointMap both = sign;
        both.torque_sign[a] *= -1;
        candidates.insert(candidates.end(), {sign, both});
        for (int turn = -3; turn <= 4 && change == 0; ++turn) {
          JointMap zero = best;
          zero.offset[a] = turn * kPi / 4;
          if (turn != 0) candidates.push_back(zero);
        }
      }
      JointMap chosen = best;
      double least = cost;
      for (std::size_t c = 0; c < candidates.size(); ++c) {
        const JointMap& map = candidates[c];
        if (c == 0 || !map.moves_as(candidates[c - 1])) {
          motion = map.apply(instants_.motion());
          model = arm_.torque(motion, false);
        }
        const double found = fit_.fit(explained(model, motion, map.apply(tau_)), change + 1).cost +
                             kBeyond * beyond_limits(motion.q, arm_);
        if (found < least) {
          least = found;
          chosen = map;
        }
      }
      if (!(least < cost - kHelps)) break;
      cost = least;
      best = chosen;
      refine(best, cost, change + 1);
    }
    if (cost < right_) report(best, cost);
  }

  /// Improves the offset that is not zero.
  void refine(JointMap& map, double& cost, int parameters) {
    for (Eigen::Index j = 0; j < arm_.joints(); ++j) {
      if (map.offset[j] == 0) continue;
      for (double step = kPi / 8; step > 0.01; step *= 0.5) {
        for (const double sign : {-1.0, 1.0}) {
          JointMap moved = map;
          moved.offset[j] += sign * step;
          const Motion motion = moved.apply(instants_.motion());
          const double found =
              fit_.fit(explained(arm_.torque(motion, false), motion, moved.apply(tau_)), parameters).cost +
              kBeyond * beyond_limits(motion.q, arm_);
          if (found < cost) {
            cost = found;
            map = moved;
          }
        }
      }
    }
  }

  void report(const JointMap& map, double cost) {
    constexpr double kZero = 0.15;  // least offset [rad]
    const JointMap none(arm_.joints());
    if (map.position != none.position && map.torque == map.position && map.sign == none.sign) {
      offer(cost, Fault::JointOrder, "the joints are in another order than in the model",
            advice_.reordered({"q", "dq", "tau"}, map.position));
    } else if (map.position != none.position && map.torque == none.torque && map.sign == none.sign) {
      offer(cost, Fault::JointOrder, "q has its joints in another order than the model and the torque",
            advice_.reordered({"q", "dq"}, map.position));
    } else if (map.torque != none.torque && map.position == none.position && map.sign == none.sign) {
      offer(cost, Fault::TorqueOrder, "the torque has its joints in another order than q",
            advice_.reordered({"tau"}, map.torque));
    } else if (map.offset != none.offset && map.position == none.position && map.torque == none.torque &&
               map.sign == none.sign) {
      Eigen::Index j = 0;
      const double most = map.offset.cwiseAbs().maxCoeff(&j);
      if (most > kZero)
        offer(cost, Fault::PositionOffset,
              say("joint %d of q has its zero %.2f rad away from the model's", static_cast<int>(j + 1), map.offset[j]),
              advice_.shifted(j, map.offset[j]));
    } else if (map.position == none.position && map.torque == none.torque) {
      std::vector<Eigen::Index> q, tau;
      Eigen::VectorXd gains = given_.gains;
      for (Eigen::Index j = 0; j < arm_.joints(); ++j) {
        if (map.sign[j] < 0) q.push_back(j);
        if (map.torque_sign[j] > 0) continue;
        tau.push_back(j);
        gains[j] *= -1;
      }
      if (q.empty()) return;
      offer(cost, Fault::PositionSign,
            "joint " + list(q) + " turns the other way than in the model" + (tau.empty() ? "" : ", as does its torque"),
            advice_.turned_joints(q) + (tau.empty() ? "" : " " + advice_.gains(gains)));
    } else {
      offer(cost, Fault::JointOrder, "joints are in another order than in the model, some with another sign",
            advice_.reordered({"q", "dq", "tau"}, map.position));
    }
  }

  const DiagnosedLog& log_;
  const DiagnosedArm& arm_;
  const GivenOptions& given_;
  const Advice& advice_;
  Instants instants_;
  TorqueFit fit_;
  Eigen::MatrixXd tau_;
  ModelTorque model_;
  FitQuality asis_;
  double right_ = 0;  // cost of nothing being wrong
  std::optional<Explanation> best_;
  std::vector<std::string> remarks_;
};

/// Joints beyond the URDF's limits.
void judge_limits(const DiagnosedLog& log, const DiagnosedArm& arm, std::vector<Finding>& findings) {
  constexpr double kTolerance = 0.2, kTorque = 1.1, kShare = 0.005;  // [rad]; of the limit; of the rows
  const auto many = [&](Eigen::Index count) {
    return static_cast<double>(count) > kShare * static_cast<double>(log.t.size());
  };
  for (Eigen::Index j = 0; j < arm.joints(); ++j) {
    const auto q = log.q.col(j).array();
    if (!many((q > arm.q_max[j] + kTolerance || q < arm.q_min[j] - kTolerance).count())) continue;
    findings.push_back({Fault::PositionLimits,
                        say("joint %d of q goes from %.2f to %.2f rad, the URDF allows %.2f to %.2f: another zero, "
                            "another order of joints, or another arm's --urdf",
                            static_cast<int>(j + 1), q.minCoeff(), q.maxCoeff(), arm.q_min[j], arm.q_max[j]),
                        ""});
    break;
  }
  for (Eigen::Index j = 0; j < arm.joints(); ++j) {
    const auto tau = log.tau.col(j).array().abs();
    if (!(arm.tau_max[j] > 0) || !many((tau > kTorque * arm.tau_max[j]).count())) continue;
    findings.push_back({Fault::TorqueLimits,
                        say("the torque of joint %d reaches %.3g N m, the URDF allows %.3g: another unit (--gains), or "
                            "another arm's --urdf",
                            static_cast<int>(j + 1), tau.maxCoeff(), arm.tau_max[j]),
                        ""});
    break;
  }
}

}  // namespace

std::string Diagnosis::sentence() const {
  if (usable()) return "nothing is wrong with units, signs, order, gravity and time of this log";
  std::string out;
  for (const Finding& finding : findings)
    out += (out.empty() ? "" : "; ") + finding.sentence + (finding.option.empty() ? "" : ": " + finding.option);
  return out;
}

std::string Diagnosis::options() const {
  const std::string columns = "--columns '";
  std::string out, items;
  for (const Finding& finding : findings) {
    if (finding.option.empty()) return {};
    if (finding.option.compare(0, columns.size(), columns) != 0) {
      out += (out.empty() ? "" : " ") + finding.option;
      continue;
    }
    // One option has the items of all, those that were given already once.
    const std::size_t quote = finding.option.find('\'', columns.size());
    const std::string more = finding.option.substr(columns.size(), quote - columns.size());
    std::size_t same = 0;
    for (std::size_t i = 0; i < more.size() && i < items.size() && more[i] == items[i]; ++i)
      if (more[i] == ',') same = i + 1;
    items += (items.empty() ? "" : ",") + more.substr(same);
    out += finding.option.substr(quote + 1);
  }
  return items.empty() ? out : columns + items + "'" + (out.empty() || out[0] == ' ' ? "" : " ") + out;
}

Diagnosis diagnose(const DiagnosedLog& given_log, const DiagnosedArm& arm, const GivenOptions& given) {
  if (given_log.t.size() < 10)
    throw LogError(given_log.name + ": has " + std::to_string(given_log.t.size()) + " rows; at least 10 are needed");
  Diagnosis out;
  DiagnosedLog log = given_log;
  const Advice advice(given);
  judge_velocity(log, advice, out.findings);
  if (log.t.back() - log.t.front() < 1)
    throw LogError(log.name + ": lasts " + std::to_string(log.t.back() - log.t.front()) + " s; at least 1 is needed");
  TorqueJudge judge(log, arm, given, advice);
  if (const auto found = judge.find()) out.findings.push_back(*found);
  const bool explained = std::any_of(out.findings.begin(), out.findings.end(), [](const Finding& f) {
    return f.fault != Fault::Load && f.fault != Fault::Delay && f.fault != Fault::Gravity;
  });
  if (!explained) judge_limits(log, arm, out.findings);
  if (out.usable()) out.remarks = judge.remarks();
  return out;
}

}  // namespace rme::examples
