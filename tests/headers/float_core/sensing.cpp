#include <cmath>
#include <rme/rme.hpp>
#include <rme/sensing/mismatch_detector.hpp>
#include <rme/sensing/pseudo_wrench.hpp>

#include "headers/float_core/float_core.hpp"

namespace float_core {
namespace {

bool detector_sees_a_step_when_it_has_settled() {
  rme::MismatchDetector<7> detector(1e-3);
  rme::MismatchDetector<7>::Signal signal = rme::MismatchDetector<7>::Signal::Zero();
  // The oldest of the means that have to agree spans ages 210 to 229. Of the old level one sample in 20 may still be in
  // it, which makes 0.15 of the 0.2 N m allowed, but not two.
  for (int k = 0; k < 1000; ++k) {
    if (k == 700) signal[1] = 3;
    if (detector.update(signal) != Status::Ok || detector.detected() != (k >= 928)) return false;
  }
  signal[3] = kNan;
  return detector.update(signal) == Status::NonFiniteInput && detector.detected();
}

bool observer_shows_a_step_through_its_filter() {
  rme::MomentumObserver<float, 7> observer(kPeriod);
  const Vector7 zero = Vector7::Zero();
  Vector7 dq = zero;
  for (int k = 0; k <= 100; ++k, dq[2] += 3 * kPeriod) {  // 3 N m on a joint of 1 kg m^2
    if (observer.update(zero, dq, rme::JointMatrix<float, 7>::Identity(), zero, zero) != Status::Ok) return false;
    if (!near(observer.tau_ext()[2], 3 * (1 - std::pow(0.95, k)), 2e-3)) return false;
  }
  return true;
}

bool pseudo_wrench_is_the_wrench_that_made_the_torque() {
  Random random(1);
  for (int k = 0; k < 200; ++k) {
    const Jacobian7 J = gaussian<Jacobian7>(random);
    const Vector6 wrench = gaussian<Vector6>(random, 10);
    rme::Wrench<float> w;
    if (rme::pseudo_wrench(J, J.transpose() * wrench, 1e-4F, w) != Status::Ok) return false;
    // W = (1 + lambda (J J^T)^-1)^-1 w, so that the torque left over is no more than sqrt(lambda) / 2 |w|.
    if (!near(J.transpose() * w.vector(), J.transpose() * wrench, 0.006 * wrench.norm())) return false;
  }
  return true;
}

bool bad_samples_are_named() {
  rme::Proprioception<float, 7> sample;
  if (check_sample(sample) != Status::Ok) return false;
  sample.rotation *= 1.01F;
  if (check_sample(sample) != Status::NotARotation) return false;
  sample = {};
  sample.jacobian(2, 3) = 1e30F;
  if (check_sample(sample) != Status::NonFiniteInput) return false;
  sample = {};
  sample.dq[6] = kNan;
  return check_sample(sample) == Status::NonFiniteInput;
}

}  // namespace

const std::vector<Case> kSensing = {
    {"MismatchDetector: sees a step once it has settled", detector_sees_a_step_when_it_has_settled},
    {"MomentumObserver: a step through its filter", observer_shows_a_step_through_its_filter},
    {"pseudo_wrench: the wrench that made the torque", pseudo_wrench_is_the_wrench_that_made_the_torque},
    {"check: bad samples are named", bad_samples_are_named},
};

}  // namespace float_core
