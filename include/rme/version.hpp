#pragma once
/// The version of these headers. CMake, package.xml and the packages have the same (checked by the ctest
/// package.versions).

/// For #if: 10,000 major + 100 minor + patch.
#define RME_VERSION 200

namespace rme {

inline constexpr int kVersionMajor = 0;           ///< with a new one, users may have to change their code
inline constexpr int kVersionMinor = 2;           ///< the same, while the major version is 0
inline constexpr int kVersionPatch = 0;           ///< with a new one, users' code stays as it is
inline constexpr const char* kVersion = "0.2.0";  ///< all three, for logs

}  // namespace rme
