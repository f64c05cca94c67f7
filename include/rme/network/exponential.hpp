#pragma once
/// The exponential of a softmax.
#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace rme {

namespace detail {

/// sum_k r^k / k! up to r^Degree, unrolled.
template <typename Scalar, std::size_t... K>
Scalar exp_series(Scalar r, std::index_sequence<K...>) noexcept {
  constexpr std::size_t degree = sizeof...(K);
  constexpr auto coefficients = [] {
    std::array<double, degree + 1> c{};
    c[0] = 1;
    for (std::size_t k = 1; k <= degree; ++k) c[k] = c[k - 1] / static_cast<double>(k);
    return c;
  }();
  Scalar sum = Scalar(coefficients[degree]);
  ((sum = Scalar(coefficients[degree - 1 - K]) + sum * r), ...);
  return sum;
}

}  // namespace detail

/// exp(x) for -80 <= x <= 0, to within a few units in the last place: x = n ln 2 + r with |r| <= ln 2 / 2, and exp(r)
/// by its Taylor series. It has no branches, so that compilers vectorise its loops and it always takes the same time.
template <typename Scalar>
Scalar softmax_exp(Scalar x) noexcept {
  static_assert(std::is_same_v<Scalar, float> || std::is_same_v<Scalar, double>);
  if constexpr (FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 2) {
    return std::exp(x);  // here, sums are not rounded to Scalar, which the code below needs
  } else {
    constexpr bool is_float = std::is_same_v<Scalar, float>;
    using Bits = std::conditional_t<is_float, std::uint32_t, std::uint64_t>;
    constexpr int mantissa = is_float ? 23 : 52;
    constexpr Bits exponent_of_one = is_float ? 127 : 1023;
    // In a number this large, the last bit is worth 1. So adding it rounds to an integer n, which is in the low bits.
    constexpr Scalar shift = Scalar(1.5) * Scalar(Bits(1) << mantissa);
    // ln 2 in two parts. The first has so few bits that its product with n is exact.
    constexpr Scalar ln2_high = Scalar(is_float ? 0.693359375 : 0x1.62e42feep-1);
    constexpr Scalar ln2_low = Scalar(is_float ? -2.1219444005469057e-4 : 0x1.a39ef35793c76p-33);
    const Scalar shifted = x * Scalar(1.4426950408889634) + shift;
    const Scalar n = shifted - shift;
    const Scalar r = (x - n * ln2_high) - n * ln2_low;
    Bits bits;
    std::memcpy(&bits, &shifted, sizeof bits);
    bits = (bits + exponent_of_one) << mantissa;  // 2^n
    Scalar power;
    std::memcpy(&power, &bits, sizeof power);
    constexpr std::size_t degree = is_float ? 7 : 12;
    return power * detail::exp_series(r, std::make_index_sequence<degree>());
  }
}

}  // namespace rme
