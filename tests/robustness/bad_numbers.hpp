#pragma once
/// What sensors, drivers and bugs hand in, and the properties that every call of a loop keeps then.
#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <rme/core/status.hpp>
#include <vector>

#include "support/catch.hpp"

namespace rme::testing {

using Random = std::mt19937_64;

inline std::size_t below(Random& random, std::size_t end) {
  return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
}

/// The numbers that an input consists of.
using Entries = std::vector<double*>;

template <typename Matrix>
void append(Entries& entries, Matrix& matrix) {
  for (Eigen::Index i = 0; i < matrix.size(); ++i) entries.push_back(matrix.data() + i);
}
inline void append(Entries& entries, double& number) {
  entries.push_back(&number);
}
/// Of all members of an input, which may be vectors, matrices and numbers.
template <typename... Members>
Entries entries_of(Members&... members) {
  Entries entries;
  (append(entries, members), ...);
  return entries;
}

/// Puts one number, or all of them, out of order. Half of the time what comes out is not finite.
inline void spoil(const Entries& entries, Random& random) {
  using Limits = std::numeric_limits<double>;
  static const std::vector<double> bad = {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()};
  static const std::vector<double> strange = {
      0.0,  -0.0, Limits::denorm_min(), Limits::min(), Limits::max(), -Limits::max(), 1e160, -1e160, 1e-160, 2e6,
      -1e4, 1.0};
  if (below(random, 2) == 0) {
    *entries[below(random, entries.size())] = bad[below(random, bad.size())];
  } else if (below(random, 4) != 0) {
    *entries[below(random, entries.size())] = strange[below(random, strange.size())];
  } else {
    const double factor = strange[below(random, strange.size())];
    for (double* entry : entries) *entry *= factor;
  }
}

/// A call of a loop under test.
/// @tparam Object  copyable, with the state that the call changes
/// @tparam Input   copyable
template <typename Object, typename Input>
struct LoopCall {
  virtual ~LoopCall() = default;
  virtual Object make() const = 0;
  virtual Input good(Random& random) const = 0;
  virtual Entries entries(Input& input) const = 0;
  virtual Status call(Object& object, const Input& input) const = 0;
  /// Whether the status says that nothing was done.
  virtual bool refused(Status status) const { return status != Status::Ok; }
  /// All that the object says.
  virtual Eigen::VectorXd answers(const Object& object) const = 0;
  /// Whether the answers keep what the object promises beside being finite.
  virtual bool within_bounds(const Object& /*before*/, const Object& /*after*/) const { return true; }
};

/// Runs a loop in which one input in three is spoilt. Whatever comes in, the answers are finite and keep their bounds.
/// After a failure the object is the same as a twin that has never seen the input: at once and, for the inputs that
/// follow, bit for bit.
template <typename Object, typename Input>
void check_loop_call(const LoopCall<Object, Input>& subject, unsigned seed, int ticks) {
  CAPTURE(seed);
  Random random(seed);
  Object object = subject.make(), twin = object;
  int refused = 0, accepted = 0;
  for (int tick = 0; tick < ticks; ++tick) {
    CAPTURE(tick);
    Input input = subject.good(random);
    if (below(random, 3) == 0) {
      Input bad = input;
      spoil(subject.entries(bad), random);
      const Object before = object;
      const Status status = subject.call(object, bad);
      CAPTURE(to_string(status));
      REQUIRE(subject.answers(object).allFinite());
      REQUIRE(subject.within_bounds(before, object));
      if (subject.refused(status)) {
        ++refused;
      } else {  // strange, but taken: the twin has to see it as well
        ++accepted;
        REQUIRE(subject.call(twin, bad) == status);
      }
      REQUIRE(subject.answers(object) == subject.answers(twin));
    }
    const Object before = object;
    const Status status = subject.call(object, input);
    REQUIRE(subject.call(twin, input) == status);
    REQUIRE(subject.answers(object) == subject.answers(twin));
    REQUIRE(subject.answers(object).allFinite());
    REQUIRE(subject.within_bounds(before, object));
  }
  CHECK(refused > ticks / 20);
  CHECK(accepted > ticks / 100);
}

}  // namespace rme::testing
