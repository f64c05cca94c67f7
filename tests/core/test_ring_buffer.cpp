#include <deque>
#include <random>
#include <rme/core/ring_buffer.hpp>
#include <stdexcept>

#include "support/catch.hpp"

namespace {

TEST_CASE("RingBuffer: holds what a deque cut to its capacity holds, at every push", "[ring_buffer]") {
  const unsigned seed = 1;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (const std::size_t capacity : {1u, 2u, 7u}) {
    CAPTURE(capacity);
    rme::RingBuffer<unsigned> ring(capacity);
    std::deque<unsigned> oracle;
    for (int k = 0; k < 50; ++k) {
      const auto value = static_cast<unsigned>(random());
      ring.push(value);
      oracle.push_back(value);
      if (oracle.size() > capacity) oracle.pop_front();
      REQUIRE(ring.size() == oracle.size());
      REQUIRE(ring.full() == (oracle.size() == capacity));
      for (std::size_t i = 0; i < oracle.size(); ++i) {
        REQUIRE(ring[i] == oracle[i]);
        REQUIRE(ring.newest(i) == oracle[oracle.size() - 1 - i]);
      }
      if (k == 30) {
        ring.clear();
        oracle.clear();
        REQUIRE(ring.empty());
      }
    }
  }
}

TEST_CASE("RingBuffer: a capacity of zero is refused by name", "[ring_buffer]") {
  CHECK_THROWS_WITH(rme::RingBuffer<double>(0), contains("RingBuffer::capacity"));
}

}  // namespace
