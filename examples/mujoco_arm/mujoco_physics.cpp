#include "mujoco_physics.hpp"

#include <mujoco/mujoco.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <mutex>
#include <sstream>
#include <stdexcept>

namespace rme::examples {

namespace {

// A body compiled with an identity frame ignores later changes of body_ipos and body_iquat: the payload starts as
// something small that is offset and turned.
constexpr const char* kPayload =
    R"(<body name="payload"><inertial pos="0.01 0.02 0.03" quat="0.5 0.5 0.5 0.5" mass="1e-9" diaginertia="1.0e-12 1.1e-12 1.2e-12"/>)";
// MuJoCo pushes a body at its centre of mass: the flange is a speck whose centre is its origin.
constexpr const char* kSpeck = R"(<inertial pos="0 0 0" mass="1e-9" diaginertia="1e-12 1e-12 1e-12"/>)";

std::string quaternion(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  std::ostringstream out;
  out.precision(17);
  out << q.w() << ' ' << q.x() << ' ' << q.y() << ' ' << q.z();
  return out.str();
}

mjModel_* load(const std::string& mjcf) {
  static std::mutex parser;  // MuJoCo's is not reentrant
  const std::lock_guard<std::mutex> lock(parser);
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), "arm.xml", static_cast<int>(mjcf.size()));
  std::copy(mjcf.begin(), mjcf.end(), static_cast<char*>(files->filedata[0]));
  std::array<char, 1000> error{};
  mjModel_* model = mj_loadXML("arm.xml", files.get(), error.data(), static_cast<int>(error.size()));
  mj_deleteVFS(files.get());
  if (!model) throw std::runtime_error(std::string("MuJoCo: ") + error.data());
  return model;
}

}  // namespace

template <int Dofs>
std::string to_mjcf(const ArmModel<Dofs>& model, const JointFriction<Dofs>& friction) {
  std::ostringstream out;
  out.precision(17);
  const Eigen::IOFormat numbers(Eigen::FullPrecision, Eigen::DontAlignCols, " ", " ");
  out << "<mujoco model=\"" << model.name << "\">\n"
      << "<compiler angle=\"radian\"/>\n<option integrator=\"RK4\" gravity=\"" << model.gravity_vector.format(numbers)
      << "\" iterations=\"200\" tolerance=\"1e-12\"><flag contact=\"disable\"/></option>\n"
      << "<default><geom mass=\"0\" contype=\"0\" conaffinity=\"0\" type=\"capsule\" size=\"0.05\" rgba=\"0.9 0.9 0.92 "
         "1\"/>\n"
      << "<joint type=\"hinge\" axis=\"0 0 1\" solreffriction=\"0.002 1\" solimpfriction=\"0.9999 0.9999 "
         "0.001\"/></default>\n"
      << "<worldbody>\n";
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const auto& [offset, rotation, body] = model.links[i];
    const auto j = static_cast<Eigen::Index>(i);
    const Eigen::Matrix3d& I = body.inertia;
    if (offset.norm() > 0.02) out << "<geom fromto=\"0 0 0 " << offset.format(numbers) << "\"/>\n";
    out << "<body name=\"link" << i + 1 << "\" pos=\"" << offset.format(numbers) << "\" quat=\"" << quaternion(rotation)
        << "\"><inertial mass=\"" << body.mass << "\" pos=\"" << body.com.format(numbers) << "\" fullinertia=\""
        << I(0, 0) << ' ' << I(1, 1) << ' ' << I(2, 2) << ' ' << I(0, 1) << ' ' << I(0, 2) << ' ' << I(1, 2)
        << "\"/><joint damping=\"" << friction.viscous[j] << "\" frictionloss=\"" << friction.coulomb[j] << "\"/>\n"
        << "<geom fromto=\"0 0 -0.06 0 0 0.06\" rgba=\"0.35 0.4 0.45 1\"/>\n";
  }
  out << "<body name=\"flange\" pos=\"" << model.flange.format(numbers) << "\">" << kSpeck << "\n"
      << "<geom type=\"cylinder\" size=\"0.04\" fromto=\"0 0 -0.03 0 0 0\" rgba=\"0.35 0.4 0.45 1\"/>\n"
      << kPayload << "</body></body>";
  for (std::size_t i = 0; i < model.links.size(); ++i) out << "</body>";
  out << "\n</worldbody>\n</mujoco>\n";
  return out.str();
}

template <int Dofs>
void MujocoPhysics<Dofs>::Delete::operator()(mjModel_* model) const {
  mj_deleteModel(model);
}
template <int Dofs>
void MujocoPhysics<Dofs>::Delete::operator()(mjData_* data) const {
  mj_deleteData(data);
}

template <int Dofs>
MujocoPhysics<Dofs>::MujocoPhysics(const ArmModel<Dofs>& model, const JointFriction<Dofs>& friction)
    : model_(load(to_mjcf(model, friction))),
      data_(mj_makeData(model_.get())),
      scratch_(mj_makeData(model_.get())),
      payload_(mj_name2id(model_.get(), mjOBJ_BODY, "payload")),
      flange_(mj_name2id(model_.get(), mjOBJ_BODY, "flange")) {
  weld({});
}

template <int Dofs>
void MujocoPhysics<Dofs>::weld(const RigidBody& payload) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(payload.inertia);
  Eigen::Matrix3d axes = principal.eigenvectors();
  if (axes.determinant() < 0) axes.col(2) *= -1;
  const Eigen::Quaterniond turn(axes);
  const Eigen::Vector3d inertia = principal.eigenvalues().cwiseMax(0);
  mjModel_* m = model_.get();
  const std::array<double, 4> quat{turn.w(), turn.x(), turn.y(), turn.z()};
  std::copy(quat.begin(), quat.end(), m->body_iquat + 4 * payload_);
  std::copy(inertia.begin(), inertia.end(), m->body_inertia + 3 * payload_);
  std::copy(payload.com.begin(), payload.com.end(), m->body_ipos + 3 * payload_);
  m->body_mass[payload_] = payload.mass;
  // What MuJoCo derives from masses when it compiles, friction's scale among it. This leaves its data at the zero pose.
  mj_setConst(m, scratch_.get());
  welded_ = payload;
}

template <int Dofs>
auto MujocoPhysics<Dofs>::step(double h, const Load<Dofs>& load, JointState<Dofs>& state) -> Vector {
  if (load.payload.mass != welded_.mass || load.payload.com != welded_.com || load.payload.inertia != welded_.inertia)
    weld(load.payload);
  mjData_* d = data_.get();
  model_->opt.timestep = h;
  const Vector6<double> push = load.push.vector();
  std::copy(state.q.begin(), state.q.end(), d->qpos);
  std::copy(state.dq.begin(), state.dq.end(), d->qvel);
  std::copy(load.torque.begin(), load.torque.end(), d->qfrc_applied);
  std::copy(push.begin(), push.end(), d->xfrc_applied + 6 * flange_);
  mj_step(model_.get(), d);
  state.q = Eigen::Map<const Vector>(d->qpos);
  state.dq = Eigen::Map<const Vector>(d->qvel);
  return Eigen::Map<const Vector>(d->qfrc_constraint) + Eigen::Map<const Vector>(d->qfrc_passive);
}

template std::string to_mjcf<6>(const ArmModel<6>&, const JointFriction<6>&);
template std::string to_mjcf<7>(const ArmModel<7>&, const JointFriction<7>&);
template class MujocoPhysics<6>;
template class MujocoPhysics<7>;

}  // namespace rme::examples
