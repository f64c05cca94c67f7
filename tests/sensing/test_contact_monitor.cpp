#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <rme/sensing/contact_monitor.hpp>

#include "support/catch.hpp"

namespace {

constexpr int kDofs = 7;
using Monitor = rme::ContactMonitor<double, kDofs>;
using Joints = rme::JointVector<double, kDofs>;
using Jacobian = rme::Jacobian<double, kDofs>;

/// With the sizes of a Panda's friction.
Monitor monitor_of(double false_alarms, double lag) {
  const Joints scale = Joints::Ones();
  return {false_alarms, scale, {lag, scale, 0.2 * scale, 0.1 * scale}};
}

/// A pose like an arm's, of full rank: seven revolute joints, of which every other one is turned by about a right angle.
Jacobian jacobian() {
  Jacobian J;
  for (int j = 0; j < kDofs; ++j) {
    const double a = 0.4 * j;
    const Eigen::Vector3d turned = Eigen::Vector3d(-0.4 * std::cos(a), 1, 0.3).normalized();
    const Eigen::Vector3d axis = j % 2 == 0 ? Eigen::Vector3d(std::sin(a), 0, std::cos(a)) : turned;
    const Eigen::Vector3d lever(0.1 * (kDofs - 1 - j), 0.15 * std::cos(1.7 * j), 0.8 - 0.13 * j);
    J.col(j) << axis.cross(lever), axis;
  }
  return J;
}

/// White noise that an observer of 50 rad/s has filtered.
struct Noise {
  explicit Noise(unsigned seed, double size = 0.05) : random(seed), deviation(size) {}
  Joints next() {
    for (int j = 0; j < kDofs; ++j) filtered[j] += 0.05 * (deviation * normal(random) - filtered[j]);
    return filtered;
  }
  std::mt19937_64 random;
  std::normal_distribution<double> normal;
  double deviation;
  Joints filtered = Joints::Zero();
};

/// The arm rests, and the estimator says that payload and arm explain everything.
struct Watch {
  explicit Watch(unsigned seed, double false_alarms = 0.1)
      : noise(seed), monitor(std::make_unique<Monitor>(monitor_of(false_alarms, 0.02))) {}
  void tick(const Joints& added = Joints::Zero()) {
    ++ticks;
    // A contact, too, comes through the observer.
    through += 0.05 * (added - through);
    monitor->update(noise.next() + through, jacobian(), Joints::Zero(), 1e-3, 1e-3 * ticks);
    if (ticks % 20 == 0) monitor->judge(true, 1e-3 * (ticks - 20));
  }
  void run(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) tick();
  }
  const rme::ContactState<double, kDofs>& state() const { return monitor->state(); }

  Noise noise;
  std::unique_ptr<Monitor> monitor;
  Joints through = Joints::Zero();
  int ticks = 0;
};

bool finite(const rme::ContactState<double, kDofs>& s) {
  return s.residual.allFinite() && s.variance.allFinite() && s.threshold.allFinite() && s.link.allFinite() &&
         s.wrench.vector().allFinite() && s.wrench_covariance.allFinite() && std::isfinite(s.statistic);
}

}  // namespace

TEST_CASE("ContactMonitor: white noise raises as many false alarms as are stated, or fewer", "[contact]") {
  // 60 per hour are stated. A quarter of an hour for each of four seeds would show 60; white noise has a lighter tail than
  // an arm that moves, so that they are fewer. 60 + 4 sqrt(60) = 91 is the bound.
  int alarms = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    Watch watch(seed, 60);
    watch.run(900 * 1000);
    alarms += watch.state().last.number;
  }
  INFO("seeds 1 to 4: " << alarms << " alarms in an hour");
  CHECK(alarms <= 91);
  CHECK(alarms >= 5);  // and the threshold is not so high that it is of no use
}

TEST_CASE("ContactMonitor: with the default rate white noise raises no alarm in an hour", "[contact]") {
  Watch watch(5);
  watch.run(3600 * 1000);
  CHECK(watch.state().last.number == 0);
}

TEST_CASE("ContactMonitor: the stated rate sets the threshold by the tail of the largest values", "[contact]") {
  // With many windows of Gumbel's law, mu and beta are known; the tail of exponent 10 exceeds that of Gumbel's law, and is
  // exceeded in one of 1e4 windows at mu + 10 beta (1e4^(1/10) - 1).
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> uniform(1e-12, 1);
  rme::ExtremeThreshold<double, 3> threshold(1e-4);
  for (int i = 0; i < 5000; ++i) threshold.learn(20 - 3 * std::log(-std::log(uniform(random))));
  CAPTURE(threshold.threshold(), threshold.usual());
  CHECK(threshold.usual() == Approx(20).margin(0.5));
  CHECK(threshold.threshold() == Approx(20 + 30 * (std::pow(1e4, 0.1) - 1)).epsilon(0.08));
  CHECK(threshold.threshold() > 20 - 3 * std::log(1e-4));
}

TEST_CASE("ContactMonitor: what the variance expects is usual, also after a value far beyond all others", "[contact]") {
  rme::ExtremeThreshold<double, 7> threshold(1e-4);
  for (int i = 0; i < 30; ++i) threshold.learn(0.3);
  for (int i = 0; i < 2; ++i) threshold.learn(1500);
  CHECK(threshold.usual() >= 7);
}

TEST_CASE("ContactMonitor: a force of 5 N at the tip is noticed within 10 ms, and is over when it is gone",
          "[contact]") {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  Watch watch(7);
  watch.run(10000);
  for (int i = 0; i < 20; ++i) {
    CAPTURE(i);
    const rme::Vector3<double> force =
        5 * rme::Vector3<double>{normal(random), normal(random), normal(random)}.normalized();
    const Joints torque = jacobian().topRows<3>().transpose() * force;
    const int number = watch.state().last.number;
    int noticed = 0;
    for (int k = 1; k <= 80; ++k) {
      watch.tick(torque);
      if (noticed == 0 && watch.state().contact) noticed = k;
    }
    CHECK(noticed >= 1);
    CHECK(noticed <= 10);
    CHECK(watch.state().last.number == number + 1);
    watch.run(400);
    CHECK_FALSE(watch.state().contact);
    CHECK(watch.state().last.over > watch.state().last.noticed);
    CHECK(watch.state().last.onset <= watch.state().last.noticed);
    CHECK(watch.state().last.peak_force > 3);
    CHECK(watch.state().last.peak_torque > 0);
  }
}

TEST_CASE("ContactMonitor: wrench and covariance are those of dense weighted least squares with a prior", "[contact]") {
  Watch watch(8);
  watch.run(3000);
  const Joints torque = jacobian().transpose() * (rme::Vector6<double>() << 4, -2, 3, 0.1, 0.2, -0.1).finished();
  for (int k = 0; k < 40; ++k) watch.tick(torque);
  const auto& s = watch.state();
  REQUIRE(s.contact);
  // The prior has 100 N and 20 N m.
  Eigen::MatrixXd information = jacobian() * s.variance.cwiseInverse().asDiagonal() * jacobian().transpose();
  information.diagonal().head(3).array() += 1e-4;
  information.diagonal().tail(3).array() += 1 / 400.0;
  const Eigen::MatrixXd covariance = information.inverse();
  const Eigen::VectorXd wrench = covariance * jacobian() * s.variance.cwiseInverse().asDiagonal() * s.residual;
  CHECK((wrench - s.wrench.vector()).norm() < 1e-6 * wrench.norm());
  CHECK((covariance - s.wrench_covariance).norm() < 1e-6 * covariance.norm());
  // 40 ms after its onset, 1 - exp(-40 / 20) of it has come through the observer, and nearly all of that through 4 ms.
  CHECK((s.wrench.force - 0.85 * rme::Vector3<double>(4, -2, 3)).norm() < 0.8);
}

TEST_CASE("ContactMonitor: a joint's threshold is the torque that is a contact if the other joints show none",
          "[contact]") {
  for (const int joint : {0, 3, 6}) {
    CAPTURE(joint);
    // The statistic is a sum of squares, to which the noise adds some 17 of about 40: half of the threshold is far below.
    for (const double share : {0.5, 1.6}) {
      CAPTURE(share);
      Watch watch(9);
      watch.run(10000);
      const Joints torque = share * watch.state().threshold[joint] * Joints::Unit(joint);
      for (int k = 0; k < 300; ++k) watch.tick(torque);
      CHECK(watch.state().last.number == (share > 1 ? 1 : 0));
    }
  }
}

TEST_CASE("ContactMonitor: a contact above a joint is found on a link above it", "[contact]") {
  for (const int link : {2, 4, 7}) {
    CAPTURE(link);
    Watch watch(10);
    watch.run(5000);
    // 20 N in the middle between the axes of this link's joint and the next one; on the last link at the origin.
    const Jacobian J = jacobian();
    rme::Vector3<double> at = rme::Vector3<double>::Zero();
    for (int j = link - 1; j <= link && link < kDofs; ++j)
      at += 0.5 * rme::Vector3<double>(J.col(j).tail<3>()).cross(rme::Vector3<double>(J.col(j).head<3>()));
    Joints torque = Joints::Zero();
    for (int j = 0; j < link; ++j)
      torque[j] = rme::Vector3<double>(J.col(j).head<3>() + rme::Vector3<double>(J.col(j).tail<3>()).cross(at))
                      .dot(rme::Vector3<double>(12, 12, 10));
    for (int k = 0; k < 60; ++k) watch.tick(torque);
    const auto& s = watch.state();
    CAPTURE(s.link.transpose());
    REQUIRE(s.contact);
    CHECK(s.link.sum() == Approx(1));
    // No joint beyond the link shows a torque, so that links beyond are improbable.
    CHECK(s.likeliest_link() <= link);
    if (link == kDofs) CHECK(s.likeliest_link() == kDofs);
    if (link == 4) CHECK(s.likeliest_link() >= 3);
  }
}

TEST_CASE("ContactMonitor: what the estimator explains for long ends by itself, and what it does not stays",
          "[contact]") {
  const Joints torque = 3 * Joints::Unit(1);
  Watch explained(11), disturbed(11);
  explained.run(5000);
  disturbed.run(5000);
  for (int k = 0; k < 3000; ++k) {
    explained.tick(torque);
    disturbed.tick(torque);
    disturbed.monitor->judge(false, 0);
  }
  CHECK_FALSE(explained.state().contact);
  CHECK(explained.monitor->followed());
  CHECK(disturbed.state().contact);
  CHECK(disturbed.state().last.over == 0);
}

TEST_CASE("ContactMonitor: a payload that is known better is no contact, and one that has changed explains one",
          "[contact]") {
  Watch watch(12);
  watch.run(5000);
  const Joints change = 1.5 * Joints::Unit(3);
  // The explanation grows, so that the residual shrinks, and the mean with it.
  watch.monitor->refine(change, {change, change});
  for (int k = 0; k < 500; ++k) {
    watch.through = -change;
    watch.tick(-change);
  }
  CHECK(watch.state().last.number == 0);
  // Something is attached, and known after 80 ms.
  const Joints load = 4 * Joints::Unit(1) - change;
  for (int k = 0; k < 80; ++k) watch.tick(load);
  CHECK(watch.state().contact);
  watch.monitor->replace(load + change);
  for (int k = 0; k < 500; ++k) {
    watch.through = -change;
    watch.tick(-change);
  }
  CHECK_FALSE(watch.state().contact);
}

TEST_CASE("ContactMonitor: what it reports is finite, whatever happens", "[contact]") {
  std::mt19937_64 random(13);
  std::normal_distribution<double> normal;
  Monitor monitor = monitor_of(0.1, 0.02);
  Jacobian J = jacobian();
  for (int k = 1; k < 20000; ++k) {
    // Residuals from 1e-8 to the largest plausible one, a singular Jacobian at times, and joints that jump.
    const double size = std::pow(10.0, std::floor(k / 1500.0) - 8);
    Joints residual, dq;
    for (int j = 0; j < kDofs; ++j) {
      residual[j] = size * normal(random);
      dq[j] = k % 3000 < 1500 ? 0 : normal(random);
    }
    if (k % 700 == 0) J = k % 1400 == 0 ? Jacobian(jacobian()) : Jacobian(Jacobian::Zero());
    if (k % 900 == 0) monitor.interrupt();
    if (k % 1100 == 0) monitor.reopen();
    if (k % 1700 == 0) monitor.decide(rme::ContactCause::Arm);
    monitor.update(residual, J, dq, k % 50 == 0 ? 0.1 : 1e-3, 1e-3 * k);
    if (k % 20 == 0) monitor.judge(k % 200 != 0, 1e-3 * (k - 20));
    CAPTURE(k, size);
    REQUIRE(finite(monitor.state()));
  }
  CHECK(monitor.state().last.number > 0);  // there were contacts among them
}

TEST_CASE("ContactMonitor: no torque at all is no contact, and the variance keeps its floor", "[contact]") {
  // In float, which has no number below 1e-45.
  using Torque = rme::JointVector<float, kDofs>;
  const Torque scale = Torque::Ones();
  rme::ContactMonitor<float, kDofs> monitor(0.1, scale, {0, scale, 0.2F * scale, 0.1F * scale});
  const rme::Jacobian<float, kDofs> J = jacobian().cast<float>();
  for (int k = 1; k <= 1300000; ++k) {
    monitor.update(Torque::Zero(), J, Torque::Zero(), 1e-3, 1e-3 * k);
    if (k % 20 == 0) monitor.judge(true, 1e-3 * (k - 20));
  }
  CHECK(monitor.state().last.number == 0);
  CHECK(monitor.state().variance.minCoeff() > 0.9e-8F);  // the floor of a part is 1e-8
  CHECK(monitor.state().threshold.minCoeff() > 0);
  CHECK(std::isfinite(monitor.state().statistic));
  CHECK(monitor.state().wrench_covariance.allFinite());
}
