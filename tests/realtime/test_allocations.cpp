#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <random>
#include <rme/rme.hpp>
#include <utility>
#include <vector>

#include "control/random_arm.hpp"
#include "network/golden.hpp"
#include "support/allocation_count.hpp"
#include "support/catch.hpp"
#include "support/held_arm.hpp"

namespace {

using rme::Status;
using rme::testing::HeldArm;
using Vector7 = rme::JointVector<double, 7>;
using Jacobian7 = rme::Jacobian<double, 7>;
using Tick = rme::Proprioception<double, 7>;
using Gaussian = rme::PayloadGaussian<double>;
using Statistics = rme::PayloadStatistics<double, 7>;
using Prior = rme::NetworkPrior<double>;

constexpr double kPeriod = HeldArm::kPeriod;

#ifdef RME_COUNTS_ALLOCATIONS

/// Runs a loop, in which nothing may be CHECKed (Catch2 allocates), and says how often it went to the heap.
template <typename Loop>
int allocations_of(const Loop& loop) {
  const int before = allocations;
  loop();
  return allocations - before;
}

struct alignas(64) Wide {
  double values[8];
};

TEST_CASE("Allocations: whatever goes to the heap is counted", "[realtime]") {
  void* volatile kept = nullptr;  // or the compiler leaves the pairs out
  CHECK(allocations_of([&] { std::free(kept = std::malloc(8)); }) == 1);
  CHECK(allocations_of([&] { std::free(kept = std::calloc(1, 8)); }) == 1);
  CHECK(allocations_of([&] { std::free(kept = std::realloc(nullptr, 8)); }) == 1);
  CHECK(allocations_of([&] { ::operator delete(kept = ::operator new(8)); }) == 1);
  CHECK(allocations_of([&] { std::vector<Wide>(3).swap(*std::make_unique<std::vector<Wide>>()); }) == 2);
  CHECK(allocations_of([&] { Eigen::MatrixXd::Random(3, 3).eval(); }) == 1);
}

/// Six seconds in the life of an arm: an object comes, a hand pushes, the arm moves, the object goes.
std::vector<Tick> life(std::uint64_t seed) {
  HeldArm arm(seed);
  std::vector<Tick> ticks;
  for (int k = 0; k < 6000; ++k) {
    if (k == 1000) arm.hold({1.1, {0.05, 0.02, 0.13}});
    if (k == 2000) arm.push({{10, -8, 0}, Eigen::Vector3d::Zero()});
    if (k == 2800) arm.push({});
    if (k == 3600) arm.move(arm.pose() + 0.3 * Vector7::Ones(), 0.8);
    if (k == 4800) arm.hold({});
    ticks.push_back(arm.tick());
  }
  return ticks;
}

/// Some samples are no good.
void spoil(std::vector<Tick>& ticks) {
  for (std::size_t k = 5; k < ticks.size(); k += 97) ticks[k].tau_ext[int(k % 7)] = std::nan("");
  for (std::size_t k = 6; k < ticks.size(); k += 101) ticks[k].rotation *= 1.1;
}

/// A network with much to compute that always guesses the same, and the prior that it makes.
struct NetworkAndPrior {
  NetworkAndPrior() {
    const auto weights = golden::random_weights<double>();
    weights->head_weight.fill(0);
    weights->head_bias = {1, 0, 0, 0.1};
    network = std::make_unique<rme::MismatchNetwork<double>>(*weights);
    rme::NetworkPriorConfig<double> config;
    config.farthest = 1e6;
    prior = std::make_unique<Prior>(*network, kPeriod, config);
  }
  std::unique_ptr<rme::MismatchNetwork<double>> network;
  std::unique_ptr<Prior> prior;
};

TEST_CASE("Allocations: none in the estimator with a network, from the first tick to reset", "[realtime]") {
  const std::uint64_t seed = 301;
  CAPTURE(seed);
  auto ticks = life(seed);
  spoil(ticks);
  const NetworkAndPrior with;
  rme::Estimator<double, 7, Prior> estimator(kPeriod, {}, *with.prior);
  rme::CompensationRamp<double, 7> ramp(kPeriod);
  rme::EnergyTank<double> tank(kPeriod);
  int estimates = 0, early = 0, rejections = 0, refused = 0;
  double largest = 0;
  const int count = allocations_of([&] {
    for (int round = 0; round < 3; ++round) {
      for (std::size_t k = 0; k < ticks.size(); ++k) {
        if (round == 1 && k == 900) estimator.tare(0.5);
        if (round == 2 && k % 1000 == 990) estimator.trigger();
        refused += estimator.update(ticks[k]) != Status::Ok;
        estimates += estimator.estimated();
        early += estimator.refreshed();
        rejections += estimator.rejected();
        refused += ramp.update(estimator.compensation(ticks[k].jacobian, ticks[k].rotation)) != Status::Ok;
        refused += tank.update(ticks[k].dq.dot(ramp.torque())) != Status::Ok;
        largest = std::max(largest, tank.share() * ramp.torque().norm());
      }
      estimator.reset();
    }
  });
  CHECK(count == 0);
  CHECK(estimates >= 6);
  CHECK(early > 20);
  CHECK(rejections >= 2);
  CHECK(refused > 300);
  CHECK(largest > 1);
}

TEST_CASE("Allocations: none in what the estimator is made of", "[realtime]") {
  const std::uint64_t seed = 302;
  CAPTURE(seed);
  auto ticks = life(seed);
  spoil(ticks);
  const NetworkAndPrior with;
  const rme::EstimatorConfig<double, 7> config;
  rme::SampleWindow<double, 7> window(kPeriod);
  rme::MismatchDetector<7> detector(kPeriod);
  rme::MismatchDetector<1> published(kPeriod, rme::MismatchDetectorConfig::published());
  rme::WindowStatistics<double, 7> sums(40);
  rme::EventInference<double, 7> inference(kPeriod, config.sensors, config.push, config.inference);
  rme::Wrench<double> wrench;
  rme::ModelAverage<double> average;
  int detected = 0, asked = 0, inferred = 0;
  double onsets = 0;
  const int count = allocations_of([&] {
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      if (window.push(ticks[k]) != Status::Ok) continue;
      const auto& sample = window.newest();
      const bool watched = detector.update(sample.tau) == Status::Ok;
      const bool heard = published.update(Eigen::Matrix<double, 1, 1>(sample.raw.tau_ext.norm())) == Status::Ok;
      detected += watched && heard && (detector.detected() || published.detected());
      const auto regressor = rme::payload_regressor<double, 7>(sample.raw.jacobian, sample.raw.rotation, config.gravity,
                                                               sample.motion, config.gyration_radius);
      sums.add({sample.tau, regressor, sample.direction, sample.raw.dq});
      if (k % 500 != 499) continue;
      const Gaussian prior = (*with.prior)(window, 400);
      asked += prior.mean == Eigen::Vector4d(1, 0, 0, 0.1);
      const Statistics about = sums.about(prior.mean.tail<3>());
      inference.learn_baseline(about);
      const auto verdict = inference.judge(about, about, prior, {}, sample.raw.jacobian, average);
      inferred += !average.empty() && !inference.posterior(about, prior).empty() && std::isfinite(verdict.log_odds());
      inference.forget_baseline();
      onsets += rme::find_onset(window, 600, 10).jump + rme::unrest(window, 200);
      if (rme::pseudo_wrench(sample.raw.jacobian, sample.raw.tau_ext, 0.01, wrench) == Status::Ok)
        wrench = rme::in_end_effector_axes(wrench, sample.raw.rotation);
      sums.clear();
    }
    window.reset();
    detector.reset();
  });
  CHECK(count == 0);
  CHECK(detected > 0);
  CHECK(asked > 5);
  CHECK(inferred > 5);
  CHECK(onsets > 1);
}

TEST_CASE("Allocations: none in the four solvers and the published likelihood", "[realtime]") {
  const std::uint64_t seed = 303;
  CAPTURE(seed);
  const auto ticks = life(seed);
  const auto observation = [&](int i) {
    const Tick& tick = ticks[1501 + static_cast<std::size_t>(i)];
    return rme::PayloadObservation<double, 7>{
        tick.tau_ext, rme::payload_regressor<double, 7>(tick.jacobian, tick.rotation, rme::standard_gravity<double>()),
        Vector7::Zero(), Vector7::Zero()};
  };
  const Gaussian prior = rme::FixedPrior<double>().gaussian;
  rme::PayloadLikelihood<double> likelihood;
  rme::InferenceResult<double> result;
  std::mt19937_64 random(seed);
  double mass[4] = {};
  int solved = 0;
  const int count = allocations_of([&] {
    solved += rme::published_likelihood<double, 7>(90, observation, likelihood) == Status::Ok;
    solved += rme::infer(likelihood, prior, result, rme::VariationalInferenceConfig()) == Status::Ok;
    mass[0] = result.posterior.mean[0];
    solved += rme::infer(likelihood, prior, result, rme::MeanFieldConfig()) == Status::Ok;
    mass[1] = result.posterior.mean[0];
    solved += rme::infer(likelihood, prior, result, rme::ExactQuadrature()) == Status::Ok;
    mass[2] = result.posterior.mean[0];
    const Status stochastic = rme::infer(likelihood, prior, result, rme::StochasticViConfig(), random);
    solved += stochastic == Status::Ok || stochastic == Status::NotConverged;
    mass[3] = result.posterior.mean[0];
  });
  CHECK(count == 0);
  CHECK(solved == 5);
  for (const double m : mass) CHECK(m == Approx(1.1).margin(0.2));
}

TEST_CASE("Allocations: none in the controller, feasible or not", "[realtime]") {
  const unsigned seed = 304;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::vector<oracle::RandomArm<7, 28>> arms;
  for (int i = 0; i < 300; ++i) arms.emplace_back(random, i % 2 == 0 ? 7 : 0, i % 12, i % 5 == 0 ? 2 : 40);

  rme::CpicConfig<double, 7> config;
  config.torque_limit = arms.front().torque_limit;
  rme::Cpic<double, 7> cpic(config);
  rme::NullSpace<double, 7> null_space;
  rme::MomentumObserver<double, 7> observer(kPeriod);
  rme::PassiveController<double> passive;
  const rme::LinearAttractor<double> attractor({Eigen::Vector3d::Ones(), 1, 0.5});
  const rme::LimitCycle<double> cycle({});
  const rme::OrientationAttractor<double> turning({});
  const rme::Posture<double, 7> posture({});
  const rme::JointLimits<double, 7> limits({Vector7::Constant(-2), Vector7::Constant(2)});
  rme::CompensationRamp<double, 7> ramp(kPeriod);
  rme::EnergyTank<double> tank(kPeriod);
  rme::PassivityMonitor<double> monitor(kPeriod);
  rme::Cpic<double, 7>::Rows rows;
  int ok = 0, infeasible = 0, active = 0, refused = 0;
  const int count = allocations_of([&] {
    for (std::size_t i = 0; i < arms.size(); ++i) {
      const auto& arm = arms[i];
      rme::CpicInput<double, 7> input = arm.input;
      const Vector7 q = 0.1 * input.null_torque, dq = 0.05 * input.bias;
      const rme::PointMotion<double, 7> point = {Eigen::Vector3d(0.4, 0, 0.4), input.jacobian.topRows<3>() * dq,
                                                 input.jacobian.topRows<3>(), Eigen::Vector3d::Zero()};
      const auto twist = rme::Twist<double>::from_vector(input.jacobian * dq);
      refused += observer.update(input.null_torque, dq, input.mass_matrix, input.bias, input.bias) != Status::Ok;
      const auto flow = i % 2 == 0 ? rme::flow_at(attractor, point.position) : rme::flow_at(cycle, point.position);
      refused += passive.update(flow, turning(Eigen::Matrix3d::Identity()), twist) != Status::Ok;

      // The random arm's own rows can be kept; those of walls and limits beside them make some sets contradictory.
      rows = arm.rows;
      if (i % 3 == 0) {
        const rme::BarrierPoles<double> poles(8, 40);
        refused += limits.append(q, dq, rows) != Status::Ok;
        const auto wall = rme::half_space<double, 7>(point, Eigen::Vector3d::UnitZ(), 0.39);
        const auto ball = rme::sphere<double, 7>(point, Eigen::Vector3d::UnitX(), 0.5, rme::SphereSide::Outside);
        refused += rme::add_barrier(wall, dq, poles, rows) != Status::Ok;
        refused += rme::add_barrier(ball, dq, poles, rows, 100.0) != Status::Ok;
        input.wrench = passive.wrench();
      }
      input.null_torque = posture.torque(q, dq);
      refused += null_space.update(input.jacobian) != Status::Ok;
      const auto carried =
          rme::compensation_torque<double, 7>({1.1, {0, 0, 0.1}}, input.jacobian, Eigen::Matrix3d::Identity());
      refused += ramp.update(carried) != Status::Ok;
      input.other_torque = ramp.torque() / (1 + ramp.torque().norm());
      const Status status = cpic.update(input, rows);
      ok += status == Status::Ok;
      infeasible += status == Status::Infeasible;
      active += cpic.active_count();
      refused += tank.update(dq.dot(ramp.torque())) != Status::Ok;
      refused += monitor.update(rme::kinetic_energy(input.mass_matrix, dq) + passive.potential_energy(),
                                dq.dot(observer.tau_ext())) != Status::Ok;
    }
    cpic.reset();
    observer.reset();
    monitor.reset();
  });
  CHECK(count == 0);
  CHECK(ok > 100);
  CHECK(infeasible > 10);
  CHECK(active > 300);
  CHECK(refused == 0);
  CHECK(null_space.clearance() > 0);
}

#endif

// The calls of a loop whose own tests do not say that they cannot throw.
template <typename T>
const T& a() noexcept;
template <typename T>
T& my() noexcept;

using Vector3 = rme::Vector3<double>;
using Matrix3 = rme::Matrix3<double>;
using Matrix7 = rme::JointMatrix<double, 7>;
using Rows = rme::ConstraintRows<double, 7, 28>;
using Flow = rme::Flow<double>;
using Point = rme::PointMotion<double, 7>;
using Detector = rme::MismatchDetector<7>;
using Likelihood = rme::PayloadLikelihood<double>;
using Result = rme::InferenceResult<double>;
using Solver = rme::ActiveSetSolver<double, 7, 28>;

static_assert(noexcept(my<rme::RingBuffer<double>>().push(1.0)) && noexcept(a<rme::RingBuffer<double>>().newest()));
static_assert(noexcept(rme::payload_wrench(a<rme::Payload<double>>(), a<Matrix3>())));
static_assert(noexcept(my<Detector>().update(a<Detector::Signal>())) && noexcept(my<Detector>().reset()));
static_assert(noexcept(a<Detector>().detected()) && noexcept(a<Detector>().rapid_change()));
static_assert(noexcept(a<Prior>()(a<rme::SampleWindow<double, 7>>(), 1)));
static_assert(noexcept(a<rme::FixedPrior<double>>()(a<rme::SampleWindow<double, 7>>(), 1)));
static_assert(noexcept(rme::infer(a<Likelihood>(), a<Gaussian>(), my<Result>(), rme::MeanFieldConfig())));
static_assert(noexcept(rme::infer(a<Likelihood>(), a<Gaussian>(), my<Result>(), rme::ExactQuadrature())));
static_assert(noexcept(rme::infer(a<Likelihood>(), a<Gaussian>(), my<Result>(), rme::StochasticViConfig(),
                                  my<std::mt19937_64>())));
static_assert(noexcept(my<Statistics>().add(a<rme::PayloadObservation<double, 7>>())));
static_assert(noexcept(my<rme::Estimator<double, 7, Prior>>().update(a<Tick>())));

static_assert(noexcept(my<rme::PassiveController<double>>().update(a<Flow>(), a<Flow>(), a<rme::Twist<double>>())));
static_assert(noexcept(a<rme::LinearAttractor<double>>()(a<Vector3>())));
static_assert(noexcept(a<rme::LimitCycle<double>>()(a<Vector3>())));
static_assert(noexcept(a<rme::OrientationAttractor<double>>()(a<Matrix3>())));
static_assert(noexcept(rme::flow_at(a<rme::LimitCycle<double>>(), a<Vector3>())));
static_assert(noexcept(my<Rows>().add(a<Vector7>(), 0.0)) && noexcept(my<Rows>().add_axis(0, 0.0)));
static_assert(noexcept(rme::half_space<double, 7>(a<Point>(), a<Vector3>(), 0.0)));
static_assert(noexcept(rme::sphere<double, 7>(a<Point>(), a<Vector3>(), 1.0, rme::SphereSide::Inside)));
static_assert(noexcept(rme::add_barrier(a<rme::BarrierValue<double, 7>>(), a<Vector7>(), a<rme::BarrierPoles<double>>(),
                                        my<Rows>())));
static_assert(noexcept(a<rme::JointLimits<double, 7>>().append(a<Vector7>(), a<Vector7>(), my<Rows>())));
static_assert(noexcept(a<rme::Posture<double, 7>>().torque(a<Vector7>(), a<Vector7>())));
static_assert(noexcept(my<rme::NullSpace<double, 7>>().update(a<Jacobian7>())));
static_assert(noexcept(my<Solver>().solve(a<Matrix7>(), a<Vector7>(), a<Rows>(), a<Vector7>(), a<Vector7>())));
static_assert(noexcept(my<rme::Cpic<double, 7>>().reset()));
static_assert(noexcept(rme::compensation_torque<double, 7>(a<rme::Payload<double>>(), a<Jacobian7>(), a<Matrix3>())));
static_assert(noexcept(rme::kinetic_energy(a<Matrix7>(), a<Vector7>())));
static_assert(noexcept(my<rme::PassivityMonitor<double>>().update(1.0, 1.0)));

}  // namespace
