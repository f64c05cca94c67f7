#pragma once
/// The numbers of joints for which programs are compiled.

#ifndef RME_JOINT_COUNTS
#define RME_JOINT_COUNTS 4, 8
#endif

namespace rme::examples {

inline constexpr int kJointCounts[] = {RME_JOINT_COUNTS};
inline constexpr int kFewestJoints = kJointCounts[0], kMostJoints = kJointCounts[1];

}  // namespace rme::examples
