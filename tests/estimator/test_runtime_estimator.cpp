#include <array>
#include <cmath>
#include <rme/runtime_estimator.hpp>
#include <string>
#include <type_traits>

#include "support/any_joints.hpp"
#include "support/catch.hpp"

namespace {

using namespace rme;
using examples::kFewestJoints;
using examples::kMostJoints;
using Runtime = RuntimeEstimator<double, kFewestJoints, kMostJoints>;

/// The made-up arm's samples; after some time with everything that a host may add.
template <int Dofs>
Proprioception<double, Dofs> sample_at(int tick) {
  Proprioception<double, Dofs> sample = testing::sample_at<Dofs>(tick);
  if (tick > 600)
    sample.compensation = 0.9 * compensation_torque<double>({1, {0.01, 0, 0.1}}, sample.jacobian, sample.rotation);
  if (tick > 800) sample.gravity_torque = 0.5 * sample.jacobian.template topRows<3>().transpose();
  if (tick > 1250) sample.tau_ext.array() += 30;  // a contact
  if (tick > 1000) sample.motion = FlangeMotion<double>{{0, 0.1, 0}, {0.2, 0, 0.1}, {0, 0.3, 0}};
  return sample;
}

template <int Dofs>
void check_same(const Runtime::Contact& a, const ContactState<double, Dofs>& b) {
  REQUIRE(a.ready == b.ready);
  REQUIRE(a.contact == b.contact);
  REQUIRE(a.statistic == b.statistic);
  REQUIRE(a.residual == b.residual);
  REQUIRE(a.variance == b.variance);
  REQUIRE(a.threshold == b.threshold);
  REQUIRE(a.wrench.vector() == b.wrench.vector());
  REQUIRE(a.wrench_covariance == b.wrench_covariance);
  REQUIRE(a.link == b.link);
  REQUIRE(a.likeliest_link() == b.likeliest_link());
  REQUIRE(a.last.number == b.last.number);
  REQUIRE(a.last.cause == b.last.cause);
  REQUIRE(a.last.onset == b.last.onset);
  REQUIRE(a.last.noticed == b.last.noticed);
  REQUIRE(a.last.over == b.last.over);
  REQUIRE(a.last.peak_torque == b.last.peak_torque);
  REQUIRE(a.last.peak_force == b.last.peak_force);
}

template <int Dofs>
void check_equal() {
  CAPTURE(Dofs);
  EstimatorConfig<double, Dofs> fixed;
  Runtime::Config config;
  fixed.rated_payload = config.rated_payload = 5;
  fixed.contact_false_alarms = config.contact_false_alarms = 3;
  fixed.arm = ArmPrior<double, Dofs>::of(4);
  fixed.arm->friction_std = 0.3;
  config.arm = ArmPrior<double, Eigen::Dynamic>{fixed.arm->noise,   fixed.arm->offset,  fixed.arm->residual,
                                                fixed.arm->coulomb, fixed.arm->viscous, 0.3};
  Estimator<double, Dofs> expected(0.001, fixed);
  Runtime estimator(Dofs, 0.001, config);
  REQUIRE(estimator.joints() == Dofs);
  Eigen::VectorXd buffer(3 * Dofs), torque(Dofs);
  for (int tick = 0; tick < 1500; ++tick) {
    if (tick == 700) {
      expected.in_contact(true);
      estimator.in_contact(true);
    }
    if (tick == 800) {
      expected.expect_change();
      estimator.expect_change();
    }
    if (tick == 900) {
      expected.in_contact(false);
      estimator.in_contact(false);
    }
    const auto sample = sample_at<Dofs>(tick);
    // As hosts hold them: parts of a longer vector, and a Jacobian by rows.
    buffer << sample.tau_ext, sample.dq, sample.tau_ext;
    const Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor> jacobian = sample.jacobian;
    const std::array<double, 9> rotation = [&] {
      std::array<double, 9> out;
      Eigen::Map<Matrix3<double>>(out.data()) = sample.rotation;
      return out;
    }();
    const Eigen::Map<const Eigen::Matrix3d> R(rotation.data());
    REQUIRE(expected.update(sample) == Status::Ok);
    const auto tau_ext = buffer.head(Dofs), dq = buffer.segment(Dofs, Dofs);
    Eigen::VectorXd carried;
    Eigen::MatrixXd gravity;
    if (sample.compensation) carried = *sample.compensation;
    if (sample.gravity_torque) gravity = *sample.gravity_torque;
    if (tick <= 600)
      REQUIRE(estimator.update(tau_ext, jacobian, R, dq, sample.period, sample.motion) == Status::Ok);
    else if (tick <= 700)
      REQUIRE(estimator.update(tau_ext, jacobian, R, dq, sample.period, sample.motion, carried) == Status::Ok);
    else
      REQUIRE(estimator.update(tau_ext, jacobian, R, dq, sample.period, sample.motion, carried, gravity) == Status::Ok);
    REQUIRE(estimator.compensation(jacobian, R, torque) == Status::Ok);
    REQUIRE(torque == expected.compensation(sample.jacobian, sample.rotation));
    const FlangeMotion<double> motion{{0.1, 0.2, 0.3}, {1, 2, 3}, {0.5, 0, -1}};
    REQUIRE(estimator.payload_torque(jacobian, R, motion, torque) == Status::Ok);
    REQUIRE(torque == expected.payload_torque(sample.jacobian, sample.rotation, motion));
    check_same(estimator.contact(), expected.contact());
  }
  CHECK(estimator.contact().ready);
  CHECK(estimator.contact().last.number > 0);
  CHECK(estimator.state().payload.mean == expected.state().payload.mean);
  CHECK(estimator.state().payload.covariance == expected.state().payload.covariance);
  CHECK(estimator.state().time == expected.state().time);
  CHECK(estimator.state().event.number == expected.state().event.number);
  CHECK(estimator.state().event.number > 0);
  CHECK(estimator.state().event.kind == expected.state().event.kind);
  CHECK(std::abs(estimator.state().payload.mean[0] - 1) < 0.05);

  const PayloadGaussian<double> said = {{0.4, 0, 0, 0.1}, Eigen::Vector4d(1e-4, 1e-4, 1e-4, 1e-4).asDiagonal()};
  REQUIRE(estimator.set_payload(said) == Status::Ok);
  CHECK(std::abs(estimator.state().payload.mean[0] - 0.4) < 0.02);
  REQUIRE(expected.set_payload(said) == Status::Ok);
  CHECK(estimator.state().payload.mean == expected.state().payload.mean);
  estimator.tare();
  expected.tare();
  CHECK(estimator.state().tool == expected.state().tool);
  CHECK(std::abs(estimator.state().tool[0] - 0.4) < 0.05);
  estimator.declare_empty();
  CHECK(estimator.state().empty());
  expected.declare_empty();
  check_same(estimator.contact(), expected.contact());
  estimator.reset();
  expected.reset();
  check_same(estimator.contact(), expected.contact());
  CHECK(estimator.contact().residual.size() == Dofs);
  CHECK(estimator.state().time == 0);
  CHECK(estimator.state().event.number == 0);
}

template <int Dofs = kFewestJoints>
void check_each() {
  check_equal<Dofs>();
  if constexpr (Dofs < kMostJoints) check_each<Dofs + 1>();
}

TEST_CASE("RuntimeEstimator: for 4 to 8 joints it believes and commands what Estimator does, to the last bit",
          "[runtime_estimator]") {
  check_each();
}

TEST_CASE("RuntimeEstimator: a vector or matrix of another size is refused, and changes nothing",
          "[runtime_estimator]") {
  Runtime estimator(6, 0.001);
  const auto sample = sample_at<6>(0);
  const Eigen::VectorXd tau = sample.tau_ext, dq = sample.dq;
  const Eigen::MatrixXd J = sample.jacobian;
  REQUIRE(estimator.update(tau, J, sample.rotation, dq) == Status::Ok);
  const Eigen::VectorXd seven = Eigen::VectorXd::Zero(7), none;
  const Eigen::MatrixXd wide = Eigen::MatrixXd::Zero(6, 7), flat = Eigen::MatrixXd::Zero(3, 6);
  CHECK(estimator.update(seven, J, sample.rotation, dq) == Status::WrongSize);
  CHECK(estimator.update(none, J, sample.rotation, dq) == Status::WrongSize);
  CHECK(estimator.update(tau.transpose(), J, sample.rotation, dq) == Status::WrongSize);
  CHECK(estimator.update(tau, wide, sample.rotation, dq) == Status::WrongSize);
  CHECK(estimator.update(tau, flat, sample.rotation, dq) == Status::WrongSize);
  CHECK(estimator.update(tau, J, sample.rotation, seven) == Status::WrongSize);
  CHECK(estimator.update(tau, J, sample.rotation, dq, 0, {}, seven) == Status::WrongSize);
  CHECK(estimator.update(tau, J, sample.rotation, dq, 0, {}, tau.transpose()) == Status::WrongSize);
  CHECK(estimator.update(tau, J, sample.rotation, dq, 0, {}, tau, flat) == Status::WrongSize);
  CHECK(estimator.update(tau, J, sample.rotation, dq, 0, {}, none, wide) == Status::WrongSize);
  CHECK(estimator.update(tau, J, Matrix3<double>::Zero(), dq) == Status::NotARotation);
  CHECK(estimator.state().time == 0.001);

  Eigen::VectorXd torque = Eigen::VectorXd::Constant(6, 3), longer = Eigen::VectorXd::Constant(7, 3);
  CHECK(estimator.compensation(wide, sample.rotation, torque) == Status::WrongSize);
  CHECK(estimator.compensation(J, sample.rotation, longer) == Status::WrongSize);
  CHECK(torque == Eigen::VectorXd::Constant(6, 3));
  CHECK(longer == Eigen::VectorXd::Constant(7, 3));
}

TEST_CASE("RuntimeEstimator: arguments and settings out of range are refused by name at construction",
          "[runtime_estimator]") {
  const std::string range = std::to_string(kFewestJoints) + " to " + std::to_string(kMostJoints);
  CHECK_THROWS_WITH(Runtime(3, 0.001), contains("RuntimeEstimator::joints: expected " + range + ", got 3"));
  CHECK_THROWS_WITH(Runtime(9, 0.001), contains("RuntimeEstimator::joints: expected " + range + ", got 9"));
  CHECK_THROWS_WITH((RuntimeEstimator<double, 6, 7>(8, 0.001)), contains("expected 6 to 7, got 8"));
  CHECK_THROWS_WITH(Runtime(6, 0), contains("Estimator::dt"));
  Runtime::Config config;
  config.rated_payload = -1;
  CHECK_THROWS_WITH(Runtime(6, 0.001, config), contains("EstimatorConfig::rated_payload"));
  config.rated_payload = 3;
  const Eigen::VectorXd six = Eigen::VectorXd::Ones(6);
  config.arm = ArmPrior<double, Eigen::Dynamic>{six, six, six, Eigen::VectorXd::Ones(7), six};
  CHECK_THROWS_WITH(Runtime(6, 0.001, config), contains("ArmPrior::coulomb: expected 6 numbers, one per joint, got 7"));
}

}  // namespace
