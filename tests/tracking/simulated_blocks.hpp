#pragma once
/// Blocks that a tracker might see of a Panda: drawn from the tracker's own model, without any physics.
#include <cmath>
#include <cstdint>
#include <random>
#include <rme/tracking/tracker.hpp>
#include <synthetic_arm/panda.hpp>

namespace rme::testing {

/// A simulated Panda that swings about a pose, and a tracker that knows its kind of torque sensing. Torques have
/// offsets, white noise and, if the kind shows it, friction, and errors of a rough model.
template <typename Scalar>
class SimulatedBlocks {
 public:
  using Joints = JointVector<double, 7>;
  static constexpr double kRated = 3, kBlock = 0.02;

  SimulatedBlocks(std::uint64_t seed, Sensing sensing, const Joints& pose = examples::panda().ready)
      : tracker(ArmPrior<Scalar, 7>::of(Scalar(kRated)), PayloadPrior<Scalar>::of(Scalar(kRated)), Scalar(kRated),
                sensing, Vector3<Scalar>(0, 0, Scalar(-9.81))),
        random_(seed),
        sensing_(sensing),
        pose_(pose) {
    for (int j = 0; j < 7; ++j) offset_[j] = arm_.offset[j] * normal_(random_);
  }

  /// Something of this mass, with its centre of mass at (2, -1, 10) cm.
  void hold(double mass) {
    const Eigen::Matrix3d about_com = 0.003 * mass * Eigen::Matrix3d::Identity();
    phi = InertialParameters<double>::of_body({mass, {0.02, -0.01, 0.1}}, about_com).vector();
  }
  /// No torque shows now: the sensors were zeroed so, or friction of a rough arm holds the joints.
  void zero() {
    const auto now = at(time_);
    const Joints load = now.jacobian.transpose() *
                        inertial_wrench_regressor<double>(now.rotation, gravity_, FlangeMotion<double>()) * phi;
    (sensing_ == Sensing::RoughModel ? held_ : offset_) = -load;
  }
  /// `blocks` blocks of 20 ms. While `pours` [kg/s] the payload grows; a `swing` [rad] fades in.
  void live(int blocks) {
    for (; blocks > 0; --blocks) {
      if (pours != 0) hold(phi[0] + pours * kBlock);
      tracker.begin(next(), false);
      while (!tracker.advance()) {
      }
    }
  }
  TorqueBlock<Scalar, 7> next() {
    TorqueBlock<Scalar, 7> block;
    const Joints shaken = jolt;
    Joints tau = offset_ + shaken, velocity = Joints::Zero();
    size_ += 0.05 * (swing - size_);
    if (swing == 0 && size_ < 0.01) size_ = 0;
    for (int i = 0; i < kBlockParts; ++i) {
      time_ += kBlock / kBlockParts;
      const auto now = at(time_);
      velocity += now.dq / kBlockParts;
      block.velocities.col(i) = now.dq.template cast<Scalar>();
    }
    const auto middle = at(time_ - 0.5 * kBlock);
    constexpr double h = 1e-4;
    const auto before = at(time_ - 0.5 * kBlock - h), after = at(time_ - 0.5 * kBlock + h);
    const Vector6<double> acceleration = (after.twist - before.twist) / (2 * h);
    const FlangeMotion<double> motion{middle.twist.template tail<3>(), acceleration.template tail<3>(),
                                      acceleration.template head<3>()};
    const Eigen::Matrix<double, 7, kInertial> regressor =
        middle.jacobian.transpose() * inertial_wrench_regressor<double>(middle.rotation, gravity_, motion);
    tau += regressor * (phi + tool) + middle.jacobian.transpose() * wrench;
    for (int j = 0; j < 7; ++j) {
      if (sensing_ != Sensing::LinkSide)
        for (int i = 0; i < kBlockParts; ++i) {
          const double v = double(block.velocities(j, i));
          if (v != 0) held_[j] = -arm_.coulomb[j] * (v > 0 ? 1 : -1);
          tau[j] += (v != 0 ? held_[j] : 0.95 * held_[j]) / kBlockParts - arm_.viscous[j] * v / kBlockParts;
        }
      if (sensing_ == Sensing::RoughModel) tau[j] += 0.8 * arm_.residual[j] * std::sin(4 * middle.q[j] + 1.7 * j);
      tau[j] += 0.6 * arm_.noise[j] * normal_(random_);
    }
    block.end = time_;
    block.duration = Scalar(kBlock);
    block.samples = 20;
    block.tau = tau.cast<Scalar>();
    block.torque_rate.setZero();
    block.regressor = regressor.cast<Scalar>();
    block.jacobian = middle.jacobian.template cast<Scalar>();
    block.rotation = middle.rotation.template cast<Scalar>();
    block.velocity = velocity.cast<Scalar>();
    block.torque_step.setZero();
    block.velocity_noise.setZero();
    return block;
  }

  double probability(Mode mode) const { return double(tracker.belief().probability[mode]); }
  double empty() const { return double(tracker.belief().empty); }
  double mass() const { return double(tracker.belief().payload.mean[0]); }
  double deviation() const { return std::sqrt(double(tracker.belief().payload.covariance(0, 0))); }
  double gaussian() { return normal_(random_); }

  InertialVector<double> phi = InertialVector<double>::Zero(), tool = phi;  ///< of the payload; of what nobody knows
  Vector6<double> wrench = Vector6<double>::Zero();                         ///< of a hand that pushes
  Joints jolt = Joints::Zero();                                             ///< torque on single joints
  double swing = 0, pours = 0;
  Tracker<Scalar, 7> tracker;

 private:
  struct Moment {
    Joints q, dq;
    Jacobian<double, 7> jacobian;
    Eigen::Matrix3d rotation;
    Vector6<double> twist;
  };
  Moment at(double t) const {
    Moment m;
    Joints& q = m.q = pose_;
    m.dq.setZero();
    for (int j = 0; j < 7 && size_ > 0; ++j) {
      const double rate = 0.9 + 0.23 * j;
      q[j] += size_ * std::sin(rate * t + j);
      m.dq[j] = size_ * rate * std::cos(rate * t + j);
    }
    const auto kinematics = examples::panda().kinematics(q);
    m.jacobian = kinematics.jacobian;
    m.rotation = kinematics.rotation;
    m.twist = m.jacobian * m.dq;
    return m;
  }

  const Eigen::Vector3d gravity_{0, 0, -9.81};
  ArmPrior<double, 7> arm_ = ArmPrior<double, 7>::of(kRated);
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  Sensing sensing_;
  Joints pose_, offset_, held_ = Joints::Zero();
  double time_ = 0, size_ = 0;
};

}  // namespace rme::testing
