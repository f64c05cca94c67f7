#pragma once
/// The version of these headers, as CMake, package.xml and the packages have it (the ctest package.versions).

/// For #if: 10,000 major + 100 minor + patch.
#define RME_VERSION 200

namespace rme {

inline constexpr int kVersionMajor = 0;           ///< a change may break users
inline constexpr int kVersionMinor = 2;           ///< may break them too while the major version is 0
inline constexpr int kVersionPatch = 0;           ///< breaks nothing
inline constexpr const char* kVersion = "0.2.0";  ///< all three, for logs

}  // namespace rme
