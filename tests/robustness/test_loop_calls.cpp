#include <algorithm>
#include <cmath>
#include <memory>
#include <rme/control/barriers.hpp>
#include <rme/control/cpic.hpp>
#include <rme/control/energy_tank.hpp>
#include <rme/control/limit_cycle.hpp>
#include <rme/control/linear_attractor.hpp>
#include <rme/control/null_space.hpp>
#include <rme/control/orientation_attractor.hpp>
#include <rme/control/passive_controller.hpp>
#include <rme/control/passivity_monitor.hpp>
#include <rme/control/posture.hpp>
#include <rme/core/compensation.hpp>
#include <rme/network/mismatch_network.hpp>
#include <rme/sensing/mismatch_detector.hpp>
#include <rme/sensing/momentum_observer.hpp>
#include <rme/sensing/pseudo_wrench.hpp>

#include "control/random_arm.hpp"
#include "network/golden.hpp"
#include "robustness/bad_numbers.hpp"

namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using rme::Status;
using rme::testing::check_loop_call;
using rme::testing::Entries;
using rme::testing::entries_of;
using rme::testing::LoopCall;
using rme::testing::Random;
using Vector7 = rme::JointVector<double, 7>;
using Matrix7 = rme::JointMatrix<double, 7>;
using Jacobian7 = rme::Jacobian<double, 7>;

constexpr double kPeriod = 1e-3;

template <typename Matrix>
Matrix gaussian(Random& random, double deviation) {
  std::normal_distribution<double> normal(0, deviation);
  return Matrix::NullaryExpr([&] { return normal(random); });
}

/// Lines numbers, vectors and matrices up.
template <typename... Parts>
VectorXd joined(const Parts&... parts) {
  std::vector<double> all;
  const auto add = [&all](const auto& part) {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(part)>>)
      all.push_back(static_cast<double>(part));
    else
      all.insert(all.end(), part.data(), part.data() + part.size());
  };
  (add(parts), ...);
  return Eigen::Map<VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

struct Detector final : LoopCall<rme::MismatchDetector<7>, Vector7> {
  using Object = rme::MismatchDetector<7>;
  Object make() const override { return Object(0.02); }
  Vector7 good(Random& random) const override { return gaussian<Vector7>(random, 0.5); }
  Entries entries(Vector7& input) const override { return entries_of(input); }
  Status call(Object& object, const Vector7& input) const override { return object.update(input); }
  VectorXd answers(const Object& object) const override {
    return joined(object.rapid_change(), object.stabilised(), object.detected());
  }
};

TEST_CASE("MismatchDetector: no sample, however bad, leaves more than what an accepted one leaves", "[robustness]") {
  check_loop_call(Detector(), 1, 20000);
}

struct ObserverInput {
  Vector7 tau, dq;
  Matrix7 mass_matrix;
  Vector7 coriolis, gravity;
  double period;
};
struct Observer final : LoopCall<rme::MomentumObserver<double, 7>, ObserverInput> {
  using Object = rme::MomentumObserver<double, 7>;
  Object make() const override { return Object(kPeriod); }
  ObserverInput good(Random& random) const override {
    return {gaussian<Vector7>(random, 20), gaussian<Vector7>(random, 1),  Matrix7::Identity(),
            gaussian<Vector7>(random, 1),  gaussian<Vector7>(random, 20), kPeriod};
  }
  Entries entries(ObserverInput& in) const override {
    return entries_of(in.tau, in.dq, in.mass_matrix, in.coriolis, in.gravity, in.period);
  }
  Status call(Object& object, const ObserverInput& in) const override {
    return object.update(in.tau, in.dq, in.mass_matrix, in.coriolis, in.gravity, in.period);
  }
  VectorXd answers(const Object& object) const override { return object.tau_ext(); }
};

TEST_CASE("MomentumObserver: bad input never shows in the external torque", "[robustness]") {
  check_loop_call(Observer(), 2, 20000);
}

TEST_CASE("MomentumObserver: an input of 100 times the range is forgotten within half a second", "[robustness]") {
  // exp(-50 * 0.5) = 1.4e-11 of the 100 * 87 N m that the spike may have left.
  rme::MomentumObserver<double, 7> observer(kPeriod);
  const Vector7 zero = Vector7::Zero();
  REQUIRE(observer.update(zero, zero, Matrix7::Identity(), zero, zero) == Status::Ok);
  REQUIRE(observer.update(Vector7::Constant(8700), Vector7::Constant(200), Matrix7::Identity(), zero, zero) ==
          Status::Ok);
  CHECK(observer.tau_ext().norm() > 100);
  for (int k = 0; k < 500; ++k) REQUIRE(observer.update(zero, zero, Matrix7::Identity(), zero, zero) == Status::Ok);
  CHECK(observer.tau_ext().norm() < 1e-6);
}

struct PseudoWrenchInput {
  Jacobian7 jacobian;
  Vector7 tau_ext;
  double damping;
};
struct PseudoWrench final : LoopCall<rme::Wrench<double>, PseudoWrenchInput> {
  using Object = rme::Wrench<double>;
  Object make() const override { return {}; }
  PseudoWrenchInput good(Random& random) const override {
    PseudoWrenchInput in{gaussian<Jacobian7>(random, 0.5), gaussian<Vector7>(random, 20), 0.01};
    if (random() % 4 == 0) in.jacobian.row(static_cast<int>(random() % 6)).setZero();       // rank 5
    if (random() % 4 == 0) in.jacobian = in.jacobian.col(0) * Vector7::Ones().transpose();  // rank 1
    if (random() % 8 == 0) in.jacobian.setZero();
    return in;
  }
  Entries entries(PseudoWrenchInput& in) const override { return entries_of(in.jacobian, in.tau_ext, in.damping); }
  Status call(Object& object, const PseudoWrenchInput& in) const override {
    return rme::pseudo_wrench(in.jacobian, in.tau_ext, in.damping, object);
  }
  VectorXd answers(const Object& object) const override { return object.vector(); }
};

TEST_CASE("pseudo_wrench: finite for every Jacobian, also one of rank five, one or none", "[robustness]") {
  check_loop_call(PseudoWrench(), 3, 20000);
}

using Network = rme::MismatchNetwork<double>;
struct Forward final : LoopCall<Network::Output, Network::Window> {
  std::unique_ptr<Network> network = std::make_unique<Network>(*golden::random_weights<double>());
  Network::Output make() const override { return Network::Output::Zero(); }
  Network::Window good(Random& random) const override { return gaussian<Network::Window>(random, 10); }
  Entries entries(Network::Window& in) const override { return entries_of(in); }
  Status call(Network::Output& out, const Network::Window& in) const override { return network->forward(in, out); }
  VectorXd answers(const Network::Output& out) const override { return out; }
};

TEST_CASE("MismatchNetwork: forward writes finite numbers or none", "[robustness]") {
  check_loop_call(Forward(), 4, 2000);
}

struct PassiveInput {
  Vector3d position;
  Eigen::Matrix3d rotation;
  Eigen::Matrix<double, 6, 1> twist;
};
struct Passive final : LoopCall<rme::PassiveController<double>, PassiveInput> {
  using Object = rme::PassiveController<double>;
  const rme::LinearAttractor<double> attractor;
  const rme::LimitCycle<double> cycle;
  const rme::OrientationAttractor<double> turning;
  Passive() : attractor({Vector3d(0.4, 0, 0.5), 1, 0.5}), cycle({}), turning({}) {}
  Object make() const override { return Object(); }
  PassiveInput good(Random& random) const override {
    return {gaussian<Vector3d>(random, 0.5),
            Eigen::Quaterniond(gaussian<Eigen::Vector4d>(random, 1).normalized()).toRotationMatrix(),
            gaussian<rme::Vector6<double>>(random, 0.3)};
  }
  Entries entries(PassiveInput& in) const override { return entries_of(in.position, in.rotation, in.twist); }
  Status call(Object& object, const PassiveInput& in) const override {
    const auto flow = in.position.x() > 0 ? attractor(in.position) : cycle(in.position);
    return object.update(flow, turning(in.rotation), rme::Twist<double>::from_vector(in.twist));
  }
  VectorXd answers(const Object& object) const override {
    return joined(object.wrench().vector(), object.potential_energy(), object.injected_power(),
                  object.dissipated_power());
  }
};

TEST_CASE("PassiveController: what a flow makes of bad numbers never reaches the wrench", "[robustness]") {
  check_loop_call(Passive(), 5, 20000);
}

TEST_CASE("LinearAttractor: a target that is not finite is refused, and the old one stays", "[robustness]") {
  rme::LinearAttractor<double> attractor({Vector3d(0.4, 0, 0.5), 1, 0.5});
  const Vector3d before = attractor(Vector3d::Zero()).velocity;
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK(attractor.set_target({0, bad, 0}) == Status::NonFiniteInput);
    CHECK(attractor(Vector3d::Zero()).velocity == before);
  }
  CHECK(attractor.set_target(Vector3d::Zero()) == Status::Ok);
  CHECK(attractor(Vector3d::Zero()).velocity == Vector3d::Zero());
}

using Rows = rme::ConstraintRows<double, 7, 28>;

VectorXd contents(const Rows& rows) {
  std::vector<double> all = {static_cast<double>(rows.size())};
  for (int i = 0; i < rows.size(); ++i) {
    all.insert(all.end(), rows[i].a.data(), rows[i].a.data() + 7);
    // Bounds and weights may be infinite, by design.
    for (const double x : {rows[i].lower, rows[i].upper, rows[i].weight})
      all.push_back(std::isinf(x) ? std::copysign(1e300, x) : x);
  }
  return Eigen::Map<VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

struct LimitsInput {
  Vector7 q, dq;
};
struct Limits final : LoopCall<Rows, LimitsInput> {
  rme::JointLimits<double, 7> limits{{Vector7::Constant(-2), Vector7::Constant(2), Vector7::Constant(2)}};
  Rows make() const override { return {}; }
  LimitsInput good(Random& random) const override {
    return {gaussian<Vector7>(random, 1), gaussian<Vector7>(random, 1)};
  }
  Entries entries(LimitsInput& in) const override { return entries_of(in.q, in.dq); }
  Status call(Rows& rows, const LimitsInput& in) const override {
    const Status status = limits.append(in.q, in.dq, rows);
    if (rows.size() > 14) rows.clear();
    return status;
  }
  VectorXd answers(const Rows& rows) const override { return contents(rows); }
};

TEST_CASE("JointLimits: appends all of its rows or none, and no bound is a NaN", "[robustness]") {
  check_loop_call(Limits(), 6, 5000);
}

struct BarrierInput {
  Vector3d position, velocity;
  Eigen::Matrix<double, 3, 7> jacobian;
  Vector3d velocity_product;
  Vector7 dq;
  Vector3d normal, center;
  double offset;
};
struct Barrier final : LoopCall<Rows, BarrierInput> {
  Rows make() const override { return {}; }
  BarrierInput good(Random& random) const override {
    return {gaussian<Vector3d>(random, 0.5),
            gaussian<Vector3d>(random, 0.5),
            gaussian<Eigen::Matrix<double, 3, 7>>(random, 0.5),
            gaussian<Vector3d>(random, 0.5),
            gaussian<Vector7>(random, 0.5),
            Vector3d::UnitZ(),
            gaussian<Vector3d>(random, 0.5),
            0.1};
  }
  Entries entries(BarrierInput& in) const override {
    return entries_of(in.position, in.velocity, in.jacobian, in.velocity_product, in.dq, in.normal, in.center,
                      in.offset);
  }
  Status call(Rows& rows, const BarrierInput& in) const override {
    const rme::PointMotion<double, 7> point = {in.position, in.velocity, in.jacobian, in.velocity_product};
    const rme::BarrierPoles<double> poles(8, 40);
    const auto barrier = rows.size() % 2 == 0
                             ? rme::half_space_barrier<double, 7>(point, in.normal, in.offset)
                             : rme::sphere_barrier<double, 7>(point, in.center, 0.3, rme::SphereSide::Outside);
    const Status status = add_barrier(barrier, in.dq, poles, rows, rows.size() % 3 == 0 ? 10.0 : Rows::kHard);
    if (rows.size() > 20) rows.clear();
    return status;
  }
  VectorXd answers(const Rows& rows) const override { return contents(rows); }
};

TEST_CASE("add_barrier: a plane or a sphere seen with bad numbers makes no row, or one without a NaN", "[robustness]") {
  check_loop_call(Barrier(), 7, 5000);
}

struct NullSpaces final : LoopCall<rme::NullSpace<double, 7>, Jacobian7> {
  using Object = rme::NullSpace<double, 7>;
  Object make() const override { return Object(); }
  Jacobian7 good(Random& random) const override { return gaussian<Jacobian7>(random, 0.5); }
  Entries entries(Jacobian7& in) const override { return entries_of(in); }
  Status call(Object& object, const Jacobian7& in) const override { return object.update(in); }
  VectorXd answers(const Object& object) const override {
    return joined(object.projector(), object.clearance(), object.damping());
  }
};

TEST_CASE("NullSpace: the projector is finite whatever the Jacobian", "[robustness]") {
  check_loop_call(NullSpaces(), 8, 20000);
}

/// A pool of arms with some rows each, and a posture whose torque comes from the joints' state.
struct ControlInput {
  rme::CpicInput<double, 7> input;
  Eigen::Matrix<double, 6, 1> wrench;
  Vector7 q, dq;
  Rows rows;
};
struct Control final : LoopCall<rme::Cpic<double, 7>, ControlInput> {
  using Object = rme::Cpic<double, 7>;
  std::vector<oracle::RandomArm<7, 28>> arms;
  const rme::Posture<double, 7> posture;
  Vector7 limit;

  Control() : posture({}) {
    std::mt19937 random(90);
    for (int i = 0; i < 64; ++i) arms.emplace_back(random, i % 3 == 0 ? 7 : 0, i % 6, i % 5 == 0 ? 2 : 40);
    limit = arms.front().torque_limit;
  }
  Object make() const override {
    rme::CpicConfig<double, 7> config;
    config.torque_limit = limit;
    return Object(config);
  }
  ControlInput good(Random& random) const override {
    const auto& arm = arms[rme::testing::below(random, arms.size())];
    ControlInput in{arm.input, arm.input.wrench.vector(), gaussian<Vector7>(random, 1), gaussian<Vector7>(random, 1),
                    arm.rows};
    if (random() % 8 == 0) in.input.jacobian.setZero();
    if (random() % 8 == 0) in.input.jacobian.row(static_cast<int>(random() % 6)).setZero();
    in.input.other_torque = gaussian<Vector7>(random, 3);
    return in;
  }
  Entries entries(ControlInput& in) const override {
    return entries_of(in.input.jacobian, in.input.mass_matrix, in.input.bias, in.input.other_torque, in.wrench, in.q,
                      in.dq);
  }
  Status call(Object& object, const ControlInput& in) const override {
    rme::CpicInput<double, 7> input = in.input;
    input.wrench = rme::Wrench<double>::from_vector(in.wrench);
    input.null_torque = posture.torque(in.q, in.dq);
    return object.update(input, in.rows);
  }
  bool refused(Status status) const override {
    return status == Status::NonFiniteInput || status == Status::NotPositiveDefinite;
  }
  VectorXd answers(const Object& object) const override {
    return joined(object.torque(), object.unconstrained_torque(), object.null_space().projector());
  }
};

TEST_CASE("Cpic: bad numbers never reach the torque, and what was refused is forgotten", "[robustness]") {
  check_loop_call(Control(), 9, 20000);
}

TEST_CASE("Cpic: the torque keeps its limits whatever comes in", "[robustness]") {
  const Control subject;
  const unsigned seed = 10;
  CAPTURE(seed);
  Random random(seed);
  auto cpic = subject.make();
  int at_limit = 0;
  for (int tick = 0; tick < 20000; ++tick) {
    CAPTURE(tick);
    ControlInput in = subject.good(random);
    const Entries entries = entries_of(in.input.jacobian, in.input.mass_matrix, in.input.bias, in.wrench, in.q, in.dq);
    if (tick % 2 == 0) rme::testing::spoil(entries, random);
    if (tick % 5 == 0) {  // a host's own row, of numbers that add() takes
      Vector7 gradient = gaussian<Vector7>(random, 1);
      double bound = -100;
      rme::testing::spoil(entries_of(gradient, bound), random);
      (void)in.rows.add(gradient, bound);
    }
    const Vector7 before = cpic.torque();
    const Status status = subject.call(cpic, in);
    if (subject.refused(status)) {
      REQUIRE(cpic.torque() == before);
      continue;
    }
    const Vector7 total = (cpic.torque() + in.input.other_torque).cwiseAbs();
    REQUIRE((total.array() <= subject.limit.array() + 1e-9).all());
    at_limit += (total.array() >= subject.limit.array() - 1e-9).any();
  }
  CHECK(at_limit > 1000);
}

struct Ramp final : LoopCall<rme::CompensationRamp<double, 7>, Vector7> {
  using Object = rme::CompensationRamp<double, 7>;
  Object make() const override { return Object(kPeriod); }
  Vector7 good(Random& random) const override { return gaussian<Vector7>(random, 5); }
  Entries entries(Vector7& in) const override { return entries_of(in); }
  Status call(Object& object, const Vector7& in) const override { return object.update(in); }
  VectorXd answers(const Object& object) const override { return object.torque(); }
  bool within_bounds(const Object& before, const Object& after) const override {
    return ((after.torque() - before.torque()).cwiseAbs().array() <= 0.5 + 1e-9).all();
  }
};

TEST_CASE("CompensationRamp: no tick steps beyond the rate, whatever the target", "[robustness]") {
  check_loop_call(Ramp(), 11, 20000);
}

struct TankInput {
  Vector7 q, torque;
  double potential;
};
struct Tank final : LoopCall<rme::EnergyTank<double, 7>, TankInput> {
  using Object = rme::EnergyTank<double, 7>;
  Object make() const override { return Object(kPeriod); }
  TankInput good(Random& random) const override {
    return {gaussian<Vector7>(random, 0.1), gaussian<Vector7>(random, 10), std::normal_distribution<double>()(random)};
  }
  Entries entries(TankInput& in) const override { return entries_of(in.q, in.torque, in.potential); }
  Status call(Object& object, const TankInput& in) const override {
    return object.update(in.q, in.torque, in.potential);
  }
  VectorXd answers(const Object& object) const override {
    return joined(object.share(), object.energy(), object.torque());
  }
  bool within_bounds(const Object& /*before*/, const Object& after) const override {
    const double rounding = 1e-15 * rme::kLargestPlausible;  // of a potential beside which the capacity is small
    return after.share() >= 0 && after.share() <= 1 && after.energy() <= 12 + rounding;
  }
};

TEST_CASE("EnergyTank: never lets through more than all, nor holds more than its capacity", "[robustness]") {
  check_loop_call(Tank(), 12, 20000);
}

struct MonitorInput {
  double storage, power;
};
struct Monitor final : LoopCall<rme::PassivityMonitor<double>, MonitorInput> {
  using Object = rme::PassivityMonitor<double>;
  Object make() const override { return Object(kPeriod); }
  MonitorInput good(Random& random) const override {
    std::normal_distribution<double> normal;
    return {std::abs(normal(random)), 10 * normal(random)};
  }
  Entries entries(MonitorInput& in) const override { return entries_of(in.storage, in.power); }
  Status call(Object& object, const MonitorInput& in) const override { return object.update(in.storage, in.power); }
  VectorXd answers(const Object& object) const override {
    return joined(object.storage(), object.supplied(), object.residual(), object.power_residual());
  }
};

TEST_CASE("PassivityMonitor: the books stay finite, whatever is to be entered", "[robustness]") {
  check_loop_call(Monitor(), 13, 20000);
}

}  // namespace
