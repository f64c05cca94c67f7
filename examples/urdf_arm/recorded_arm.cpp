#include "urdf_arm/recorded_arm.hpp"

namespace rme::examples {

ArmRequest parse_arm(Arguments& arguments) {
  ArmRequest request;
  const auto urdf = arguments.text("--urdf"), base = arguments.text("--base"), tip = arguments.text("--tip");
  if (urdf) {
    if (!base) throw ArgumentError("--base: missing; --urdf needs to know the link that the arm stands on");
    if (!tip) throw ArgumentError("--tip: missing; --urdf needs to know the link that is the end effector");
    request.chain = read_urdf(*urdf, *base, *tip);
  } else if (base || tip) {
    throw ArgumentError(std::string(base ? "--base" : "--tip") + ": means nothing without --urdf");
  }
  request.rated_payload = arguments.number("--rated-payload");
  request.torque_sign = arguments.choice<TorqueSign>(
      "--torque-sign", {{"external", TorqueSign::External}, {"reaction", TorqueSign::Reaction}});
  if (const auto gains = arguments.numbers("--gains", static_cast<std::size_t>(request.dofs()))) {
    for (const double gain : *gains)
      if (gain == 0) throw ArgumentError("--gains: must not be zero");
    request.gains = *gains;
  }
  if (const auto rotors = arguments.numbers("--rotor-inertia", static_cast<std::size_t>(request.dofs()))) {
    for (const double inertia : *rotors)
      if (!(inertia >= 0)) throw ArgumentError("--rotor-inertia: must not be negative");
    request.rotor_inertia = *rotors;
  }
  if (const auto g = arguments.numbers("--gravity", 3)) {
    request.gravity = Eigen::Vector3d((*g)[0], (*g)[1], (*g)[2]);
    if (!(request.gravity->norm() > 0)) throw ArgumentError("--gravity: must not be zero");
  }
  if (const auto tool = arguments.numbers("--tool", 4)) {
    request.tool = {(*tool)[0], Eigen::Vector3d((*tool)[1], (*tool)[2], (*tool)[3]), Eigen::Matrix3d::Zero()};
    if (!(request.tool.mass > 0)) throw ArgumentError("--tool: its mass must be above 0 kg");
    if (request.chain) {
      RigidBody& last = request.chain->links.back().body;
      last = last + moved(request.tool, request.chain->tip, request.chain->tip_rotation);
    }
  }
  request.lacks_gravity = arguments.flag("--tau-lacks-gravity");
  return request;
}

std::vector<std::string> joint_names(const ArmRequest& request) {
  std::vector<std::string> names;
  for (int j = 0; j < request.dofs(); ++j)
    names.push_back(request.chain ? request.chain->joints[static_cast<std::size_t>(j)].name
                                  : "panda_joint" + std::to_string(j + 1));
  return names;
}

}  // namespace rme::examples
