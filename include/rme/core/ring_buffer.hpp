#pragma once
/// The last N values of a signal, in memory that is allocated once.
#include <cstddef>
#include <rme/core/require.hpp>
#include <vector>

namespace rme {

/// Keeps the newest `capacity` values. The constructor allocates all memory; push() never allocates.
template <typename Value>
class RingBuffer {
 public:
  /// @param capacity  how many values are kept, >= 1
  /// @throws std::invalid_argument if capacity is 0
  explicit RingBuffer(std::size_t capacity) : values_(checked(capacity)) {}

  /// Appends the newest value; when full, the oldest is forgotten.
  void push(const Value& value) noexcept {
    values_[next_] = value;
    next_ = next_ + 1 == values_.size() ? 0 : next_ + 1;
    if (size_ < values_.size()) ++size_;
  }

  /// The value pushed `age` pushes ago: 0 is the newest. Requires age < size().
  const Value& newest(std::size_t age = 0) const noexcept {
    const std::size_t back = age + 1;
    return values_[next_ >= back ? next_ - back : next_ + values_.size() - back];
  }
  /// The i-th value from the oldest kept: 0 is the oldest. Requires i < size().
  const Value& operator[](std::size_t i) const noexcept { return newest(size_ - 1 - i); }

  std::size_t size() const noexcept { return size_; }               ///< values kept now
  std::size_t capacity() const noexcept { return values_.size(); }  ///< values kept at most
  bool empty() const noexcept { return size_ == 0; }                ///< before the first push()
  bool full() const noexcept { return size_ == values_.size(); }    ///< the next push() forgets one
  void clear() noexcept { next_ = size_ = 0; }                      ///< forgets all values

 private:
  static std::size_t checked(std::size_t capacity) {
    detail::require(capacity > 0, "RingBuffer::capacity", ">= 1", capacity);
    return capacity;
  }

  std::vector<Value> values_;
  std::size_t next_ = 0;  // where the next push goes
  std::size_t size_ = 0;
};

}  // namespace rme
