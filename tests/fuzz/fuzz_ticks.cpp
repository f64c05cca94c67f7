// Any bytes as what happens to an arm and its estimator: objects and pushes, and ticks in which numbers are replaced by
// any others, lost, repeated or frozen. Whatever happens, all that the estimator says is finite, the ramped torque
// keeps its rate, and a refused tick leaves it as a twin that has not seen it.
#include <cstdint>
#include <rme/core/compensation.hpp>
#include <rme/estimator.hpp>

#include "fuzz/bytes.hpp"
#include "fuzz/check.hpp"

namespace {

using fuzzing::Bytes;
using fuzzing::check;

constexpr double kPeriod = 0.01;  // slow, so that few bytes make an event

template <typename Scalar>
using Estimator = rme::Estimator<Scalar, 6>;

/// What else a host may call.
template <typename Scalar>
void call(Estimator<Scalar>& estimator, std::uint8_t which, double number) {
  if (which % 8 == 0) estimator.declare_empty();
  if (which % 4 == 1) estimator.in_contact(true);
  if (which % 4 == 2) estimator.in_contact(false);
  if (which % 4 != 3) return;
  rme::PayloadGaussian<Scalar> payload = rme::PayloadGaussian<Scalar>::independent(
      {1, 0, 0, Scalar(0.1)}, {Scalar(0.1), Scalar(0.05), Scalar(0.05), Scalar(0.05)});
  payload.mean[which / 4 % 4] = static_cast<Scalar>(number);
  (void)estimator.set_payload(payload);
}

template <typename Scalar>
void check_same(const Estimator<Scalar>& estimator, const Estimator<Scalar>& twin) {
  const rme::EstimatorState<Scalar>&a = estimator.state(), &b = twin.state();
  check(a.payload.mean.allFinite() && a.payload.covariance.allFinite() && std::isfinite(a.confidence));
  check(a.inertial.mean.allFinite() && a.inertial.covariance.allFinite() && std::isfinite(a.health));
  check(a.payload.mean[0] >= 0 && (a.payload.covariance.diagonal().array() >= 0).all());
  check(a.confidence >= 0 && a.confidence <= 1 && a.friction_shows() >= 0 && a.friction_shows() <= 1);
  Scalar sum = 0;
  for (const Scalar p : a.probability.values) {
    check(p >= 0);
    sum += p;
  }
  check(std::abs(sum - 1) < Scalar(1e-3));
  check(a.payload.mean == b.payload.mean && a.payload.covariance == b.payload.covariance);
  check(a.inertial.mean == b.inertial.mean && a.inertial.covariance == b.inertial.covariance);
  check(a.held >= 0 && a.held <= 1);
  check(a.held == b.held);
  check(a.probability.values == b.probability.values && a.time == b.time && a.updated == b.updated);
  check(a.event.number == b.event.number && a.event.kind == b.event.kind && a.changing == b.changing);
}

template <typename Scalar>
class Host {
 public:
  using Tick = rme::Proprioception<Scalar, 6>;

  Host() { good_.jacobian.setIdentity(); }

  void run(Bytes& bytes) {
    while (!bytes.empty()) {
      switch (bytes.byte() % 12) {
        case 0:
          ticks(bytes.byte());
          break;
        case 1:  // an object, or none
          load_ = rme::payload_wrench<Scalar>({Scalar(bytes.in(0, 3)), {Scalar(bytes.in(-0.1, 0.1)), 0, Scalar(0.1)}},
                                              good_.rotation)
                      .vector();
          break;
        case 2:  // a push
          for (int i = 0; i < 6; ++i) push_[i] = Scalar(bytes.in(-30, 30));
          break;
        case 3:
          push_.setZero();
          break;
        case 4: {  // one number of a tick replaced
          Tick tick = next();
          spoil(tick, bytes);
          feed(tick);
          break;
        }
        case 5:  // many ticks with the same number replaced
          frozen_entry_ = bytes.byte();
          frozen_value_ = bytes.number<Scalar>();
          frozen_left_ = bytes.byte();
          break;
        case 6: {  // all of it scaled
          Tick tick = next();
          const Scalar factor = bytes.number<Scalar>();
          tick.tau_ext *= factor;
          tick.jacobian *= factor;
          feed(tick);
          break;
        }
        case 7:
          for (int k = bytes.byte(); k > 0; --k) (void)next();  // lost
          break;
        case 8:
          for (auto* estimator : {&estimator_, &twin_}) estimator->expect_change();
          break;
        case 9: {
          const std::uint8_t which = bytes.byte();
          const auto number = bytes.number<double>();
          for (auto* estimator : {&estimator_, &twin_}) call(*estimator, which, number);
          break;
        }
        case 10:
          for (auto* estimator : {&estimator_, &twin_}) estimator->reset();
          break;
        default:
          good_.dq.setConstant(Scalar(bytes.in(-1, 1)));
      }
    }
  }

 private:
  Tick next() {
    good_.tau_ext += Scalar(0.4) * (load_ + push_ - good_.tau_ext);
    return good_;
  }
  void ticks(int count) {
    for (; count > 0; --count) {
      Tick tick = next();
      if (frozen_left_ > 0) {
        --frozen_left_;
        replace(tick, frozen_entry_, frozen_value_);
      }
      feed(tick);
    }
  }
  static void spoil(Tick& tick, Bytes& bytes) {
    const std::uint8_t beside = bytes.byte();
    if (beside % 4 == 0) tick.motion.emplace();
    if (beside % 16 == 2) tick.compensation.emplace().setConstant(bytes.number<Scalar>());
    if (beside % 16 == 3) tick.gravity_torque.emplace().setConstant(bytes.number<Scalar>());
    if (beside % 16 == 1) tick.period = bytes.number<double>();
    const std::uint8_t entry = bytes.byte();
    replace(tick, entry, bytes.number<Scalar>());
  }
  static void replace(Tick& tick, std::uint8_t entry, Scalar value) {
    const int i = entry % 72;
    if (i < 6)
      tick.tau_ext[i] = value;
    else if (i < 42)
      tick.jacobian.data()[i - 6] = value;
    else if (i < 51)
      tick.rotation.data()[i - 42] = value;
    else if (i < 57)
      tick.dq[i - 51] = value;
    else if (tick.motion && i < 60)
      tick.motion->angular_velocity[i - 57] = value;
    else if (tick.motion && i < 63)
      tick.motion->linear_acceleration[i - 60] = value;
    else if (tick.motion && i < 66)
      tick.motion->angular_acceleration[i - 63] = value;
  }

  void feed(const Tick& tick) {
    if (++fed_ > kMostTicks) return;
    check(estimator_.compensation(tick.jacobian, tick.rotation).allFinite());
    const rme::Status status = estimator_.update(tick);
    if (status == rme::Status::Ok || status == rme::Status::NotAMeasurement) check(twin_.update(tick) == status);
    check_same(estimator_, twin_);
    const auto before = ramp_.torque();
    check(ramp_.update(estimator_.compensation(tick.jacobian, tick.rotation)) == rme::Status::Ok);
    check((ramp_.torque() - before).cwiseAbs().maxCoeff() <= Scalar(5.001));
  }

  Tick good_;
  rme::Vector6<Scalar> load_ = rme::Vector6<Scalar>::Zero(), push_ = rme::Vector6<Scalar>::Zero();
  std::uint8_t frozen_entry_ = 0;
  Scalar frozen_value_ = 0;
  int frozen_left_ = 0;
  static constexpr int kMostTicks = 600;  // two or three events
  int fed_ = 0;
  Estimator<Scalar> estimator_{kPeriod}, twin_ = estimator_;
  rme::CompensationRamp<Scalar, 6> ramp_{Scalar(kPeriod)};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  if (bytes.byte() % 2 == 0)
    Host<double>().run(bytes);
  else
    Host<float>().run(bytes);
  return 0;
}
