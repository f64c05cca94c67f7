#pragma once
/// Stands in for urdfdom's parser, which is not to be had for WebAssembly: urdf_parser.cpp reads what urdf_arm needs.
#include <urdf_model/model.h>
#include <urdf_world/types.h>

#include <string>

namespace urdf {

/// Links with their inertias, and joints with their limits. Errors go to console_bridge.
/// @return null after an error
ModelInterfaceSharedPtr parseURDF(const std::string& text);

}  // namespace urdf
