#include <cmath>
#include <limits>
#include <random>
#include <rme/inference/linear_program.hpp>
#include <rme/inference/payload_enclosure.hpp>

#include "inference/enclosure_trial.hpp"
#include "inference/glpk_program.hpp"
#include "support/catch.hpp"

namespace {

using rme::PayloadBox;
using rme::PayloadEnclosure;
using rme::PayloadEnclosureConfig;
using rme::Status;
using rme::testing::Errors;
using rme::testing::GlpkAnswer;
using rme::testing::GlpkProgram;
using rme::testing::panda_bounds;
using rme::testing::random_trial;
using rme::testing::Trial;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Config = PayloadEnclosureConfig<double, 7>;

/// The ends of the box by GLPK: mass, first moment, centre of mass.
struct Ends {
  bool empty = false;
  Eigen::Matrix<double, 7, 1> lower, upper;

  void note(int k, double side, GlpkAnswer answer, double value) {
    if (answer == GlpkAnswer::Unbounded) value = kInfinity;
    empty = empty || answer == GlpkAnswer::Infeasible;
    (side > 0 ? upper : lower)[k] = side * value;
  }
};

Ends ends_of(const PayloadBox<double>& box) {
  Ends ends;
  ends.lower << box.mass_lower, box.moment_lower, box.com_lower;
  ends.upper << box.mass_upper, box.moment_upper, box.com_upper;
  return ends;
}

/// The largest difference of two lists of ends; equal infinities agree.
double apart(const Ends& a, const Ends& b, int count) {
  double largest = 0;
  for (int k = 0; k < count; ++k) {
    if (a.lower[k] != b.lower[k]) largest = std::max(largest, std::abs(a.lower[k] - b.lower[k]));
    if (a.upper[k] != b.upper[k]) largest = std::max(largest, std::abs(a.upper[k] - b.upper[k]));
  }
  return largest;
}

/// One change in one pose: |after - before - A phi| <= drift + 2 friction, and the limits of the payload.
GlpkProgram program_of_change(const Trial& trial, const Config& config) {
  GlpkProgram program(4);
  const auto& pose = trial.poses[0];
  Eigen::VectorXd row(4);
  for (int j = 0; j < 7; ++j) {
    row << pose.regressor.a[j], pose.regressor.B.row(j).transpose();
    const double change = pose.after[j] - pose.before[j], error = config.drift[j] + 2 * config.friction[j];
    program.add_row(row, change - error, change + error);
  }
  program.bound(0, 0, config.mass_limit);
  for (int i = 0; i < 3; ++i) {
    row.setZero();
    row[1 + i] = 1;
    row[0] = -config.com_upper[i];
    program.add_row(row, -kInfinity, 0);
    row[0] = -config.com_lower[i];
    program.add_row(row, 0, kInfinity);
  }
  return program;
}

/// Every reading with all its errors as unknowns of their own, as (T46) has them and nothing eliminated:
///
///     A phi + offset_kj + friction_kj + link_pj = tau_kj t,   |offset_kj - offset_lj| <= drift_j t, ...
///
/// With t = 1 it is the model itself; with m = 1 and t free, phi holds the centre of mass, and t is 1 / m (Charnes and
/// Cooper).
class LiteralProgram {
 public:
  LiteralProgram(const Trial& trial, const Config& config)
      : poses_(static_cast<int>(trial.poses.size())), program_(5 + 7 * 5 * poses_) {
    for (int j = 0; j < 7; ++j) {
      for (int k = 0; k < 2 * poses_; ++k) {
        const auto& pose = trial.poses[static_cast<std::size_t>(k / 2)];
        const bool loaded = k % 2 == 1;
        auto row = zero();
        if (loaded) row.head(4) << pose.regressor.a[j], pose.regressor.B.row(j).transpose();
        row[offset(j, k)] = row[friction(j, k)] = row[link(j, k / 2)] = 1;
        row[4] = -(loaded ? pose.after : pose.before)[j];
        program_.add_row(row, 0, 0);
        within(friction(j, k), config.friction[j]);
        within(offset(j, k), config.offset[j]);
        for (int l = 0; l < k; ++l) within(offset(j, k), config.drift[j], offset(j, l));
      }
      for (int p = 0; p < poses_; ++p) within(link(j, p), config.link[j]);
    }
    for (int i = 0; i < 3; ++i) {
      auto row = zero();
      row[1 + i] = 1;
      row[0] = -config.com_upper[i];
      if (std::isfinite(config.com_upper[i])) program_.add_row(row, -kInfinity, 0);
      row[0] = -config.com_lower[i];
      if (std::isfinite(config.com_lower[i])) program_.add_row(row, 0, kInfinity);
    }
    auto row = zero();
    row[0] = 1;
    row[4] = -config.mass_limit;
    if (std::isfinite(config.mass_limit)) program_.add_row(row, -kInfinity, 0);
  }

  Ends ends() {
    Ends ends;
    program_.bound(0, 0, kInfinity);
    program_.bound(4, 1, 1);
    for (int k = 0; k < 4 && !ends.empty; ++k) both(k, k, ends);
    if (ends.empty) return ends;
    program_.bound(0, 1, 1);
    program_.bound(4, 0, kInfinity);
    for (int i = 0; i < 3; ++i) both(4 + i, 1 + i, ends);
    return ends;
  }
  /// max c.phi.
  double largest(const Eigen::Vector4d& c) {
    program_.bound(0, 0, kInfinity);
    program_.bound(4, 1, 1);
    auto objective = zero();
    objective.head(4) = c;
    double value = 0;
    const GlpkAnswer answer = program_.maximise(objective, value);
    return answer == GlpkAnswer::Optimal ? value : kInfinity;
  }

 private:
  int offset(int j, int k) const { return 5 + j * 5 * poses_ + k; }
  int friction(int j, int k) const { return offset(j, 2 * poses_ + k); }
  int link(int j, int p) const { return offset(j, 4 * poses_ + p); }
  Eigen::VectorXd zero() const { return Eigen::VectorXd::Zero(5 + 7 * 5 * poses_); }
  /// |x_a - x_b| <= bound t, or |x_a| <= bound t.
  void within(int a, double bound, int b = -1) {
    if (!std::isfinite(bound)) return;
    for (const double side : {-1.0, 1.0}) {
      auto row = zero();
      row[a] = side;
      if (b >= 0) row[b] = -side;
      row[4] = -bound;
      program_.add_row(row, -kInfinity, 0);
    }
  }
  void both(int end, int unknown, Ends& ends) {
    for (const double side : {-1.0, 1.0}) {
      auto c = zero();
      c[unknown] = side;
      double value = 0;
      const GlpkAnswer answer = program_.maximise(c, value);
      ends.note(end, side, answer, value);
    }
  }

  int poses_;
  GlpkProgram program_;
};

TEST_CASE("PayloadEnclosure: bounds violated by 20 % in 100,000 trials: empty where GLPK says so, and only there",
          "[enclosure]") {
  const unsigned seed = 51;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const Config config = panda_bounds();
  PayloadEnclosure<double, 7> enclosure(config);
  int contradictions = 0, empty = 0, other = 0;
  double worst = 0;
  for (int k = 0; k < 100000; ++k) {  // all errors 20 % beyond their bounds, or evenly up to 100 % beyond
    const Trial trial =
        random_trial(random, config, 1, k % 2 == 0 ? Errors::AtBounds : Errors::WithinBounds, k % 2 == 0 ? 1.2 : 2);
    const auto& pose = trial.poses[0];
    enclosure.clear();
    (void)enclosure.add_change(pose.before, pose.after, pose.regressor);
    PayloadBox<double> box;
    const Status status = enclosure.solve(box);
    other += status != Status::Ok && status != Status::Infeasible;
    empty += status == Status::Infeasible;
    GlpkProgram program = program_of_change(trial, config);
    Ends glpk;
    const int count = k % 10 == 0 ? 4 : 1;
    for (int i = 0; i < count && !glpk.empty; ++i) {
      for (const double side : {-1.0, 1.0}) {
        double value = 0;
        const GlpkAnswer answer = program.maximise(side * Eigen::VectorXd::Unit(4, i), value);
        glpk.note(i, side, answer, value);
      }
    }
    contradictions += glpk.empty != (status == Status::Infeasible);
    if (!glpk.empty && status == Status::Ok) worst = std::max(worst, apart(ends_of(box), glpk, count));
  }
  CHECK(other == 0);
  CHECK(contradictions == 0);
  CHECK(empty > 30000);
  CHECK(empty < 70000);
  CHECK(worst < 1e-9);
}

TEST_CASE("PayloadEnclosure: all errors at their bounds: the ends are GLPK's", "[enclosure]") {
  const unsigned seed = 52;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const Config config = panda_bounds();
  PayloadEnclosure<double, 7> enclosure(config);
  double worst = 0;
  int empty = 0;
  for (int k = 0; k < 10000; ++k) {
    const Trial trial = random_trial(random, config, 1, Errors::AtBounds);
    const auto& pose = trial.poses[0];
    enclosure.clear();
    (void)enclosure.add_change(pose.before, pose.after, pose.regressor);
    PayloadBox<double> box;
    REQUIRE(enclosure.solve(box) == Status::Ok);
    GlpkProgram program = program_of_change(trial, config);
    Ends glpk;
    for (int i = 0; i < 4; ++i) {
      for (const double side : {-1.0, 1.0}) {
        double value = 0;
        const GlpkAnswer answer = program.maximise(side * Eigen::VectorXd::Unit(4, i), value);
        glpk.note(i, side, answer, value);
      }
    }
    empty += glpk.empty;
    worst = std::max(worst, apart(ends_of(box), glpk, 4));
  }
  CHECK(empty == 0);
  CHECK(worst < 1e-9);
}

TEST_CASE(
    "PayloadEnclosure: with offset, drift, friction and link errors of several poses eliminated, the set is that "
    "of all of them as unknowns",
    "[enclosure]") {
  const unsigned seed = 53;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  int empty = 0, unbounded = 0;
  double worst = 0, worst_torque = 0;
  for (int k = 0; k < 600; ++k) {
    CAPTURE(k);
    Config config = panda_bounds();
    if (k % 2 == 0) config.friction = config.drift;
    if (k % 3 != 0) config.link.setConstant(0.1 * (k % 3));
    if (k % 5 < 2) config.offset.setConstant(k % 5 == 0 ? 0.03 : 0.5);
    if (k % 7 == 0) {
      config.mass_limit = kInfinity;
      config.com_lower.setConstant(-kInfinity);
      config.com_upper.setConstant(kInfinity);
    }
    const Trial trial = random_trial(random, config, 1 + k % 3, k % 4 == 0 ? Errors::AtBounds : Errors::WithinBounds,
                                     k % 4 == 1 ? 1.5 : 1);
    PayloadEnclosure<double, 7, 3> enclosure(config);
    for (const auto& pose : trial.poses)
      REQUIRE(enclosure.add_change(pose.before, pose.after, pose.regressor) == Status::Ok);
    PayloadBox<double> box;
    const Status status = enclosure.solve(box);
    LiteralProgram literal(trial, config);
    const Ends glpk = literal.ends();
    CHECK(glpk.empty == (status == Status::Infeasible));
    empty += glpk.empty;
    if (glpk.empty || status == Status::Infeasible) continue;
    const bool infinite = !glpk.lower.allFinite() || !glpk.upper.allFinite();
    unbounded += infinite;
    CHECK(status == (infinite ? Status::Unbounded : Status::Ok));
    // The centre of mass is the quotient of two numbers, of which the lower is as small as the lightest payload.
    worst = std::max(worst, apart(ends_of(box), glpk, 7) * std::min(1.0, box.mass_lower));
    if (infinite) continue;
    const auto elsewhere = rme::testing::panda_regressor(rme::testing::random_pose_near_ready(random));
    rme::testing::Torque7 lower, upper;
    REQUIRE(enclosure.range(elsewhere, lower, upper) == Status::Ok);
    for (int j = 0; j < 7; j += 3) {
      Eigen::Vector4d c;
      c << elsewhere.a[j], elsewhere.B.row(j).transpose();
      worst_torque =
          std::max({worst_torque, std::abs(literal.largest(c) - upper[j]), std::abs(literal.largest(-c) + lower[j])});
    }
  }
  CHECK(empty > 30);
  CHECK(unbounded > 10);
  CHECK(worst < 1e-9);
  CHECK(worst_torque < 1e-9);
}

TEST_CASE("LinearProgram: agrees with GLPK on 3000 random programs, bounded or not, degenerate or not",
          "[linear_program]") {
  const unsigned seed = 54;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  int unbounded = 0, contradictions = 0;
  double worst = 0;
  for (int k = 0; k < 3000; ++k) {
    rme::LinearProgram<double, 5, 60> program;
    GlpkProgram glpk(5);
    const int rows = 3 + k % 57;
    const bool whole = k % 3 == 0;  // whole numbers: parallel rows, and rows that meet in a vertex
    const auto draw = [&] {
      Eigen::Matrix<double, 5, 1> v;
      for (int i = 0; i < 5; ++i) {
        v[i] = u(random);
        if (whole) v[i] = std::round(1.5 * v[i]);
      }
      return v;
    };
    const auto inside = draw();
    for (int i = 0; i < rows; ++i) {
      const auto a = draw();
      const double room = k % 2 == 0 && i % 2 == 0 ? 0 : whole ? 1 : 1 + u(random), b = a.dot(inside) + room;
      REQUIRE(program.add(a, b) == Status::Ok);
      glpk.add_row(a, -kInfinity, b);
    }
    REQUIRE(program.start(inside) == Status::Ok);
    for (int i = 0; i < 5; ++i) {
      const auto c = draw();
      rme::LinearProgramResult<double, 5> result;
      const Status status = program.maximise(c, result);
      double value = 0;
      const GlpkAnswer answer = glpk.maximise(c, value);
      contradictions += status != (answer == GlpkAnswer::Unbounded ? Status::Unbounded : Status::Ok);
      unbounded += status == Status::Unbounded;
      if (status == Status::Ok) worst = std::max(worst, std::abs(result.value - value) / (1 + std::abs(value)));
      if (status == Status::Ok) CHECK(result.upper >= value - 1e-12 * (1 + std::abs(value)));
    }
  }
  CHECK(contradictions == 0);
  CHECK(unbounded > 1000);
  CHECK(worst < 1e-9);
}

}  // namespace
