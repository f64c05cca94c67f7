// External wrench from joint torques: rme's momentum observer and pseudo-wrench against Orocos KDL's
// ChainExternalWrenchEstimator, on the same Panda and the same samples. KDL computes the arm's model itself, so that
// rme's side has the host's model in it as well; its own share is a row for itself.
#include <cmath>
#include <cstdio>
#include <rivals/kdl_wrench.hpp>
#include <rme/sensing/momentum_observer.hpp>
#include <rme/sensing/pseudo_wrench.hpp>
#include <synthetic_arm/panda.hpp>
#include <vector>

#include "benchmarks/stopwatch.hpp"

namespace {

using Vector = rme::JointVector<double, 7>;

KDL::JntArray array(const Vector& v) {
  KDL::JntArray out(7);
  out.data = v;
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t runs = rme::benchmarks::quick(argc, argv) ? 10 : 20000;
  const auto& model = rme::examples::panda();
  constexpr double period = 1e-3, gain = 50;
  // A slow swing about the ready pose under a constant wrench.
  rme::Vector6<double> pull;
  pull << 3, -2, -9, 0.3, 0.2, -0.1;
  std::vector<Vector> q, dq, tau;
  for (int k = 0; k < 1000; ++k) {
    const double t = period * k;
    q.push_back(model.ready + 0.1 * std::sin(t) * Vector::Ones());
    dq.push_back(0.1 * std::cos(t) * Vector::Ones());
    const Vector ddq = -0.1 * std::sin(t) * Vector::Ones();
    const auto dynamics = model.dynamics(q.back(), dq.back());
    tau.push_back(dynamics.mass_matrix * ddq + dynamics.coriolis + dynamics.gravity -
                  model.kinematics(q.back()).jacobian.transpose() * pull);
  }
  std::vector<KDL::JntArray> kdl_q, kdl_dq, kdl_tau;
  for (std::size_t k = 0; k < q.size(); ++k) {
    kdl_q.push_back(array(q[k]));
    kdl_dq.push_back(array(dq[k]));
    kdl_tau.push_back(array(tau[k]));
  }
  rme::MomentumObserverConfig<double, 7> config;
  config.gain.setConstant(gain);
  rme::MomentumObserver<double, 7> observer(period, config);
  rme::Wrench<double> wrench;
  const auto ours = [&](std::size_t i) {
    const std::size_t k = i % q.size();
    const auto kinematics = model.kinematics(q[k]);
    const auto dynamics = model.dynamics(q[k], dq[k]);
    (void)observer.update(tau[k], dq[k], dynamics.mass_matrix, dynamics.coriolis_transpose, dynamics.gravity);
    (void)rme::pseudo_wrench(kinematics.jacobian, observer.tau_ext(), 1e-6, wrench);
    rme::benchmarks::keep(wrench);
  };
  const KDL::Chain arm = rme::examples::kdl_chain(model);
  KDL::ChainExternalWrenchEstimator estimator(arm, rme::examples::kdl_vector(model.gravity_vector), 1 / period, gain,
                                              0);
  estimator.setInitialMomentum(kdl_q[0], kdl_dq[0]);
  KDL::Wrench kdl_wrench;
  const auto theirs = [&](std::size_t i) {
    const std::size_t k = i % q.size();
    estimator.JntToExtWrench(kdl_q[k], kdl_dq[k], kdl_tau[k], kdl_wrench);
    rme::benchmarks::keep(kdl_wrench);
  };

  for (std::size_t k = 0; k < q.size(); ++k) {
    ours(k);
    theirs(k);
  }
  const Eigen::Matrix3d R = model.kinematics(q.back()).rotation;
  const Eigen::Vector3d force(kdl_wrench.force.x(), kdl_wrench.force.y(), kdl_wrench.force.z());
  const Eigen::Vector3d moment(kdl_wrench.torque.x(), kdl_wrench.torque.y(), kdl_wrench.torque.z());
  const double our_error = (wrench.vector() - pull).norm();
  const double their_error = std::hypot((R * force - pull.head<3>()).norm(), (R * moment - pull.tail<3>()).norm());

  rme::benchmarks::print_head("External wrench from joint torques, 7 joints");
  const auto at = model.kinematics(q[0]);
  const auto dynamics = model.dynamics(q[0], dq[0]);
  rme::benchmarks::measure("MomentumObserver and pseudo_wrench, model given", runs, 10, [&](std::size_t i) {
    (void)observer.update(tau[i % q.size()], dq[0], dynamics.mass_matrix, dynamics.coriolis_transpose,
                          dynamics.gravity);
    (void)rme::pseudo_wrench(at.jacobian, observer.tau_ext(), 1e-6, wrench);
    rme::benchmarks::keep(wrench);
  });
  rme::benchmarks::measure("the same and the arm's model (examples/synthetic_arm)", runs, 1, ours);
  rme::benchmarks::measure("KDL::ChainExternalWrenchEstimator", runs, 1, theirs);
  std::printf("\nafter a second, off the true wrench (%.2f): rme %.4f, KDL %.4f\n", pull.norm(), our_error,
              their_error);
}
