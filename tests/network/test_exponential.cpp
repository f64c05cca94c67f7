#include <cmath>
#include <limits>
#include <random>
#include <rme/network/exponential.hpp>

#include "support/catch.hpp"

namespace {

TEMPLATE_TEST_CASE("softmax_exp: is the exponential to a few units in the last place", "[exponential]", float, double) {
  const unsigned seed = 501;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<TestType> uniform(-80, 0);
  long double largest = 0;
  for (int k = 0; k < 200000; ++k) {
    // Half of them close to zero, where a softmax has its large terms.
    const TestType x = k % 2 == 0 ? uniform(random) : uniform(random) / 40;
    const long double exact = std::exp(static_cast<long double>(x));
    const TestType value = rme::softmax_exp(x);
    if (!std::isfinite(value)) FAIL(value);  // of a NaN, max() would take no notice
    largest = std::max(largest, std::abs(static_cast<long double>(value) - exact) / exact);
  }
  CHECK(largest < 2 * std::numeric_limits<TestType>::epsilon());
}

TEMPLATE_TEST_CASE("softmax_exp: is exact at zero, and finite and normal at the far end", "[exponential]", float,
                   double) {
  CHECK(rme::softmax_exp(TestType(0)) == TestType(1));
  CHECK(std::isnormal(rme::softmax_exp(TestType(-80))));
}

static_assert(noexcept(rme::softmax_exp(0.0f)) && noexcept(rme::softmax_exp(0.0)));

}  // namespace
