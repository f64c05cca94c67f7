#pragma once
/// A sum of logarithms that calls log once for three numbers: a call costs as much as some thirty multiplications.
#include <Eigen/Core>
#include <cmath>
#include <rme/core/unroll.hpp>

namespace rme {

/// sum_i log x_i. Numbers are multiplied three at a time. For numbers from 1e-12 to 1e12 in float, and from 1e-100 to
/// 1e100 in double, the product neither overflows nor underflows.
/// @param x  a vector of fixed size, of numbers > 0
template <typename Vector>
typename Vector::Scalar sum_of_logs(const Eigen::DenseBase<Vector>& x) noexcept {
  using std::log;
  using Scalar = typename Vector::Scalar;
  constexpr int size = Vector::SizeAtCompileTime;
  Scalar sum = Scalar(0);
  RME_UNROLL
  for (int i = 0; i < size; i += 3) {
    Scalar product = x.coeff(i);
    if (i + 1 < size) product *= x.coeff(i + 1);
    if (i + 2 < size) product *= x.coeff(i + 2);
    sum += log(product);
  }
  return sum;
}

}  // namespace rme
