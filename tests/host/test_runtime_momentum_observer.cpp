#include <random>
#include <rme/host/runtime_momentum_observer.hpp>

#include "support/catch.hpp"

namespace {

using namespace rme;

template <int Dofs>
void check_equal() {
  CAPTURE(Dofs);
  std::mt19937 random(382);
  std::normal_distribution<double> normal;
  const auto vector = [&] {
    return Eigen::VectorXd(Eigen::VectorXd::NullaryExpr(Dofs, [&] { return normal(random); }));
  };
  MomentumObserverConfig<double, Dofs> config;
  for (int j = 0; j < Dofs; ++j) config.gain[j] = 20 + 10 * j;
  MomentumObserver<double, Dofs> fixed(0.001, config), fixed_plain(0.001);
  RuntimeMomentumObserver<double> observer(Dofs, 0.001, config.gain), plain(Dofs, 0.001);
  REQUIRE(observer.joints() == Dofs);
  for (int tick = 0; tick < 300; ++tick) {
    const Eigen::VectorXd tau = 20 * vector(), dq = vector(), coriolis = vector(), gravity = 10 * vector();
    const Eigen::VectorXd row = vector();
    const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> mass =
        row * row.transpose() + Eigen::MatrixXd::Identity(Dofs, Dofs);
    const double period = tick % 5 == 4 ? 0.003 : tick == 200 ? -1 : 0;
    const JointVector<double, Dofs> t = tau, v = dq, c = coriolis, g = gravity;
    const JointMatrix<double, Dofs> M = mass;
    REQUIRE(observer.update(tau, dq, mass, coriolis, gravity, period) == fixed.update(t, v, M, c, g, period));
    REQUIRE(plain.update(tau, dq, mass, coriolis, gravity) == fixed_plain.update(t, v, M, c, g));
    REQUIRE((observer.tau_ext() == fixed.tau_ext()));
    REQUIRE((plain.tau_ext() == fixed_plain.tau_ext()));
  }
  CHECK(observer.tau_ext().norm() > 1);
  observer.reset();
  CHECK(observer.tau_ext().isZero(0));
}

TEST_CASE("RuntimeMomentumObserver: for 1 to 8 joints it is MomentumObserver, to the last bit", "[host]") {
  check_equal<1>();
  check_equal<5>();
  check_equal<7>();
  check_equal<8>();
}

TEST_CASE("RuntimeMomentumObserver: another size is refused, and changes nothing", "[host]") {
  RuntimeMomentumObserver<double> observer(6, 0.001);
  const Eigen::VectorXd six = Eigen::VectorXd::Ones(6), five = Eigen::VectorXd::Ones(5);
  const Eigen::MatrixXd square = Eigen::MatrixXd::Identity(6, 6), other = Eigen::MatrixXd::Identity(6, 5);
  REQUIRE(observer.update(six, six, square, six, six) == Status::Ok);
  REQUIRE(observer.update(six, six, square, six, six) == Status::Ok);
  const Eigen::VectorXd before = observer.tau_ext();
  CHECK(observer.update(five, six, square, six, six) == Status::WrongSize);
  CHECK(observer.update(six, five, square, six, six) == Status::WrongSize);
  CHECK(observer.update(six, six, other, six, six) == Status::WrongSize);
  CHECK(observer.update(six, six, square, five, six) == Status::WrongSize);
  CHECK(observer.update(six, six, square, six, five) == Status::WrongSize);
  CHECK((observer.tau_ext() == before));
  CHECK_THROWS_WITH(RuntimeMomentumObserver<double>(9, 0.001),
                    contains("RuntimeMomentumObserver::joints: expected 1 to 8, got 9"));
  CHECK_THROWS_WITH(RuntimeMomentumObserver<double>(6, 0.001, five),
                    contains("MomentumObserverConfig::gain: expected 6 numbers, one per joint, got 5"));
  CHECK_THROWS_WITH(RuntimeMomentumObserver<double>(6, 0.001, Eigen::VectorXd::Constant(6, 2000)),
                    contains("MomentumObserverConfig::gain"));
}

}  // namespace
