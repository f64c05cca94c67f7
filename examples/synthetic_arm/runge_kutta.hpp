#pragma once
/// The synthetic arm's own physics: Runge-Kutta 4 with dry friction.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <rme/core/require.hpp>
#include <synthetic_arm/physics.hpp>

namespace rme::examples {

/// Friction is dry: a joint at rest stays at rest until its breakaway torque is exceeded. In each step the friction
/// torques are those that make the velocity at its end obey Coulomb's law (an implicit step), which neither creeps nor
/// chatters; they are then held while the smooth rest of the motion is integrated.
template <int Dofs>
class RungeKutta final : public Physics<Dofs> {
 public:
  using Vector = JointVector<double, Dofs>;

  /// @throws std::invalid_argument for a negative friction
  RungeKutta(const ArmModel<Dofs>& model, const JointFriction<Dofs>& friction);
  static std::unique_ptr<Physics<Dofs>> make(const ArmModel<Dofs>& model, const JointFriction<Dofs>& friction) {
    return std::make_unique<RungeKutta>(model, friction);
  }

  Vector step(double h, const Load<Dofs>& load, JointState<Dofs>& state) override;

 private:
  // ddq by the equation of motion, payload and push included
  struct Motion {
    Eigen::LLT<JointMatrix<double, Dofs>> mass_matrix;
    Vector ddq;
  };
  Motion motion(const Vector& q, const Vector& dq, const Load<Dofs>& load) const;
  void solve_friction(const Motion& smooth, const Vector& dq, double h);

  ArmModel<Dofs> model_;
  JointFriction<Dofs> config_;
  bool has_friction_;
  Vector friction_ = Vector::Zero();  // torque on the arm in the last step
};

template <int Dofs>
RungeKutta<Dofs>::RungeKutta(const ArmModel<Dofs>& model, const JointFriction<Dofs>& friction)
    : model_(model),
      config_(friction),
      has_friction_((friction.coulomb.array() > 0).any() || (friction.viscous.array() > 0).any()) {
  for (int i = 0; i < Dofs; ++i) {
    rme::detail::require(friction.coulomb[i] >= 0, "JointFriction::coulomb", ">= 0 N m", friction.coulomb[i]);
    rme::detail::require(friction.viscous[i] >= 0, "JointFriction::viscous", ">= 0 N m s/rad", friction.viscous[i]);
  }
}

template <int Dofs>
auto RungeKutta<Dofs>::step(double h, const Load<Dofs>& load, JointState<Dofs>& state) -> Vector {
  auto& [q, dq] = state;
  Motion first = motion(q, dq, load);
  Load<Dofs> held = load;
  if (has_friction_) {
    solve_friction(first, dq, h);
    held.torque += friction_;
    first.ddq += first.mass_matrix.solve(friction_);
  }
  const Vector v1 = dq, a1 = first.ddq;
  const Vector v2 = dq + h / 2 * a1, a2 = motion(q + h / 2 * v1, v2, held).ddq;
  const Vector v3 = dq + h / 2 * a2, a3 = motion(q + h / 2 * v2, v3, held).ddq;
  const Vector v4 = dq + h * a3, a4 = motion(q + h * v3, v4, held).ddq;
  q += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
  dq += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  return friction_;
}

template <int Dofs>
auto RungeKutta<Dofs>::motion(const Vector& q, const Vector& dq, const Load<Dofs>& load) const -> Motion {
  const Dynamics<Dofs> d = model_.dynamics(q, dq, load.payload);
  Motion out;
  out.mass_matrix.compute(d.mass_matrix);
  Vector net = load.torque - d.coriolis - d.gravity;
  const Vector6<double> w = load.push.vector();
  if (!w.isZero(0)) net += model_.kinematics(q).jacobian.transpose() * w;
  out.ddq = out.mass_matrix.solve(net);
  return out;
}

// Finds the friction torques f with v = dq + h (ddq + M^-1 f), where each joint either rests, v_i = 0 and
// |f_i| <= coulomb_i, or slides, f_i = -coulomb_i sign(v_i) - viscous_i v_i. One joint at a time (projected
// Gauss-Seidel), from the last step's torques; M^-1 is positive definite, so this converges.
template <int Dofs>
void RungeKutta<Dofs>::solve_friction(const Motion& smooth, const Vector& dq, double h) {
  const JointMatrix<double, Dofs> hA = h * smooth.mass_matrix.solve(JointMatrix<double, Dofs>::Identity());
  Vector v = dq + h * smooth.ddq + hA * friction_;
  for (int sweep = 0; sweep < 100; ++sweep) {
    double change = 0;
    for (int i = 0; i < Dofs; ++i) {
      const double free = v[i] - hA(i, i) * friction_[i];  // without this joint's own friction
      double f = -free / hA(i, i);
      if (std::abs(f) > config_.coulomb[i]) {
        const double sliding =
            (free - std::copysign(hA(i, i) * config_.coulomb[i], free)) / (1 + hA(i, i) * config_.viscous[i]);
        f = -std::copysign(config_.coulomb[i], free) - config_.viscous[i] * sliding;
      }
      v += hA.col(i) * (f - friction_[i]);
      change = std::max(change, std::abs(f - friction_[i]));
      friction_[i] = f;
    }
    if (change < 1e-10) return;
  }
}

extern template class RungeKutta<6>;
extern template class RungeKutta<7>;

}  // namespace rme::examples
