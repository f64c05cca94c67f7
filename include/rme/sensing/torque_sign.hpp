#pragma once
/// Which torque an arm reports as external.
#include <cstdint>

namespace rme {

/// The factor by which the reported tau_ext is multiplied to get the torque that the environment exerts on the arm.
enum class TorqueSign : std::int8_t {
  External = 1,   ///< what the environment exerts on the arm (the convention of rme)
  Reaction = -1,  ///< what the arm exerts on the environment
};

}  // namespace rme
