#pragma once
/// Rigid-body kinematics and dynamics of a serial arm with revolute joints, from a table of numbers.
///
/// Every spatial quantity is written in world axes about the world origin, so that sums over bodies need no transforms:
/// the motion of joint i is S_i = (o_i x z_i, z_i), linear part first, and inertias of bodies simply add
/// (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapters 5 and 6).
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/core/wrench.hpp>
#include <string>

namespace rme::examples {

/// A rigid body in the axes that it is fixed to: link axes for a link, flange axes for a payload.
struct RigidBody {
  double mass = 0;                                    ///< [kg]
  Eigen::Vector3d com = Eigen::Vector3d::Zero();      ///< centre of mass [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre of mass [kg m^2]
};

/// Both bodies welded together.
RigidBody operator+(const RigidBody& a, const RigidBody& b);

/// The body in other axes: those in which its own axes' origin is at `offset` [m], and which `rotation` maps them to.
RigidBody moved(const RigidBody& body, const Eigen::Vector3d& offset, const Eigen::Matrix3d& rotation);

/// The same shape with `factor` of the density: how a payload that is being handed over weighs in.
RigidBody operator*(double factor, const RigidBody& body);

/// A solid box of even density, e.g. a payload; a box is more honest than a point mass.
/// @param size  edge lengths along the axes that the body is fixed to [m]
RigidBody box(double mass, const Eigen::Vector3d& com, const Eigen::Vector3d& size);

/// One row of an arm's table. The joint turns the link about the link's own z axis.
struct Link {
  Eigen::Vector3d offset;    ///< from the parent's origin to this one, parent axes [m]
  Eigen::Matrix3d rotation;  ///< this link's axes at joint angle zero, in parent axes
  RigidBody body;
};

/// A Link by its numbers, in the order in which robot descriptions give them.
/// @param roll     fixed rotation about the parent's x axis, after the offset [rad]
/// @param inertia  Ixx Iyy Izz Ixy Ixz Iyz about the centre of mass, link axes [kg m^2]
Link link(const Eigen::Vector3d& offset, double roll, double mass, const Eigen::Vector3d& com,
          const std::array<double, 6>& inertia);

/// Flange pose and Jacobian.
template <int Dofs>
struct Kinematics {
  Eigen::Vector3d position;         ///< p, flange origin, world axes [m]
  Eigen::Matrix3d rotation;         ///< R, flange axes to world axes
  Jacobian<double, Dofs> jacobian;  ///< J at the flange origin, world axes, linear rows first
};

/// The terms of M(q) ddq + C(q, dq) dq + g(q) = tau + tau_ext.
template <int Dofs>
struct Dynamics {
  JointMatrix<double, Dofs> mass_matrix;         ///< M [kg m^2]
  JointVector<double, Dofs> coriolis;            ///< C dq [N m]
  JointVector<double, Dofs> coriolis_transpose;  ///< C^T dq [N m], for C with dM/dt = C + C^T
  JointVector<double, Dofs> gravity;             ///< g [N m]
};

/// An arm: the table and what follows from it. Nothing here allocates.
template <int Dofs>
struct ArmModel {
  using Vector = JointVector<double, Dofs>;

  std::string name;
  std::array<Link, Dofs> links;  ///< from the base
  Eigen::Vector3d flange;        ///< flange origin in the last link's axes [m]
  /// Flange axes to the last link's axes.
  Eigen::Matrix3d flange_rotation = Eigen::Matrix3d::Identity();
  Vector ready;            ///< a pose well inside the limits [rad]
  Vector q_min, q_max;     ///< [rad]; infinite for a joint that turns on and on
  Vector dq_max;           ///< [rad/s]
  Vector ddq_max;          ///< [rad/s^2]
  Vector tau_max;          ///< [N m]
  Vector dtau_max;         ///< [N m/s]
  Vector typical_coulomb;  ///< Coulomb friction to expect of such joints [N m]
  Vector typical_viscous;  ///< viscous friction to expect of such joints [N m s/rad]
  Vector typical_noise;    ///< torque sensors: standard deviation of the white noise [N m]
  Vector typical_offset;   ///< torque sensors: standard deviation of the constant offset [N m]
  Eigen::Vector3d gravity_vector = standard_gravity<double>();  ///< world axes [m/s^2]

  /// Pose and Jacobian of the flange.
  Kinematics<Dofs> kinematics(const Vector& q) const noexcept;
  /// All terms of the equation of motion, with `payload` (flange axes) welded to the flange.
  Dynamics<Dofs> dynamics(const Vector& q, const Vector& dq, const RigidBody& payload = {}) const noexcept;
  /// Kinetic plus potential energy; the potential is zero with all mass at the world origin [J].
  double energy(const Vector& q, const Vector& dq, const RigidBody& payload = {}) const noexcept;

 private:
  // One entry for each link. Columns of a matrix would be of another type for each number of joints, for all of which
  // the compiler would have to work through the same algebra again.
  struct Frames {
    Eigen::Vector3d origin[Dofs], axis[Dofs];  // o_i and z_i
    Eigen::Matrix3d rotation[Dofs];            // link axes to world axes
  };
  // A body's inertia about the world origin: mass, mass times centre, second moment.
  struct Inertia {
    double mass;
    Eigen::Vector3d moment;
    Eigen::Matrix3d tensor;
  };

  Frames frames(const Vector& q) const noexcept;
  Inertia inertia(const Frames& at, int i, const RigidBody& payload) const noexcept;
};

template <int Dofs>
auto ArmModel<Dofs>::frames(const Vector& q) const noexcept -> Frames {
  Frames at;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  for (int i = 0; i < Dofs; ++i) {
    const Link& l = links[static_cast<std::size_t>(i)];
    origin += R * l.offset;
    R = R * l.rotation;
    const double c = std::cos(q[i]), s = std::sin(q[i]);
    const Eigen::Vector3d x = c * R.col(0) + s * R.col(1);
    R.col(1) = c * R.col(1) - s * R.col(0);
    R.col(0) = x;
    at.origin[i] = origin;
    at.axis[i] = R.col(2);
    at.rotation[i] = R;
  }
  return at;
}

template <int Dofs>
Kinematics<Dofs> ArmModel<Dofs>::kinematics(const Vector& q) const noexcept {
  const Frames at = frames(q);
  Kinematics<Dofs> out;
  out.rotation = at.rotation[Dofs - 1] * flange_rotation;
  out.position = at.origin[Dofs - 1] + at.rotation[Dofs - 1] * flange;
  for (int i = 0; i < Dofs; ++i)
    rme::detail::column(out.jacobian, i) =
        rme::detail::stacked<double>(at.axis[i].cross(out.position - at.origin[i]), at.axis[i]);
  return out;
}

template <int Dofs>
auto ArmModel<Dofs>::inertia(const Frames& at, int i, const RigidBody& payload) const noexcept -> Inertia {
  RigidBody body = links[static_cast<std::size_t>(i)].body;
  if (i + 1 == Dofs && payload.mass > 0) body = body + moved(payload, flange, flange_rotation);
  const Eigen::Matrix3d& R = at.rotation[i];
  const Eigen::Vector3d c = at.origin[i] + R * body.com;
  Inertia out{body.mass, body.mass * c, R * body.inertia * R.transpose() - out.moment * c.transpose()};
  out.tensor.diagonal().array() += out.moment.dot(c);
  return out;
}

template <int Dofs>
Dynamics<Dofs> ArmModel<Dofs>::dynamics(const Vector& q, const Vector& dq, const RigidBody& payload) const noexcept {
  const Frames at = frames(q);
  Eigen::Vector3d slide[Dofs];  // linear part of S_i: velocity at the world origin of a body that turns about joint i
  for (int i = 0; i < Dofs; ++i) slide[i] = at.origin[i].cross(at.axis[i]);

  // Outwards: velocity (v, w) and velocity-product acceleration (a, b) of each link, and from them each body's
  // momentum and the force that this acceleration takes.
  Inertia composite[Dofs];
  Eigen::Vector3d linear_velocity[Dofs], angular_velocity[Dofs], momentum[Dofs], angular_momentum[Dofs], force[Dofs],
      moment[Dofs];
  Eigen::Vector3d v = Eigen::Vector3d::Zero(), w = v, a = v, b = v;
  for (int i = 0; i < Dofs; ++i) {
    const Eigen::Vector3d v_joint = slide[i] * dq[i], w_joint = at.axis[i] * dq[i];
    v += v_joint;
    w += w_joint;
    a += w.cross(v_joint) + v.cross(w_joint);
    b += w.cross(w_joint);
    linear_velocity[i] = v;
    angular_velocity[i] = w;
    const Inertia& I = composite[i] = inertia(at, i, payload);
    const Eigen::Vector3d h = I.mass * v - I.moment.cross(w), l = I.moment.cross(v) + I.tensor * w;
    momentum[i] = h;
    angular_momentum[i] = l;
    force[i] = I.mass * a - I.moment.cross(b) + w.cross(h);
    moment[i] = I.moment.cross(a) + I.tensor * b + v.cross(h) + w.cross(l);
  }

  // Inwards: everything becomes the sum over the links that joint i carries.
  Dynamics<Dofs> out;
  for (int i = Dofs - 1; i >= 0; --i) {
    const Inertia& I = composite[i];
    const Eigen::Vector3d z = at.axis[i], s = slide[i];
    const Eigen::Vector3d f = I.mass * s - I.moment.cross(z), n = I.moment.cross(s) + I.tensor * z;
    for (int j = 0; j <= i; ++j) out.mass_matrix(i, j) = out.mass_matrix(j, i) = slide[j].dot(f) + at.axis[j].dot(n);
    out.coriolis[i] = s.dot(force[i]) + z.dot(moment[i]);
    out.gravity[i] = -I.mass * s.dot(gravity_vector) - z.dot(I.moment.cross(gravity_vector));
    // p_i = S_i . (momentum carried), so dM/dt dq = dS_i/dt . momentum + S_i . force, and the last term is C dq.
    // With dM/dt = C + C^T what remains is C^T dq = dS_i/dt . momentum, where dS_i/dt = (v, w) x S_i.
    const Eigen::Vector3d v_i = linear_velocity[i], w_i = angular_velocity[i];
    out.coriolis_transpose[i] = (w_i.cross(s) + v_i.cross(z)).dot(momentum[i]) + w_i.cross(z).dot(angular_momentum[i]);
    if (i == 0) break;
    Inertia& parent = composite[i - 1];
    parent.mass += I.mass;
    parent.moment += I.moment;
    parent.tensor += I.tensor;
    momentum[i - 1] += momentum[i];
    angular_momentum[i - 1] += angular_momentum[i];
    force[i - 1] += force[i];
    moment[i - 1] += moment[i];
  }
  return out;
}

template <int Dofs>
double ArmModel<Dofs>::energy(const Vector& q, const Vector& dq, const RigidBody& payload) const noexcept {
  const Frames at = frames(q);
  double potential = 0;
  for (int i = 0; i < Dofs; ++i) potential -= inertia(at, i, payload).moment.dot(gravity_vector);
  const Vector momentum = rme::detail::product(dynamics(q, dq, payload).mass_matrix, dq);
  return 0.5 * dq.dot(momentum) + potential;
}

// Compiled once, in seven_joints.cpp and other_joints.cpp; an arm of another number of joints compiles where it is used.
extern template struct ArmModel<4>;
extern template struct ArmModel<5>;
extern template struct ArmModel<6>;
extern template struct ArmModel<7>;
extern template struct ArmModel<8>;

}  // namespace rme::examples
