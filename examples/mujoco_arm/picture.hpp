#pragma once
/// A picture in memory, and the PNG file that it becomes.
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
  Picture(int width, int height)
      : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  int width() const { return width_; }
  int height() const { return height_; }
  Rgb& at(int x, int y) { return pixels_[static_cast<std::size_t>(y * width_ + x)]; }
  const Rgb& at(int x, int y) const { return pixels_[static_cast<std::size_t>(y * width_ + x)]; }

  /// Half as wide and high, each pixel the mean of four: what was drawn sharp comes out smooth.
  Picture halved() const;
  /// Another picture of the same height to the right of this one.
  Picture beside(const Picture& right) const;
  /// @throws std::runtime_error if the file cannot be written
  void write_png(const std::string& path) const;

 private:
  int width_, height_;
  std::vector<Rgb> pixels_;
};

}  // namespace rme::examples
