#pragma once
/// Where the children of a block are kept until it ends.
#include <array>
#include <cstddef>
#include <rme/tracking/story.hpp>
#include <utility>

namespace rme {

/// The children that stories have in a block, and those that are being computed. Several Histories may use the same,
/// one after the other. A child is moved by exchanging the numbers of two slots: a story is some 16 kB.
template <typename Scalar, int Dofs, int Capacity>
class StoryChildren {
 public:
  using Tale = Story<Scalar, Dofs>;  ///< a child

  Tale& kept(int i) noexcept { return slots_[at(slot_[at(i)])]; }              ///< i from 0 to Capacity - 1
  const Tale& kept(int i) const noexcept { return slots_[at(slot_[at(i)])]; }  ///< the same
  Tale& computed() noexcept { return kept(Capacity); }                         ///< the child that is being computed
  Tale& first() noexcept { return kept(Capacity + 1); }                        ///< for StoryFilter::take_in()
  Tale& drawn() noexcept { return kept(Capacity + 2); }                        ///< for StoryFilter::take_in()
  /// The computed child becomes kept(i); the one that was there is overwritten next.
  void keep(int i) noexcept { std::swap(slot_[at(i)], slot_[at(Capacity)]); }

  StoryChildren() noexcept {
    for (int i = 0; i < kSlots; ++i) slot_[at(i)] = i;
  }

 private:
  static constexpr std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }
  static constexpr int kSlots = Capacity + 3;
  std::array<Tale, at(kSlots)> slots_;
  std::array<int, at(kSlots)> slot_{};
};

}  // namespace rme
