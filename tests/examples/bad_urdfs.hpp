#pragma once
/// URDFs that no arm can be made of, and what is to be said of each.
#include <precompiled/joint_counts.hpp>
#include <string>
#include <vector>

namespace rme::testing {

/// Links l0 to l7 in a row, each a kilogram; a joint's type, and what stands in for a link's inertia, can be others.
inline std::string small_arm(const std::string& type = "continuous", const std::string& more = "",
                             bool with_inertia = true) {
  std::string text = "<robot name='arm'><link name='l0'/>";
  const std::string inertia =
      "<inertial><mass value='1'/><inertia ixx='0.01' ixy='0' ixz='0' iyy='0.01' iyz='0' izz='0.01'/>"
      "</inertial>";
  for (int i = 1; i <= 7; ++i) {
    const std::string n = std::to_string(i), before = std::to_string(i - 1);
    const bool odd = i == 3;
    text +=
        "<link name='l" + n + "'>" + (odd && !with_inertia ? "" : inertia) + "</link><joint name='j" + n + "' type='" +
        (odd ? type : "continuous") + "'><parent link='l" + before + "'/><child link='l" + n +
        "'/><origin xyz='0 0 0.3'/><axis xyz='0 1 0'/><limit effort='50' velocity='1' lower='-1' upper='2'/></joint>";
  }
  return text + more + "</robot>";
}

struct BadUrdf {
  std::string text, base, tip, reason;
};

/// Nineteen of them.
inline std::vector<BadUrdf> bad_urdfs() {
  const auto with = [](const std::string& what, const std::string& instead) {  // the first of it
    std::string text = small_arm();
    return text.replace(text.find(what), what.size(), instead);
  };
  const std::string branch =
      "<link name='x'/><joint name='jx' type='fixed'><parent link='l2'/><child link='x'/></joint>";
  const std::string second = "<joint name='again' type='fixed'><parent link='l0'/><child link='l3'/></joint>";
  const std::string round = "<joint name='round' type='fixed'><parent link='l7'/><child link='l0'/></joint>";
  const std::string counts = std::to_string(examples::kFewestJoints) + " to " + std::to_string(examples::kMostJoints);
  return {
      {small_arm(), "base", "l7", "has no link base; there are l0, l1, l2, l3, l4, l5, l6, l7"},
      {small_arm(), "l0", "tool0", "has no link tool0; there are l0, l1"},
      {small_arm(), "l7", "l0", "link l7 is not between the root and link l0"},
      {small_arm("continuous", branch), "l3", "x", "link l3 is not between the root and link x"},
      {small_arm("prismatic"), "l0", "l7", "joint j3 between l0 and l7 is prismatic"},
      {small_arm("floating"), "l0", "l7", "joint j3 between l0 and l7 is floating"},
      {small_arm("continuous", "", false), "l0", "l7", "link l3, which joint j3 moves, has no inertia"},
      {small_arm("continuous", second), "l0", "l7", "link l3 hangs on joints again and j3: a loop"},
      {small_arm("continuous", round), "l0", "l7", "is no URDF that can be used: "},
      {small_arm(), "l0", "l3",
       "there are 3 joints that move between l0 and l3; the programs are compiled for " + counts},
      {small_arm("fixed"), "l0", "l4", "there are 3 joints that move"},
      {"", "l0", "l7", "is no URDF that can be used"},
      {"<robot name='x'><link", "l0", "l7", "is no URDF that can be used"},
      {"{\"rated_payload\": 3}", "l0", "l7", "is no URDF that can be used"},
      {"<robot xmlns:xacro='x'><xacro:arm/></robot>", "l0", "l7", "is a xacro file"},
      {with("ixx='0.01'", "ixx='-0.1'"), "l0", "l7", "link l1 has an inertia that no body has"},
      {with("mass value='1'", "mass value='-1'"), "l0", "l7", "link l1 has a mass of -1"},
      {with("mass value='1'", "mass value='heavy'"), "l0", "l7", "link l1, which joint j1 moves, has no inertia"},
      {with("axis xyz='0 1 0'", "axis xyz='0 0 0'"), "l0", "l7", "joint j1 has no axis"},
  };
}

}  // namespace rme::testing
