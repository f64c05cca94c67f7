#pragma once
#include <fstream>

#include "pinocchio/multibody/model.hpp"

namespace pinocchio::urdf {

inline Model& buildModelFromXML(const std::string& xml_stream, Model& model, bool /*verbose*/ = false,
                                bool /*mimic*/ = false) {
  if (xml_stream.find("<robot") == std::string::npos)
    throw std::invalid_argument("the XML stream does not contain a valid URDF model");
  const auto has = [&](const std::string& text) { return xml_stream.find(text) != std::string::npos; };
  for (int j = 1; j <= 7; ++j) {
    const std::string name = "panda_joint" + std::to_string(j);
    model.append(
        name, has("\"" + name + "\" type=\"continuous\"") ? 2 : 1,  // cosine and sine
        has("<link") && !has("<inertial>") ? 0 : model.arm.links.at(static_cast<std::size_t>(j) - 1).body.mass);
  }
  for (int j = 1; j <= 2; ++j)
    if (const std::string name = "panda_finger_joint" + std::to_string(j); has(name)) model.append(name, 1, 0.01);
  model.frames = {{"panda_link8", 7, SE3(Eigen::Matrix3d::Identity(), model.arm.flange)}};
  model.nframes = 1;
  return model;
}

inline Model& buildModel(const std::string& filename, Model& model, bool verbose = false, bool mimic = false) {
  std::ifstream file(filename);
  if (!file) throw std::invalid_argument("the file " + filename + " does not contain a valid URDF model");
  return buildModelFromXML({std::istreambuf_iterator<char>(file), {}}, model, verbose, mimic);
}

}  // namespace pinocchio::urdf
