#include "mjcf.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <sstream>
#include <stdexcept>

namespace rme::examples {

namespace {

// A body or a shape compiled with an identity frame ignores later changes of it: the payload starts as something small
// that is offset and turned, each in its own way.
constexpr const char* kPayload =
    R"(<body name="payload"><inertial pos="0.01 0.02 0.03" quat="0.5 0.5 0.5 0.5" mass="1e-9" diaginertia="1.0e-12 1.1e-12 1.2e-12"/>
<geom name="payload" type="box" size="0.05 0.05 0.05" pos="0.03 0.02 0.01" quat="0.5 -0.5 0.5 0.5" rgba="0.84 0.37 0 0"/>
<geom name="rod" size="0.008" fromto="0 0 0 0 0 0.1" rgba="0.36 0.40 0.45 0"/>)";
// MuJoCo pushes a body at its centre of mass: the flange is a speck whose centre is its origin.
constexpr const char* kSpeck = R"(<inertial pos="0 0 0" mass="1e-9" diaginertia="1e-12 1e-12 1e-12"/>)";

// Light, floor and colours. Groups: 0 the arm, 1 what it stands on.
constexpr const char* kLooks = R"(<visual>
<global offwidth="4096" offheight="4096"/><quality shadowsize="4096" offsamples="8"/><map znear="0.01" zfar="30"/>
<headlight ambient="0.45 0.45 0.45" diffuse="0.3 0.3 0.3" specular="0 0 0"/>
</visual>
<asset>
<texture name="sky" type="skybox" builtin="flat" rgb1="1 1 1" width="64" height="384"/>
<material name="shell" rgba="0.93 0.94 0.95 1" specular="0.3" shininess="0.4"/>
<material name="joint" rgba="0.36 0.40 0.45 1" specular="0.3" shininess="0.4"/>
<material name="floor" rgba="1 1 1 1" specular="0" reflectance="0"/>
</asset>
)";
constexpr const char* kSurroundings =
    R"(<light directional="true" pos="1 -1 3" dir="-0.4 0.5 -1" diffuse="0.55 0.55 0.55" specular="0.2 0.2 0.2"/>
<geom type="plane" size="0 0 0.1" material="floor" group="1"/>
<geom type="cylinder" size="0.09" fromto="0 0 0 0 0 0.04" material="joint" group="1"/>
)";

std::string quaternion(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  std::ostringstream out;
  out.precision(17);
  out << q.w() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z();
  return out.str();
}

}  // namespace

template <int Dofs>
std::string to_mjcf(const ArmModel<Dofs>& model, const JointFriction<Dofs>& friction, bool shapes) {
  std::ostringstream out;
  out.precision(17);
  const Eigen::IOFormat numbers(Eigen::FullPrecision, Eigen::DontAlignCols, " ", " ");
  out << "<mujoco model=\"" << model.name << "\">\n"
      << "<compiler angle=\"radian\" discardvisual=\"" << (shapes ? "false" : "true")
      << "\"/>\n<option integrator=\"RK4\" gravity=\"" << model.gravity_vector.format(numbers)
      << "\" iterations=\"200\" tolerance=\"1e-12\"><flag contact=\"disable\"/></option>\n"
      << kLooks << "<default><geom mass=\"0\" contype=\"0\" conaffinity=\"0\" type=\"capsule\" material=\"shell\"/>\n"
      << "<joint type=\"hinge\" axis=\"0 0 1\" solreffriction=\"0.002 1\" solimpfriction=\"0.9999 0.9999 "
         "0.001\"/></default>\n"
      << "<worldbody>\n"
      << kSurroundings;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const auto& [offset, rotation, body] = model.links[i];
    const auto j = static_cast<Eigen::Index>(i);
    const Eigen::Matrix3d& I = body.inertia;
    const double radius = i < 4 ? 0.06 : 0.05;  // the wrist is slimmer
    if (offset.norm() > 0.02)
      out << "<geom size=\"" << 0.9 * radius << "\" fromto=\"" << (i == 0 ? 0.2 : 0.0) * offset.transpose() << ' '
          << offset.format(numbers) << "\"/>\n";
    out << "<body name=\"link" << i + 1 << "\" pos=\"" << offset.format(numbers) << "\" quat=\"" << quaternion(rotation)
        << "\"><inertial mass=\"" << body.mass << "\" pos=\"" << body.com.format(numbers) << "\" fullinertia=\""
        << I(0, 0) << ' ' << I(1, 1) << ' ' << I(2, 2) << ' ' << I(0, 1) << ' ' << I(0, 2) << ' ' << I(1, 2)
        << "\"/><joint damping=\"" << friction.viscous[j] << "\" frictionloss=\"" << friction.coulomb[j] << "\"/>\n"
        << "<geom type=\"cylinder\" size=\"" << radius << "\" fromto=\"0 0 -0.06 0 0 0.06\"/>\n"
        << "<geom type=\"cylinder\" size=\"" << 0.85 * radius
        << "\" fromto=\"0 0 -0.068 0 0 0.068\" material=\"joint\"/>\n";
  }
  out << "<geom size=\"0.04\" fromto=\"0 0 0 " << (0.6 * model.flange).format(numbers) << "\"/>\n"
      << "<body name=\"flange\" pos=\"" << model.flange.format(numbers) << "\" quat=\""
      << quaternion(model.flange_rotation) << "\">" << kSpeck << "\n"
      << "<geom type=\"cylinder\" size=\"0.035\" fromto=\"0 0 -0.03 0 0 0\" material=\"joint\"/>\n"
      << kPayload << "</body></body>";
  for (std::size_t i = 0; i < model.links.size(); ++i) out << "</body>";
  out << "\n</worldbody>\n</mujoco>\n";
  return out.str();
}

void MujocoDelete::operator()(mjModel_* model) const {
  mj_deleteModel(model);
}
void MujocoDelete::operator()(mjData_* data) const {
  mj_deleteData(data);
}

MujocoModel compile_mjcf(const std::string& mjcf) {
  static std::mutex parser;  // MuJoCo's is not reentrant
  const std::lock_guard<std::mutex> lock(parser);
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "arm.xml", static_cast<int>(mjcf.size()));
  std::copy(mjcf.begin(), mjcf.end(), static_cast<char*>(files->filedata[0]));
  std::array<char, 1000> error{};
  MujocoModel model(mj_loadXML("arm.xml", files.get(), error.data(), static_cast<int>(error.size())));
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(std::string("MuJoCo: ") + error.data());
  return model;
}

template std::string to_mjcf<6>(const ArmModel<6>&, const JointFriction<6>&, bool);
template std::string to_mjcf<7>(const ArmModel<7>&, const JointFriction<7>&, bool);

}  // namespace rme::examples
