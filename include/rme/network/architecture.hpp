#pragma once
/// The sizes of a mismatch network.
#include <array>

namespace rme {

/// The published network (Table 4 of the paper): 53,252 parameters. Another architecture is a struct with the same
/// names.
struct PublishedArchitecture {
  static constexpr int kSamples = 20;       ///< M, pseudo-wrenches in a window
  static constexpr int kChannels = 6;       ///< force and moment
  static constexpr int kConvChannels = 64;  ///< C, also the attention's embedding
  static constexpr int kConvKernel = 5;     ///< taps over time; odd, padded so that the length stays
  static constexpr int kHeads = 8;          ///< divides kConvChannels
  static constexpr int kMlpHidden = 256;    ///< H
  static constexpr int kMlpRepeats = 3;     ///< how often the block is applied, with the same weights
  static constexpr int kOutputs = 4;        ///< theta = (m [kg], r_x, r_y, r_z [m])
  /// Names of the outputs in a weights file.
  static constexpr std::array<const char*, kOutputs> kOutputNames{"mass", "com_x", "com_y", "com_z"};
};

}  // namespace rme
