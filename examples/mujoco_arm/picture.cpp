#include "picture.hpp"

#include <zlib.h>

#include <array>
#include <fstream>
#include <stdexcept>

namespace rme::examples {

Picture Picture::halved() const {
  Picture half(width_ / 2, height_ / 2);
  for (std::size_t y = 0; y < half.height_; ++y) {
    for (std::size_t x = 0; x < half.width_; ++x) {
      std::array<int, 3> sum{};
      for (const auto& [dx, dy] : {std::array<std::size_t, 2>{0, 0}, {0, 1}, {1, 0}, {1, 1}}) {
        const Rgb& pixel = at(2 * x + dx, 2 * y + dy);
        sum[0] += pixel.red;
        sum[1] += pixel.green;
        sum[2] += pixel.blue;
      }
      const auto mean = [&](std::size_t i) { return static_cast<std::uint8_t>((sum[i] + 2) / 4); };
      half.at(x, y) = {mean(0), mean(1), mean(2)};
    }
  }
  return half;
}

Picture Picture::beside(const Picture& right) const {
  if (right.height_ != height_) throw std::invalid_argument("Picture::beside: another height");
  Picture both(width_ + right.width_, height_);
  for (std::size_t y = 0; y < height_; ++y) {
    for (std::size_t x = 0; x < width_; ++x) both.at(x, y) = at(x, y);
    for (std::size_t x = 0; x < right.width_; ++x) both.at(width_ + x, y) = right.at(x, y);
  }
  return both;
}

// PNG: a signature, then chunks of length, name, data and checksum, numbers big endian. The pixels are one zlib stream
// of rows, each preceded by its filter, 0 for none.
void Picture::write_png(const std::string& path) const {
  const auto number = [](std::size_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>(value >> shift & 0xFF));
    return bytes;
  };
  const auto chunk = [&](const std::string& name, const std::string& data) {
    const std::string body = name + data;
    const auto* bytes = reinterpret_cast<const Bytef*>(body.data());
    return number(data.size()) + body + number(crc32(0, bytes, static_cast<uInt>(body.size())));
  };
  std::string rows;
  for (std::size_t y = 0; y < height_; ++y) {
    rows.push_back(0);
    for (std::size_t x = 0; x < width_; ++x)
      for (const std::uint8_t value : {at(x, y).red, at(x, y).green, at(x, y).blue})
        rows.push_back(static_cast<char>(value));
  }
  uLongf size = compressBound(rows.size());
  std::string packed(size, 0);
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
                rows.size(), Z_BEST_COMPRESSION) != Z_OK)
    throw std::runtime_error(path + ": cannot be compressed");
  packed.resize(size);
  const std::string format = {8, 2, 0, 0, 0};  // 8 bits of each of three colours
  const std::string header = number(width_) + number(height_);
  std::ofstream file(path, std::ios::binary);
  file << "\x89PNG\r\n\x1a\n" << chunk("IHDR", header + format) << chunk("IDAT", packed) << chunk("IEND", "");
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace rme::examples
