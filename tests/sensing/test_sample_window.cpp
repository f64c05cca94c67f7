#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>
#include <rme/sensing/sample_window.hpp>
#include <stdexcept>

#include "support/catch.hpp"

namespace {

using rme::SampleWindow;
using rme::SampleWindowConfig;
using rme::Status;
template <int Dofs>
using Sample = rme::Proprioception<double, Dofs>;

Sample<2> sample_of(double tau, double dq = 0) {
  Sample<2> sample;
  sample.tau_ext << tau, -2 * tau;
  sample.dq << dq, -dq;
  return sample;
}

TEST_CASE("SampleWindow: what a first-order observer filters comes back exactly, whatever its gain and the rate",
          "[sample_window]") {
  const unsigned seed = 60;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  for (const double gain : {10.0, 50.0, 250.0}) {
    for (const double dt : {1e-3, 4e-3}) {
      CAPTURE(gain, dt);
      SampleWindowConfig config;
      config.observer_bandwidth = gain;
      SampleWindow<double, 2> window(dt, config);
      Sample<2> filtered;  // the observer starts at zero
      REQUIRE(window.push(filtered) == Status::Ok);
      for (int k = 0; k < 1000; ++k) {
        const Eigen::Vector2d u(3 * n(random), 5 + n(random));
        filtered.tau_ext += gain * dt * (u - filtered.tau_ext);
        REQUIRE(window.push(filtered) == Status::Ok);
        // Numbers of 10 with 1e-16 of rounding, divided by K dt >= 0.01.
        REQUIRE((window.newest().tau - u).cwiseAbs().maxCoeff() < 1e-12);
        REQUIRE(window.newest().raw.tau_ext == filtered.tau_ext);
      }
    }
  }
}

TEST_CASE("SampleWindow: torque that no observer has filtered stays what it is", "[sample_window]") {
  SampleWindowConfig config;
  config.observer_bandwidth = 0;
  SampleWindow<double, 2> window(1e-3, config);
  for (const double tau : {0.0, 5.0, -1.0}) {
    REQUIRE(window.push(sample_of(tau)) == Status::Ok);
    CHECK(window.newest().tau == Eigen::Vector2d(tau, -2 * tau));
  }
}

TEST_CASE("SampleWindow: a flange that turns about an axis is pulled towards it with l omega^2", "[sample_window]") {
  // One joint about world z at the origin, the flange at p = l (cos q, sin q, 0): J = (z x p ; z). At constant speed w
  // the velocity's change over a period is exactly -w^2 p(middle of the period) sinc(w dt / 2), whose sinc is 1 within
  // (w dt)^2 / 24. With q = a t^2 / 2 the angular acceleration is a exactly.
  const double dt = 1e-3, l = 0.6, w = 2, a = 3;
  const auto at = [&](double q, double dq) {
    Sample<1> sample;
    sample.jacobian << -l * std::sin(q), l * std::cos(q), 0, 0, 0, 1;
    sample.rotation = Eigen::AngleAxisd(q, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    sample.dq << dq;
    return sample;
  };
  SampleWindow<double, 1> even(dt), speeding_up(dt);
  for (int k = 0; k < 500; ++k) {
    const double t = k * dt;
    REQUIRE(even.push(at(w * t, w)) == Status::Ok);
    REQUIRE(speeding_up.push(at(a * t * t / 2, a * t)) == Status::Ok);
    if (k == 0) {  // nothing is known of the time before: taken as no acceleration
      CHECK(even.newest().motion.linear_acceleration == Eigen::Vector3d::Zero());
      CHECK(even.newest().motion.angular_acceleration == Eigen::Vector3d::Zero());
      continue;
    }
    const auto& motion = even.newest().motion;
    const double middle = w * (t - dt / 2);
    const Eigen::Vector3d expected = -w * w * l * Eigen::Vector3d(std::cos(middle), std::sin(middle), 0);
    REQUIRE((motion.linear_acceleration - expected).norm() < w * w * l * (w * dt) * (w * dt) / 24 + 1e-12);
    REQUIRE(motion.angular_acceleration.norm() < 1e-12);
    REQUIRE(motion.angular_velocity == Eigen::Vector3d(0, 0, w));
    REQUIRE((speeding_up.newest().motion.angular_acceleration - Eigen::Vector3d(0, 0, a)).norm() < 1e-9);
  }
}

TEST_CASE("SampleWindow: what the host says of the flange's motion is taken as it is", "[sample_window]") {
  SampleWindow<double, 2> window(1e-3);
  auto sample = sample_of(1, 0.5);
  REQUIRE(window.push(sample) == Status::Ok);
  sample.motion = rme::FlangeMotion<double>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  REQUIRE(window.push(sample) == Status::Ok);
  CHECK(window.newest().motion.angular_velocity == Eigen::Vector3d(1, 2, 3));
  CHECK(window.newest().motion.linear_acceleration == Eigen::Vector3d(4, 5, 6));
  CHECK(window.newest().motion.angular_acceleration == Eigen::Vector3d(7, 8, 9));
  for (int i = 0; i < 3; ++i) {
    auto bad = sample;
    (i == 0   ? bad.motion->angular_velocity
     : i == 1 ? bad.motion->linear_acceleration
              : bad.motion->angular_acceleration)[i] = std::nan("");
    CHECK(window.push(bad) == Status::NonFiniteInput);
  }
  CHECK(window.size() == 2);
}

TEST_CASE("SampleWindow: a joint at rest keeps the direction in which it moved last", "[sample_window]") {
  SampleWindow<double, 2> window(1e-3);  // rest is below 1e-3 rad/s
  struct Step {
    double dq, direction;
  };
  for (const auto& [dq, direction] :
       {Step{0, 0}, {0.0009, 0}, {0.0011, 1}, {0, 1}, {-0.0009, 1}, {-0.5, -1}, {0, -1}}) {
    CAPTURE(dq);
    REQUIRE(window.push(sample_of(0, dq)) == Status::Ok);
    CHECK(window.newest().direction == Eigen::Vector2d(direction, -direction));
  }
  window.reset();
  REQUIRE(window.push(sample_of(0)) == Status::Ok);
  CHECK(window.newest().direction == Eigen::Vector2d::Zero());
}

TEST_CASE("SampleWindow: the newest samples are kept, as many as the duration holds", "[sample_window]") {
  SampleWindowConfig config;
  config.duration = 0.01;
  SampleWindow<double, 2> window(1e-3, config);
  CHECK(window.capacity() == 10);
  for (int k = 0; k < 25; ++k) {
    REQUIRE(window.push(sample_of(k)) == Status::Ok);
    CHECK(window.size() == static_cast<std::size_t>(std::min(k + 1, 10)));
  }
  for (std::size_t age = 0; age < 10; ++age) CHECK(window.newest(age).raw.tau_ext[0] == 24 - static_cast<double>(age));
}

TEST_CASE("SampleWindow: a bad sample leaves no trace", "[sample_window]") {
  const double huge = std::numeric_limits<double>::max(), nan = std::numeric_limits<double>::quiet_NaN();
  SampleWindow<double, 2> window(1e-3), twin(1e-3);
  Sample<2> not_a_number = sample_of(1), mirror = sample_of(1), too_fast = sample_of(1);
  not_a_number.dq[1] = nan;
  mirror.rotation(2, 2) = -1;
  too_fast.jacobian.setOnes();
  too_fast.dq.setConstant(huge);
  for (int k = 0; k < 20; ++k) {
    const Sample<2> good = sample_of(0.1 * k * k, std::sin(k));
    REQUIRE(window.push(good) == Status::Ok);
    REQUIRE(twin.push(good) == Status::Ok);
    CHECK(window.push(not_a_number) == Status::NonFiniteInput);
    CHECK(window.push(mirror) == Status::NotARotation);
    CHECK(window.push(too_fast) == Status::NonFiniteInput);             // finite, though the flange's speed is not
    CHECK(window.push(sample_of(huge)) == Status::NonFiniteInput);      // finite, though -2 of it is not
    CHECK(window.push(sample_of(huge / 4)) == Status::NonFiniteInput);  // overflows once the lag is taken out
    CHECK(window.size() == twin.size());
    CHECK(window.newest().tau == twin.newest().tau);
    CHECK(window.newest().direction == twin.newest().direction);
    CHECK(window.newest().motion.linear_acceleration == twin.newest().motion.linear_acceleration);
  }
}

TEST_CASE("SampleWindow: a setting out of range is refused by name", "[sample_window]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto with = [](double SampleWindowConfig::*field, double value) {
    SampleWindowConfig config;
    config.*field = value;
    return SampleWindow<double, 2>(1e-3, config).capacity();
  };
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    CAPTURE(bad);
    CHECK_THROWS_WITH((SampleWindow<double, 2>(bad)), contains("SampleWindow::dt"));
    CHECK_THROWS_WITH(with(&SampleWindowConfig::duration, bad), contains("SampleWindowConfig::duration"));
  }
  CHECK_THROWS_WITH(with(&SampleWindowConfig::duration, 1e-3), contains("SampleWindowConfig::duration"));
  for (const double bad : {-1.0, nan, infinity})
    CHECK_THROWS_WITH(with(&SampleWindowConfig::observer_bandwidth, bad),
                      contains("SampleWindowConfig::observer_bandwidth"));
  for (const double bad : {0.0, -1.0, nan})
    CHECK_THROWS_WITH(with(&SampleWindowConfig::rest_velocity, bad), contains("SampleWindowConfig::rest_velocity"));
}

static_assert(noexcept(std::declval<SampleWindow<double, 7>&>().push(std::declval<const Sample<7>&>())));
static_assert(noexcept(std::declval<SampleWindow<double, 7>&>().reset()));

}  // namespace
