#include <cmath>
#include <random>
#include <rme/tracking/joint_torque_model.hpp>
#include <tuple>

#include "support/catch.hpp"
#include "tracking/joint_scene.hpp"

namespace {

using namespace rme::testing::joints;
using rme::Sensing;

TEST_CASE("JointTorqueModel: friction acts against the motion, and a joint that stops keeps its friction torque",
          "[joint_torque]") {
  Scene scene(Sensing::JointFriction);
  scene.block(Joints(0.3, -0.3));
  CHECK(scene.model.observation(0, {}).c == rme::JointNuisanceVector<double>{1, -1, -0.3, 1, 0, 0});
  CHECK(scene.model.observation(1, {}).c == rme::JointNuisanceVector<double>{1, 1, 0.3, 1, 0, 0});
  scene.block(Joints::Zero());
  for (int j = 0; j < kDofs; ++j) {
    CHECK(scene.model.observation(j, {}).c == rme::JointNuisanceVector<double>{1, 0, 0, 1, 1, 0});
    const double sign = j == 0 ? -1 : 1;
    CHECK(scene.star.joint(j).mean[rme::kStiction] == Approx(0.95 * sign * kArm.coulomb[j]));
  }
}

TEST_CASE("JointTorqueModel: a rough arm's friction fades into what holds it at rest", "[joint_torque]") {
  Scene scene(Sensing::RoughModel);
  double last = 1;
  for (const double velocity : {0.0, 0.003, 0.03, 1.0}) {
    scene.block(Joints(velocity, -velocity));
    const auto c = scene.model.observation(0, {}).c, opposite = scene.model.observation(1, {}).c;
    CHECK(c[rme::kStiction] == Approx(kRough.slow / (velocity + kRough.slow)));
    CHECK(c[rme::kCoulomb] == Approx(c[rme::kStiction] - 1));
    CHECK(opposite[rme::kCoulomb] == Approx(-c[rme::kCoulomb]));
    CHECK(c[rme::kStiction] <= last);
    last = c[rme::kStiction];
  }
}

TEST_CASE("JointTorqueModel: a timing error of 0.6 ms and the torque's resolution count as noise", "[joint_torque]") {
  Scene scene(Sensing::LinkSide);
  scene.block(Joints::Zero(), Joints(5, 5));  // the first block has no predecessor
  for (int j = 0; j < kDofs; ++j) {
    CHECK(scene.model.observation(j, {}).noise == scene.model.noise().variance(j));
    CHECK(scene.model.observation(j, {}).torque == 5);
  }
  scene.block(Joints::Zero(), Joints(7, -5), Joints(0.1, 0.2));
  for (int j = 0; j < kDofs; ++j) {
    const double change = j == 0 ? 2 : -10, step = j == 0 ? 0.1 : 0.2;
    CHECK(scene.model.observation(j, {}).noise - scene.model.noise().variance(j) ==
          Approx(std::pow(0.03 * change, 2) + 8.0 / 12 * step * step));
  }
}

TEST_CASE("JointTorqueModel: a block that is shorter than usual has more noise, in proportion", "[joint_torque]") {
  Model model = make_model(Sensing::LinkSide);
  Regime regime;
  Block block = at_rest();
  for (const auto& [usual, duration, times] :
       {std::tuple(0.0, 0.02, 1.0), std::tuple(0.02, 0.01, 2.0), std::tuple(0.05, 0.02, 2.5)}) {
    block.usual = usual;
    block.duration = duration;
    regime.update(block);
    model.begin(block, regime);
    for (int j = 0; j < kDofs; ++j) {
      CAPTURE(usual, duration, j);
      CHECK(model.observation(j, {}).noise == Approx(times * model.noise().variance(j)).epsilon(1e-12));
    }
  }
}

TEST_CASE("JointTorqueModel: a joint that starts or turns back within a block has half its friction more noise",
          "[joint_torque]") {
  Scene scene(Sensing::JointFriction);
  Block block = at_rest();
  block.velocity << 0, 0.3;
  block.velocities << 0.3, 0.3, -0.3, -0.3, 0.3, 0.3, 0.3, 0.3;
  scene.regime.update(block);
  scene.model.begin(block, scene.regime);
  CHECK(scene.model.observation(0, {}).noise - scene.model.noise().variance(0) ==
        Approx(std::pow(kArm.coulomb[0] / 2, 2)));
  CHECK(scene.model.observation(1, {}).noise == scene.model.noise().variance(1));
}

TEST_CASE("JointTorqueModel: the torque depends on lag, tool, tilt and payload as they are defined", "[joint_torque]") {
  const unsigned seed = 705;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  for (const Eigen::Vector3d& gravity : {Eigen::Vector3d(0, 0, -9.81), Eigen::Vector3d(9.81, 0, 0)}) {
    Model model(rme::kind_of(Sensing::LinkSide), kArm, 3, 0.01, gravity);
    Block block = at_rest();
    block.torque_rate = block.torque_rate.NullaryExpr(draw);
    block.regressor = block.regressor.NullaryExpr(draw);
    block.jacobian = block.jacobian.NullaryExpr(draw);
    for (const bool known : {false, true}) {
      Eigen::Matrix<double, kDofs, 3> arm = arm.NullaryExpr(draw);
      if (known) block.gravity_torque = arm;
      model.begin(block, Regime(), {}, true);
      Eigen::Matrix<double, kDofs, 2> tilt;
      for (int j = 0; j < kDofs; ++j) {
        const auto o = model.observation(j, {});
        CHECK(o.h[rme::kLag] == 0.02 * block.torque_rate[j]);
        CHECK(o.h.segment<4>(rme::kTool).transpose() == block.regressor.row(j).head<4>());
        CHECK(o.h.segment<rme::kInertial>(rme::kPayload).transpose() == block.regressor.row(j));
        tilt.row(j) = o.h.segment<2>(rme::kTilt).transpose();
      }
      // The robot's model takes gravity to be g; it is g turned about two axes across it. The arm's own torque that it
      // subtracts is -arm g, and what it leaves is the difference.
      if (!known) arm = rme::usual_gravity_torque<double, kDofs>(block.jacobian, 5 * 3);
      const Eigen::Matrix2d across = tilt.transpose() * tilt;
      const Eigen::Matrix<double, kDofs, 3> turned = arm * rme::skew(gravity);
      // The same whichever two orthogonal axes are chosen.
      CHECK(across.trace() == Approx((turned.transpose() * turned).trace()));
      CHECK((tilt * tilt.transpose() - turned * turned.transpose()).norm() < 1e-9 * turned.squaredNorm());
    }
  }
}

TEST_CASE(
    "JointTorqueModel: a tilt shows a residual of a third of its torque, unless the arm's gravity torque is known",
    "[joint_torque]") {
  const unsigned seed = 707;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  for (const bool known : {false, true}) {
    CAPTURE(known);
    Model model(rme::kind_of(Sensing::LinkSide), kArm, 3, 0.01, {0, 0, -9.81});
    Block block = at_rest();
    block.jacobian = block.jacobian.NullaryExpr(draw);
    block.regressor = block.regressor.NullaryExpr(draw);
    if (known) block.gravity_torque = Eigen::Matrix<double, kDofs, 3>::NullaryExpr(draw);
    model.begin(block, Regime(), {}, true);
    auto star = model.prior();
    model.tilt(star, 0.04);
    block.velocity.setConstant(1e3);  // so far that nothing is kept of the residual
    model.begin(block, Regime(), {}, true);
    for (int j = 0; j < kDofs; ++j) {
      const double torque = 0.04 * model.observation(j, {}).h.segment<2>(rme::kTilt).norm();
      CHECK(torque > 0);
      const double expected = known ? 0 : 0.34 * 0.34 * torque * torque;
      CHECK(star.joint(j).covariance(rme::kResidual, rme::kResidual) == Approx(expected));
      auto moved = star;
      model.predict(moved);
      CHECK(moved.joint(j).covariance(rme::kResidual, rme::kResidual) ==
            Approx(model.noise().residual_variance(j) + expected));
    }
  }
}

TEST_CASE("JointTorqueModel: the weight of what is held acts along the tilted gravity, linearised about what is known",
          "[joint_torque]") {
  const unsigned seed = 706;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  const Eigen::Vector3d gravity(0.8, -1.1, -9.7);
  const Eigen::Vector2d angles(0.05, -0.03);
  Model model(rme::kind_of(Sensing::LinkSide), kArm, 3, 0.01, gravity);
  Block block = at_rest();
  block.jacobian = block.jacobian.NullaryExpr(draw);
  block.rotation = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  block.regressor = block.regressor.NullaryExpr(draw);
  const rme::InertialVector<double> phi = rme::InertialVector<double>::NullaryExpr(draw);
  // An arm whose joints show the coordinates of gravity tells by how much the angles change it.
  Eigen::Vector3d changed = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    block.gravity_torque = Eigen::Matrix<double, kDofs, 3>::Zero();
    (*block.gravity_torque)(0, axis) = 1;
    model.begin(block, Regime(), {}, true);
    changed[axis] = -model.observation(0, {}).h.segment<2>(rme::kTilt).dot(angles);
  }
  CHECK(changed.norm() == Approx(angles.norm() * gravity.norm()));
  CHECK(std::abs(changed.dot(gravity)) < 1e-9);
  const Eigen::Matrix<double, 6, rme::kInertial> difference =
      rme::inertial_wrench_regressor<double>(block.rotation, gravity + changed, {}) -
      rme::inertial_wrench_regressor<double>(block.rotation, gravity, {});
  rme::Load<double, kDofs> load;
  load.held = phi.head<4>();
  load.tilt = angles;
  for (const bool known : {true, false}) {
    if (!known) block.gravity_torque.reset();
    for (int j = 0; j < kDofs; ++j) {
      const Eigen::Matrix<double, 1, rme::kInertial> turned = block.jacobian.col(j).transpose() * difference;
      model.begin(block, Regime(), {}, true);
      const auto level = model.observation(j, {}), tilted = model.observation(j, load);
      CHECK((tilted.h - level.h).segment<2>(rme::kTilt).dot(angles) == Approx(turned.dot(phi)));
      // Usual links tell too little of the tilt to turn the weight by what they say.
      const double share = known ? 1 : 0;
      CHECK((tilted.h.segment<rme::kInertial>(rme::kPayload) - block.regressor.row(j).transpose() -
             share * turned.transpose())
                .norm() < 1e-9);
      CHECK((tilted.h.segment<4>(rme::kPoured) - tilted.h.segment<4>(rme::kPayload)).norm() < 1e-12);
      CHECK(tilted.torque - level.torque == Approx(share * turned.dot(phi)));  // so that the product counts once
      CHECK(level.torque == block.tau[j]);
      model.begin(block, Regime());  // no story has a tilt
      CHECK(model.observation(j, load).h == model.observation(j, {}).h);
      CHECK(model.observation(j, load).torque == block.tau[j]);
    }
  }
}

TEST_CASE("JointTorqueModel: after a removal the offsets are uncertain by what the gain has drifted since the pick-up",
          "[joint_torque]") {
  Scene scene(Sensing::LinkSide);
  scene.block(Joints::Zero());
  rme::InertialVector<double> held = rme::InertialVector<double>::Zero();
  held[3] = 0.2;
  auto star = scene.star;
  scene.model.unload(star, held, 25);
  const auto grown = [&](int j) {
    return star.joint(j).covariance(rme::kOffset, rme::kOffset) -
           scene.star.joint(j).covariance(rme::kOffset, rme::kOffset);
  };
  CHECK(grown(0) == Approx(0).margin(1e-15));
  CHECK(grown(1) == Approx(std::pow(0.02 * 0.7 * 0.2, 2)));  // 0.004 per square root of a second
  held[3] = 1e6;                                             // no more than the prior
  star = scene.star;
  scene.model.unload(star, held, 25);
  CHECK(grown(1) == Approx(kArm.offset[1] * kArm.offset[1]));
}

TEST_CASE("JointTorqueModel: an error of a joint's gain is a share of what the payload makes the joint bear",
          "[joint_torque]") {
  Scene scene(Sensing::LinkSide);
  scene.block(Joints::Zero());
  rme::InertialVector<double> held = rme::InertialVector<double>::Zero();
  CHECK(scene.model.load(scene.star).torque == Joints::Zero());
  held << 1.3, 0.1, -0.2, 0.3, 0, 0, 0, 0, 0, 0;
  scene.star.draw_payload(held, rme::InertialMatrix<double>::Identity());
  const auto bears = scene.model.load(scene.star);
  CHECK(bears.mass == Approx(1.3));
  for (int j = 0; j < kDofs; ++j) {
    const double torque = scene.model.block().regressor.row(j).dot(held);
    CHECK(bears.torque[j] == Approx(torque));
    CHECK(scene.model.observation(j, bears).c[rme::kGain] == Approx(torque));
    CHECK(scene.model.observation(j, bears).h == scene.model.observation(j, {}).h);
  }
  CHECK(bears.torque.norm() > 0.1);
}

TEST_CASE("JointTorqueModel: the prior is the arm's, friction as well known as that says", "[joint_torque]") {
  for (const Sensing sensing : {Sensing::LinkSide, Sensing::JointFriction, Sensing::RoughModel}) {
    const rme::SensingKind& kind = rme::kind_of(sensing);
    const Model model = make_model(sensing);
    const auto star = model.prior();
    CHECK(star.empty());
    CHECK(star.mean().isZero(0));
    CHECK(star.variance(rme::kLag) == Approx(kind.lag * kind.lag));
    CHECK(std::sqrt(star.variance(rme::kTool)) == Approx(3 * kind.tool));
    for (int i = 1; i < 4; ++i) CHECK(std::sqrt(star.variance(rme::kTool + i)) == Approx(3 * kind.tool * 0.1));
    CHECK(std::sqrt(star.variance(rme::kTilt)) == Approx(0.02));
    for (int j = 0; j < kDofs; ++j) {
      Beta mean = Beta::Zero(), variance = Beta::Zero();
      variance[rme::kOffset] = std::pow(kArm.offset[j], 2);
      mean[rme::kCoulomb] = kind.friction * kArm.coulomb[j];
      mean[rme::kViscous] = kind.friction * kArm.viscous[j];
      variance[rme::kCoulomb] = std::pow(kArm.friction_std * mean[rme::kCoulomb], 2);
      variance[rme::kViscous] = std::pow(kArm.friction_std * mean[rme::kViscous], 2);
      variance[rme::kStiction] =
          std::pow(0.6 * mean[rme::kCoulomb], 2) + kind.stiction * model.noise().residual_variance(j);
      CHECK(star.joint(j).mean == mean);
      CHECK((star.joint(j).covariance - BetaMatrix(variance.asDiagonal())).norm() < 1e-14);
    }
  }
}

TEST_CASE("JointTorqueModel: reopening forgets how sure the offset was", "[joint_torque]") {
  const unsigned seed = 704;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto before = any_star(random);
  auto star = before;
  make_model(Sensing::RoughModel).reopen_offset(star);
  for (int j = 0; j < kDofs; ++j) {
    Life life;
    life.Q(rme::kOffset, rme::kOffset) = std::pow(kArm.offset[j], 2);
    check_life(before, star, j, life);
  }
}

TEST_CASE("JointTorqueModel: what is not known of the flange's acceleration is noise of the payload's inertia force",
          "[joint_torque]") {
  // A kilogram turns it into J^T a and, at the root of 0.01 m^2 from the flange, into moments: of its inertia force on
  // that arm, and of the angular acceleration. 2.5 times, since the joints' errors are one and the same.
  Block block = at_rest();
  block.jacobian << 0.1, 0.4, 0.2, 0.5, -0.1, 0.1, 0.3, 0.2, -0.3, 0.7, 0.6, 0.8;
  block.acceleration_variance = 0.3;
  block.angular_acceleration_variance = 0.7;
  Model model = make_model(Sensing::LinkSide);
  model.begin(block, Regime());
  const double arm = 0.01;
  for (int j = 0; j < kDofs; ++j)
    CHECK(model.observation(j, {3, Joints::Zero()}).noise - model.noise().variance(j) ==
          Approx(9 * 2.5 *
                 (0.3 * block.jacobian.col(j).head<3>().squaredNorm() +
                  (0.3 * arm + 0.7 * arm * arm) * block.jacobian.col(j).tail<3>().squaredNorm())));
}

}  // namespace
