#include "support/random_events.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

namespace rme::testing {

Eigen::Vector3d gaussian3(std::mt19937_64& random) {
  std::normal_distribution<double> n;
  return {n(random), n(random), n(random)};
}

Pose random_pose(std::mt19937_64& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  Pose pose;
  for (int j = 0; j < kDofs; ++j) {
    const Eigen::Vector3d axis = gaussian3(random).normalized();
    const Eigen::Vector3d lever = 0.4 * Eigen::Vector3d(u(random), u(random), u(random));
    pose.jacobian.col(j) << axis.cross(lever), axis;
  }
  pose.rotation = Eigen::AngleAxisd(3.0 * u(random), gaussian3(random).normalized()).toRotationMatrix();
  return pose;
}

Event random_event(std::mt19937_64& random, int samples, bool friction) {
  std::normal_distribution<double> n;
  std::uniform_real_distribution<double> u(-1, 1);
  Event event;
  event.truth << 1.1 + 0.9 * u(random), 0.08 * u(random), 0.08 * u(random), 0.1 + 0.1 * u(random);
  const Payload<double> payload = Payload<double>::from_vector(event.truth);
  const auto [J, R0] = random_pose(random);
  const Eigen::Vector3d swing = 0.2 * gaussian3(random);
  JointVector<double, kDofs> noise, beta_offset, beta_coulomb, beta_viscous;
  for (int j = 0; j < kDofs; ++j) {
    noise[j] = j < 4 ? 0.05 : 0.03;
    const double offset = j < 4 ? 0.1 : 0.05, coulomb = j < 4 ? 0.1 : 0.05, viscous = 0.05;
    JointFaults& faults = event.faults[static_cast<std::size_t>(j)];
    faults.N.resize(samples, 3);
    faults.mean << 0, friction ? 2 * coulomb : 0, friction ? viscous : 0;
    faults.covariance = Eigen::Vector3d(offset * offset, coulomb * coulomb, viscous * viscous).asDiagonal();
    beta_offset[j] = offset * n(random);
    beta_coulomb[j] = faults.mean[1] + coulomb * n(random);
    beta_viscous[j] = faults.mean[2] + viscous * n(random);
    event.precision[j] = 1 / (noise[j] * noise[j]);
  }
  for (int k = 0; k < samples; ++k) {
    const double time = 0.004 * k;
    PayloadObservation<double, kDofs> o;
    const Eigen::Matrix3d R = Eigen::AngleAxisd(swing.norm() * time, swing.normalized()).toRotationMatrix() * R0;
    o.regressor = payload_regressor<double, kDofs>(J, R, standard_gravity<double>());
    o.tau = o.regressor.torque(payload) + beta_offset;
    for (int j = 0; j < kDofs; ++j) {
      const double velocity = friction ? 0.1 * std::sin(3 * time + j) : 0;
      const double direction = velocity > 0 ? 1 : velocity < 0 ? -1 : 0;
      o.tau[j] -= beta_coulomb[j] * direction + beta_viscous[j] * velocity;
      event.faults[static_cast<std::size_t>(j)].N.row(k) << 1, -direction, -velocity;
    }
    for (int j = 0; j < kDofs; ++j) o.tau[j] += noise[j] * n(random);
    event.statistics.add(o);
    event.samples.push_back(o);
  }
  return event;
}

PayloadLikelihood<double> likelihood_of(const Event& event, const JointVector<double, kDofs>& precision) {
  const auto T = static_cast<Eigen::Index>(event.samples.size());
  Eigen::Matrix<double, 5, 5> products = Eigen::Matrix<double, 5, 5>::Zero();
  for (int j = 0; j < kDofs; ++j) {
    const auto& [N, mean, covariance] = event.faults[static_cast<std::size_t>(j)];
    Eigen::Matrix<double, Eigen::Dynamic, 5> z(T, 5);
    for (Eigen::Index t = 0; t < T; ++t) {
      const auto& o = event.samples[static_cast<std::size_t>(t)];
      z.row(t) << o.tau[j], o.regressor.a[j], o.regressor.B.row(j);
    }
    z.col(0) -= N * mean;
    const Eigen::MatrixXd noise = Eigen::MatrixXd::Identity(T, T) / precision[j] + N * covariance * N.transpose();
    products += z.transpose() * noise.llt().solve(z);
  }
  return PayloadLikelihood<double>::from_products(0.5 * (products + products.transpose()));
}

PayloadLikelihood<double> likelihood_of(const Event& event) {
  return likelihood_of(event, event.precision);
}

PayloadGaussian<double> wide_prior() {
  return PayloadGaussian<double>::independent({0.8, 0, 0, 0.1}, {0.6, 0.05, 0.05, 0.06});
}

}  // namespace rme::testing
