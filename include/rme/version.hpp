#pragma once
/// The version of these headers. CMake, package.xml and the packages have the same (checked by the ctest
/// package.versions).

/// For #if: 10,000 major + 100 minor + patch.
#define RME_VERSION 10000

namespace rme {

inline constexpr int kVersionMajor = 1;           ///< with a new one, users may have to change their code
inline constexpr int kVersionMinor = 0;           ///< with a new one, there are new names; users' code stays as it is
inline constexpr int kVersionPatch = 0;           ///< with a new one, estimates may be better
inline constexpr const char* kVersion = "1.0.0";  ///< all three, for logs

}  // namespace rme
