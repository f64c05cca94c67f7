#pragma once
#include <fstream>
#include <iterator>
#include <synthetic_arm/light_arm.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/six_joint_arm.hpp>

#include "pinocchio/multibody/model.hpp"

namespace pinocchio::urdf {

namespace stand_in {  // not Pinocchio's

struct Robot {
  std::vector<std::string> joints;  // of the arm, from the base
  std::string end_effector;
  rme::examples::ArmModel<7> arm;
};

/// A six-joint arm as one of seven, whose last joint carries nothing.
inline rme::examples::ArmModel<7> with_idle_joint(const rme::examples::ArmModel<6>& six) {
  rme::examples::ArmModel<7> arm{};
  for (std::size_t i = 0; i < 6; ++i) arm.links[i] = six.links[i];
  arm.links[6] = {six.flange, six.flange_rotation, {}};
  arm.flange.setZero();
  return arm;
}

inline std::vector<std::string> numbered(const std::string& name) {
  std::vector<std::string> names;
  for (int j = 1; j <= 7; ++j) names.push_back(name + std::to_string(j));
  return names;
}

/// The robot that the text names the first joint of; a Panda if it names none.
inline Robot robot_of(const std::string& xml) {
  const auto has = [&](const char* text) { return xml.find(text) != std::string::npos; };
  if (has("shoulder_pan_joint"))
    return {
        {"shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint"},
        "tool0",
        with_idle_joint(rme::examples::six_joint_arm())};
  if (has("light_joint1")) return {numbered("light_joint"), "light_tool", rme::examples::light_arm()};
  if (has("lbr_A1")) return {numbered("lbr_A"), "lbr_link_ee", rme::examples::panda()};
  if (has("\"joint_1\"")) return {numbered("joint_"), "end_effector_link", rme::examples::panda()};
  return {numbered("panda_joint"), "panda_link8", rme::examples::panda()};
}

}  // namespace stand_in

inline Model& buildModelFromXML(const std::string& xml_stream, Model& model, bool /*verbose*/ = false,
                                bool /*mimic*/ = false) {
  if (xml_stream.find("<robot") == std::string::npos)
    throw std::invalid_argument("the XML stream does not contain a valid URDF model");
  const auto has = [&](const std::string& text) { return xml_stream.find(text) != std::string::npos; };
  const auto massless = [&](std::size_t j) {  // the link of a Panda's joint j; or all of another arm
    if (has("<link") && !has("<inertial>")) return true;
    const std::size_t from = xml_stream.find("<link name=\"panda_link" + std::to_string(j + 1) + "\">");
    return from != std::string::npos && xml_stream.find("<inertial>", from) > xml_stream.find("</link>", from);
  };
  const stand_in::Robot robot = stand_in::robot_of(xml_stream);
  model.arm = robot.arm;
  model.arm.name.clear();  // so that a copy allocates nothing
  for (std::size_t j = 0; j < robot.joints.size(); ++j)
    model.append(robot.joints[j],
                 has("\"" + robot.joints[j] + "\" type=\"continuous\"") ? 2 : 1,  // cosine and sine
                 massless(j) ? 0 : model.arm.links.at(j).body.mass);
  for (int j = 1; j <= 2; ++j)
    if (const std::string name = "panda_finger_joint" + std::to_string(j); has(name)) model.append(name, 1, 0.01);
  const rme::examples::Link& idle = model.arm.links[6];
  const bool six = robot.joints.size() == 6;
  model.frames = {{robot.end_effector, robot.joints.size(), 0,
                   six ? SE3(idle.rotation, idle.offset) : SE3(model.arm.flange_rotation, model.arm.flange), BODY}};
  model.nframes = 1;
  return model;
}

inline Model& buildModel(const std::string& filename, Model& model, bool verbose = false, bool mimic = false) {
  std::ifstream file(filename);
  if (!file) throw std::invalid_argument("the file " + filename + " does not contain a valid URDF model");
  return buildModelFromXML({std::istreambuf_iterator<char>(file), {}}, model, verbose, mimic);
}

}  // namespace pinocchio::urdf
