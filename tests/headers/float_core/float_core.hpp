#pragma once
/// The core in float, as a microcontroller has it: without exceptions and run-time types, each part against a closed
/// form or against itself in double. One unit for each part of the core, as a compiler of another machine may have
/// little memory; main.cpp runs the cases of all.
#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <random>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <type_traits>
#include <vector>

namespace float_core {

struct Case {
  const char* name;
  bool (*passes)();
};

extern const std::vector<Case> kSensing, kInference, kMeanField, kEnclosure, kControl, kNetwork, kTracker;

using rme::Status;
using Random = std::mt19937_64;
using Vector3 = rme::Vector3<float>;
using Vector6 = rme::Vector6<float>;
using Vector7 = rme::JointVector<float, 7>;
using Jacobian7 = rme::Jacobian<float, 7>;

constexpr float kPeriod = 1e-3F;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

template <typename Matrix>
Matrix gaussian(Random& random, float deviation = 1) {
  std::normal_distribution<float> normal(0, deviation);
  Matrix m;
  for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = normal(random);
  return m;
}

/// The distance of two matrices, whose sums are of doubles, is no more than the tolerance.
template <typename A, typename B>
bool near(const A& a, const B& b, double tolerance) {
  if constexpr (std::is_arithmetic_v<A>) {
    return std::abs(double(a) - double(b)) <= tolerance;
  } else {
    const typename A::PlainObject x = a;
    const typename B::PlainObject y = b;
    static_assert(int(A::RowsAtCompileTime) == int(B::RowsAtCompileTime) &&
                  int(A::ColsAtCompileTime) == int(B::ColsAtCompileTime));
    double squares = 0;
    for (Eigen::Index j = 0; j < x.cols(); ++j)
      for (Eigen::Index i = 0; i < x.rows(); ++i) {
        const double difference = double(x(i, j)) - double(y(i, j));
        squares += difference * difference;
      }
    return squares <= tolerance * tolerance;
  }
}

}  // namespace float_core
