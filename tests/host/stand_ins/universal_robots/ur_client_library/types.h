#pragma once
// As much of UR's client library as its host uses, by its names and signatures.
#include <array>

namespace urcl {

using vector3d_t = std::array<double, 3>;
using vector6d_t = std::array<double, 6>;

}  // namespace urcl
