#pragma once
/// A picture in memory, and the PNG file that it becomes.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace rme::examples {

struct Rgb {
  std::uint8_t red = 255, green = 255, blue = 255;
};

/// Pixels by rows, the top row first.
class Picture {
 public:
  Picture(std::size_t width, std::size_t height) : width_(width), height_(height), pixels_(width * height) {}

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  Rgb& at(std::size_t x, std::size_t y) { return pixels_[y * width_ + x]; }
  const Rgb& at(std::size_t x, std::size_t y) const { return pixels_[y * width_ + x]; }

  /// Half as wide and high, each pixel the mean of four: what was drawn sharp comes out smooth.
  Picture halved() const;
  /// Another picture of the same height to the right of this one.
  Picture beside(const Picture& right) const;
  /// @throws std::runtime_error if the file cannot be written
  void write_png(const std::string& path) const;

 private:
  std::size_t width_, height_;
  std::vector<Rgb> pixels_;
};

}  // namespace rme::examples
