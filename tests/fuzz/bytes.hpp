#pragma once
/// The input of a fuzzer, as numbers.
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace fuzzing {

/// Bytes, one after the other; zero when there are no more.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
  bool empty() const { return left_ == 0; }
  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }
  double in(double low, double high) { return low + (high - low) * byte() / 255.0; }
  /// Any of the numbers that there are.
  template <typename Scalar>
  Scalar number() {
    std::uint8_t raw[sizeof(Scalar)];
    for (std::uint8_t& b : raw) b = byte();
    Scalar x;
    std::memcpy(&x, raw, sizeof x);
    return x;
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

}  // namespace fuzzing
