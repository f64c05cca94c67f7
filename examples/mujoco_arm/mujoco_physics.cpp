#include "mujoco_physics.hpp"

#include <mujoco/mujoco.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>

namespace rme::examples {

template <int Dofs>
MujocoPhysics<Dofs>::MujocoPhysics(const ArmModel<Dofs>& model, const JointFriction<Dofs>& friction)
    : model_(compile_mjcf(to_mjcf(model, friction, false))),
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

template class MujocoPhysics<6>;
template class MujocoPhysics<7>;

}  // namespace rme::examples
