#include <cmath>
#include <memory>
#include <random>
#include <rme/tracking/contact_watch.hpp>
#include <synthetic_arm/panda.hpp>

#include "support/catch.hpp"

namespace {

constexpr int kDofs = 7;
using Watch = rme::ContactWatch<double, kDofs>;
using Joints = rme::JointVector<double, kDofs>;
using rme::examples::panda;

/// An arm that rests and holds something, and what a tracker may make of it.
class Scene {
 public:
  explicit Scene(double mass) : weight_(0, 0, -9.81 * mass) {
    belief.probability[rme::Mode::Held] = 1;
    belief.empty = 0;
    belief.sensing[static_cast<std::size_t>(rme::Sensing::LinkSide)] = 1;
    block_.jacobian = arm_.jacobian;
    believe(mass, 1e-3);
    watch_->told(belief);
  }
  void believe(double mass, double deviation) {
    belief.payload.mean.setZero();
    belief.payload.mean[0] = mass;
    belief.payload.covariance.setZero();
    belief.payload.covariance(0, 0) = deviation * deviation;
  }
  void change() {
    belief.probability[rme::Mode::Held] = 0;
    belief.probability[rme::Mode::Changing] = 1;
  }
  void hold() {
    belief.probability[rme::Mode::Held] = 1;
    belief.probability[rme::Mode::Changing] = 0;
  }
  void run(int blocks) {
    for (int b = 0; b < blocks; ++b) {
      for (int tick = 0; tick < 20; ++tick) {
        time_ += 1e-3;
        for (int j = 0; j < kDofs; ++j) noise_[j] += 0.05 * (0.05 * normal_(random_) - noise_[j]);
        const Joints tau_ext = arm_.jacobian.topRows<3>().transpose() * weight_ + noise_;
        watch_->update({tau_ext, arm_.jacobian, arm_.rotation, Joints::Zero()}, 1e-3, time_);
      }
      block_.end = time_;
      block_.duration = 0.02;
      watch_->judge(block_, belief, events_);
    }
  }
  const rme::ContactState<double, kDofs>& state() const { return watch_->state(); }

  rme::TrackerBelief<double> belief;

 private:
  rme::examples::Kinematics<kDofs> arm_ = panda().kinematics(panda().ready);
  Eigen::Vector3d weight_;
  std::unique_ptr<Watch> watch_ =
      std::make_unique<Watch>(0.1, rme::ArmPrior<double, kDofs>::of(3), 50.0, Eigen::Vector3d(0, 0, -9.81), 1e-3);
  rme::EventMonitor<double> events_;
  rme::TorqueBlock<double, kDofs> block_;
  std::mt19937_64 random_{5};
  std::normal_distribution<double> normal_;
  Joints noise_ = Joints::Zero();
  double time_ = 0;
};

}  // namespace

TEST_CASE("ContactWatch: a payload that is given up after a block leaves no residual behind", "[contact]") {
  Scene scene(2);
  scene.run(500);
  REQUIRE(scene.state().last.number == 0);
  // For a block the tracker takes a jolt for a change, then for a heavier payload; then it knows better.
  scene.change();
  scene.run(1);
  scene.hold();
  scene.believe(2.05, 0.02);
  scene.run(1);
  scene.believe(2, 1e-3);
  scene.run(50);
  CHECK(scene.state().last.number == 0);
}

TEST_CASE("ContactWatch: a payload that was taken for another one, and stays, leaves no residual behind", "[contact]") {
  Scene scene(2);
  scene.believe(1.9, 1e-3);
  scene.run(500);
  REQUIRE(scene.state().last.number == 0);
  scene.change();
  scene.run(1);
  scene.hold();
  scene.believe(2, 0.014);
  scene.run(5);
  CHECK(scene.state().last.number == 0);
  const Joints residual = scene.state().residual;
  CHECK(residual.cwiseAbs().maxCoeff() < 0.05);
}
