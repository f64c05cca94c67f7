// The core without exceptions and run-time types, in float and double, or in RME_SMOKE_SCALAR alone. Ends with 0 if it
// still computes what it should.
#include <cmath>

#include "core.hpp"  // generated: every header but the JSON ones

namespace {

template <typename Scalar>
bool kilogram_weighs_9_81_newton() {
  const rme::Payload<Scalar> payload{Scalar(1), {Scalar(0.1), Scalar(0), Scalar(0)}};
  const rme::Wrench<Scalar> w = rme::payload_wrench<Scalar>(payload, rme::Matrix3<Scalar>::Identity());
  return w.force.z() == Scalar(-9.81) && std::abs(w.moment.y() - Scalar(0.981)) < Scalar(1e-6);
}

template <typename Scalar>
bool ring_keeps_the_newest() {
  rme::RingBuffer<Scalar> ring(2);
  for (int k = 0; k < 3; ++k) ring.push(Scalar(k));
  return ring[0] == Scalar(1) && ring[1] == Scalar(2);
}

/// A six-joint arm at rest with J = I, so that its joint torques are the wrench on its flange, is handed 1 kg after 1
/// s.
template <typename Scalar>
bool estimator_weighs_a_kilogram() {
  rme::Estimator<Scalar, 6> estimator(0.001);
  rme::Proprioception<Scalar, 6> sample;
  sample.jacobian.setIdentity();
  const rme::Vector6<Scalar> w =
      rme::payload_wrench<Scalar>({Scalar(1), {Scalar(0), Scalar(0), Scalar(0.1)}}, sample.rotation).vector();
  const auto blend = Scalar(0.05);  // of a momentum observer at 50 rad/s, over 1 ms
  for (int tick = 0; tick < 2000; ++tick) {
    if (tick >= 1000) sample.tau_ext += blend * (w - sample.tau_ext);
    if (estimator.update(sample) != rme::Status::Ok) return false;
  }
  return std::abs(estimator.state().payload.mean[0] - Scalar(1)) < Scalar(0.02);
}

/// J = I and M = I, so that ddq = tau - h: the passive law asks for 30 N along x (60 N s/m times 0.5 m/s), a row allows
/// half of it.
template <typename Scalar>
bool constraint_holds_back_the_passive_law() {
  rme::PassiveController<Scalar> passive;
  rme::Flow<Scalar> flow;
  flow.velocity.x() = Scalar(0.5);
  if (passive.update(flow, rme::Flow<Scalar>(), rme::Twist<Scalar>()) != rme::Status::Ok) return false;
  rme::CpicConfig<Scalar, 6> config;
  config.torque_limit.setConstant(Scalar(87));
  rme::Cpic<Scalar, 6> cpic(config);
  rme::CpicInput<Scalar, 6> input;
  input.jacobian.setIdentity();
  input.mass_matrix.setIdentity();
  input.bias.setZero();
  input.wrench = passive.wrench();
  typename rme::Cpic<Scalar, 6>::Rows rows;
  if (cpic.update(input, rows) != rme::Status::Ok || std::abs(cpic.torque()[0] - Scalar(30)) > Scalar(1e-4))
    return false;
  if (rows.add_axis(0, -rows.kFree, Scalar(15)) != rme::Status::Ok) return false;
  return cpic.update(input, rows) == rme::Status::Ok && std::abs(cpic.torque()[0] - Scalar(15)) < Scalar(1e-4) &&
         cpic.multiplier(0) < 0;
}

template <typename Scalar>
bool all() {
  return kilogram_weighs_9_81_newton<Scalar>() && ring_keeps_the_newest<Scalar>() &&
         estimator_weighs_a_kilogram<Scalar>() && constraint_holds_back_the_passive_law<Scalar>();
}

}  // namespace

int main() {
#ifdef RME_SMOKE_SCALAR
  return all<RME_SMOKE_SCALAR>() ? 0 : 1;
#else
  return all<float>() && all<double>() ? 0 : 1;
#endif
}
