// The core in float, as a microcontroller has it: without exceptions and run-time types, each part against a closed
// form or against itself in double. Prints what fails; the exit code says how many did.
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <random>
#include <rme/rme.hpp>
#include <type_traits>

#include "network/golden.hpp"
// One translation unit, for a compiler that is not this build's.
#include "support/random_events.cpp"  // NOLINT(bugprone-suspicious-include)

namespace {

using rme::Status;
using Random = std::mt19937_64;
using Vector3 = rme::Vector3<float>;
using Vector6 = rme::Vector6<float>;
using Vector7 = rme::JointVector<float, 7>;
using Jacobian7 = rme::Jacobian<float, 7>;

constexpr float kPeriod = 1e-3F;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

template <typename Matrix>
Matrix gaussian(Random& random, float deviation = 1) {
  std::normal_distribution<float> normal(0, deviation);
  return Matrix::NullaryExpr([&] { return normal(random); });
}

template <typename A, typename B>
bool near(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b, double tolerance) {
  return (a.template cast<double>() - b.template cast<double>()).norm() <= tolerance;
}
bool near(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance;
}

// Sensing.

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

bool window_takes_the_observers_lag_out() {
  rme::SampleWindow<float, 7> window(1e-3);
  rme::Proprioception<float, 7> sample;
  for (int k = 0; k < 500; ++k) {
    const float tau = k < 250 ? 1.0F : 4.0F;
    sample.tau_ext[0] += 0.05F * (tau - sample.tau_ext[0]);
    if (window.push(sample) != Status::Ok) return false;
    // Differences of numbers of size 4 are divided by 0.05: 20 units of the last place of 4, and one of the sum.
    if (k > 0 && !near(window.newest().tau[0], tau, 25 * 4 * std::numeric_limits<float>::epsilon())) return false;
  }
  return true;
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
    if (rme::pseudo_wrench<float, 7>(J, J.transpose() * wrench, 1e-4F, w) != Status::Ok) return false;
    // W = (1 + lambda (J J^T)^-1)^-1 w, so that the torque left over is no more than sqrt(lambda) / 2 |w|.
    if (!near(J.transpose() * w.vector(), J.transpose() * wrench, 0.006 * wrench.norm())) return false;
  }
  return true;
}

bool bad_samples_are_named() {
  rme::Proprioception<float, 7> sample;
  if (check(sample) != Status::Ok) return false;
  sample.rotation *= 1.01F;
  if (check(sample) != Status::NotARotation) return false;
  sample = {};
  sample.jacobian(2, 3) = 1e30F;
  if (check(sample) != Status::NonFiniteInput) return false;
  sample = {};
  sample.dq[6] = kNan;
  return check(sample) == Status::NonFiniteInput;
}

// Inference.

/// What a random event's samples say, summed in float.
bool event_likelihood(Random& random, rme::PayloadLikelihood<float>& likelihood, rme::Vector4<float>& truth) {
  const auto event = rme::testing::random_event(random);
  truth = event.truth.cast<float>();
  rme::PayloadStatistics<float, 7> statistics;
  for (const auto& o : event.samples) {
    rme::PayloadObservation<float, 7> cast;
    cast.tau = o.tau.cast<float>();
    cast.regressor.a = o.regressor.a.cast<float>();
    cast.regressor.B = o.regressor.B.cast<float>();
    statistics.add(cast);
  }
  rme::NuisanceGaussian<float, 7> nuisance;
  for (std::size_t j = 0; j < 7; ++j) {
    nuisance.mean[j] = event.nuisance.mean[j].cast<float>();
    nuisance.covariance[j] = event.nuisance.covariance[j].cast<float>();
  }
  return statistics.likelihood(event.precision.cast<float>(), nuisance, likelihood) == Status::Ok;
}
const rme::PayloadGaussian<float> kPrior{rme::testing::wide_prior().mean.cast<float>(),
                                         rme::testing::wide_prior().covariance.cast<float>()};

/// The truth within five of the exact posterior's deviations, and a solver's mean within half a one of the exact mean.
template <typename Config>
bool solver_finds_the_payload() {
  Random random(2);
  for (int k = 0; k < 30; ++k) {
    rme::PayloadLikelihood<float> likelihood;
    rme::Vector4<float> truth;
    rme::InferenceResult<float> exact, result;
    if (!event_likelihood(random, likelihood, truth)) return false;
    if (rme::infer(likelihood, kPrior, exact, rme::ExactQuadrature()) != Status::Ok) return false;
    if (rme::infer(likelihood, kPrior, result, Config()) != Status::Ok) return false;
    const Eigen::Array4f sd = exact.posterior.standard_deviation();
    if (!(((exact.posterior.mean - truth).array().abs() / sd).maxCoeff() < 5)) return false;
    if (!(((result.posterior.mean - exact.posterior.mean).array().abs() / sd).maxCoeff() < 0.5F)) return false;
  }
  return true;
}

bool published_likelihood_is_a_quarter_of_the_range() {
  // One joint with torque 0 .. 4 N m and a = 2: sigma = 1 N m, so that over 50 samples aa = 200 and ya = 2 sum y = 200.
  const auto at = [](int i) {
    rme::PayloadObservation<float, 7> o;
    o.tau[0] = 4 * float(i) / 49;
    o.regressor.a[0] = 2;
    return o;
  };
  rme::PayloadLikelihood<float> l;
  return rme::published_likelihood<float, 7>(50, at, l) == Status::Ok && near(l.aa, 200, 1e-2) && near(l.ya, 200, 1e-2);
}

bool object_and_push_are_told_apart() {
  Random random(6);
  const auto pose = rme::testing::random_pose(random);
  const Jacobian7 J = pose.jacobian.cast<float>();
  const auto regressor =
      rme::payload_regressor<float, 7>(J, pose.rotation.cast<float>(), rme::standard_gravity<float>());
  const rme::NuisanceGaussian<float, 7> nuisance = rme::SensorModel<float, 7>::link_side().prior();
  const Vector7 precision = Vector7::Constant(1 / (40 * 0.03F * 0.03F));  // noise that stays the same for 40 ticks
  // Log odds of the payload against a push.
  const auto odds = [&](const Vector7& tau) {
    rme::PayloadStatistics<float, 7> window;
    for (int k = 0; k < 200; ++k) window.add({tau + gaussian<Vector7>(random, 0.03F), regressor, {}, {}});
    rme::PayloadLikelihood<float> likelihood;
    rme::InferenceResult<float> payload;
    rme::PayloadStatistics<float, 7>::Marginals marginals;
    float push = 0;
    if (window.likelihood(precision, nuisance, likelihood) != Status::Ok ||
        rme::infer(likelihood, kPrior, payload, rme::ExactQuadrature()) != Status::Ok ||
        window.marginals(precision, nuisance, marginals) != Status::Ok ||
        rme::push_log_evidence<float, 7>(marginals, {}, J, {}, push) != Status::Ok)
      return kNan;
    // The one counts from an empty hand, the other does not.
    return payload.log_evidence + rme::payload_log_evidence(likelihood, rme::Payload<float>()) - push;
  };
  const Vector7 object = regressor.torque({1.2F, {0.02F, -0.03F, 0.12F}});
  const Vector7 push = J.transpose() * (Vector6() << 12, -9, 4, 0.5F, 0.8F, -1).finished();
  return odds(object) > 3 && odds(push) < -3;
}

bool offset_outlives_an_event_and_stiction_does_not() {
  const auto model = rme::SensorModel<float, 7>::joint_friction();  // offset and stiction of the same size
  rme::NuisanceGaussian<float, 7> baseline = model.prior();
  baseline.mean[0][0] = 0.4F;
  return near(model.after_event(baseline).mean[0][0], 0.2, 1e-6);
}

// Control.

bool compensation_carries_a_kilogram_and_the_ramp_lets_it_in() {
  Random random(7);
  const auto pose = rme::testing::random_pose(random);
  const auto tau =
      rme::compensation_torque<float, 7>({1, {0.1F, 0, 0}}, pose.jacobian.cast<float>(), pose.rotation.cast<float>());
  const Eigen::Vector3d weight(0, 0, -9.81);
  const rme::Vector6<double> w =
      (rme::Vector6<double>() << weight, (0.1 * pose.rotation.col(0)).cross(weight)).finished();
  if (!near(tau, -pose.jacobian.transpose() * w, 1e-5 * w.norm())) return false;
  rme::CompensationRamp<float, 7> ramp(kPeriod);
  for (int k = 0; k < 40; ++k) {
    const Vector7 before = ramp.torque();
    if (ramp.update(tau) != Status::Ok || (ramp.torque() - before).cwiseAbs().maxCoeff() > 0.5001F) return false;
  }
  return ramp.torque() == tau;
}

bool passive_force_spends_what_it_books() {
  Random random(8);
  rme::PassiveController<float> passive;
  const rme::LinearAttractor<float> attractor({Vector3(0.4F, 0, 0.5F), 1, 0.5F});
  const rme::LimitCycle<float> cycle({});
  for (int k = 0; k < 200; ++k) {
    const Vector3 x = gaussian<Vector3>(random, 0.3F);
    const auto twist = rme::Twist<float>::from_vector(gaussian<Vector6>(random, 0.3F));
    const auto flow = k % 2 == 0 ? attractor(x) : cycle(x);
    if (passive.update(flow, {}, twist) != Status::Ok) return false;
    // F . xdot = lambda_1 (-grad V . xdot) + injected - dissipated
    const double power = passive.wrench().vector().dot(twist.vector());
    const double books =
        60.0 * flow.conservative.dot(twist.linear) + passive.injected_power() - passive.dissipated_power();
    if (!near(power, books, 1e-4 * (1 + std::abs(power) + passive.dissipated_power()))) return false;
  }
  return true;
}

bool flows_keep_their_speed_and_their_circle() {
  const rme::LinearAttractor<float> attractor({Vector3::Zero(), 1, 0.5F});
  if (!(attractor(Vector3(100, 0, 0)).velocity.norm() <= 0.5F)) return false;
  const rme::LimitCycle<float> cycle({});  // radius 0.1 m in the y-z plane, 1 rad/s
  const auto on = cycle(Vector3(0, 0.1F, 0));
  return near(on.velocity, Vector3(0, 0, 0.1F), 1e-7) && near(on.potential, 0, 1e-7);
}

bool orientation_turns_with_the_sine_of_the_angle() {
  const rme::OrientationAttractor<float> turning({});
  const rme::Matrix3<float> R = Eigen::AngleAxisf(0.5F, Vector3::UnitZ()).toRotationMatrix();
  return near(turning(R).velocity, Vector3(0, 0, -2 * std::sin(0.5F)), 1e-6);
}

bool null_space_makes_no_wrench() {
  Random random(9);
  rme::NullSpace<float, 7> null_space;
  for (int k = 0; k < 100; ++k) {
    const Jacobian7 J = gaussian<Jacobian7>(random);
    if (null_space.update(J) != Status::Ok) return false;
    const rme::JointMatrix<float, 7>& N = null_space.projector();
    if (!((J * N).norm() <= 1e-5F * J.norm() + 0.5F * null_space.damping())) return false;
    if (null_space.damping() == 0 && !near(N * N, N, 1e-5)) return false;
  }
  return true;
}

/// J = M = 1: the accelerations that are asked for are the torques, and the nearest ones in a box are those cut off.
bool cpic_cuts_off_what_a_box_does_not_allow() {
  Random random(10);
  rme::CpicConfig<float, 6> config;
  config.torque_limit.setConstant(20);
  rme::Cpic<float, 6> cpic(config);
  rme::CpicInput<float, 6> input;
  input.jacobian.setIdentity();
  input.mass_matrix.setIdentity();
  input.bias.setZero();
  for (int k = 0; k < 200; ++k) {
    const Vector6 wrench = gaussian<Vector6>(random, 15);
    input.wrench = rme::Wrench<float>::from_vector(wrench);
    rme::Cpic<float, 6>::Rows rows;
    for (int j = 0; j < 3; ++j)
      if (rows.add_axis(j, -10, 10) != Status::Ok) return false;
    if (cpic.update(input, rows) != Status::Ok) return false;
    Vector6 expected = wrench.cwiseMax(-20).cwiseMin(20);
    expected.head<3>() = expected.head<3>().cwiseMax(-10).cwiseMin(10);
    if (!near(cpic.torque(), expected, 1e-4)) return false;
  }
  return true;
}

/// x + y >= 1 and -x + y >= 2 are 1e-6 apart in the metric of P, which a product of them would lose in float.
bool solver_tells_rows_apart_that_the_metric_brings_together() {
  using Vector2 = Eigen::Vector2f;
  rme::ActiveSetSolver<float, 2, 2> solver;
  rme::ActiveSetSolver<float, 2, 2>::Rows rows;
  if (rows.add({1, 1}, 1) != Status::Ok || rows.add({-1, 1}, 2) != Status::Ok) return false;
  const Eigen::Matrix2f P = Vector2(500, 5e-4F).asDiagonal();
  if (solver.solve(P, Vector2::Zero(), rows, Vector2::Constant(-100), Vector2::Constant(100)) != Status::Ok)
    return false;
  return (solver.solution() - Vector2(-0.5F, 1.5F)).norm() < 1e-5F;
}

bool barriers_ask_for_what_their_poles_say() {
  rme::PointMotion<float, 7> point;
  point.position = Vector3(0, 0, 0.5F);
  point.velocity = Vector3(0, 0, -0.2F);
  point.jacobian.setZero();
  point.jacobian(2, 0) = 1;
  point.velocity_product.setZero();
  Vector7 dq = Vector7::Zero();
  dq[0] = -0.2F;
  rme::ConstraintRows<float, 7, 28> rows;
  const auto wall = rme::half_space<float, 7>(point, Vector3::UnitZ(), 0.4F);
  if (rme::add_barrier(wall, dq, {8.0F, 40.0F}, rows) != Status::Ok) return false;
  // -k_1 h - k_2 h' = -320 * 0.1 + 48 * 0.2
  if (!near(rows[0].lower, -22.4, 1e-4) || rows[0].a != Vector7::Unit(0)) return false;
  const rme::JointLimits<float, 7> limits({Vector7::Constant(-1), Vector7::Constant(1)});
  if (limits.append(Vector7::Zero(), Vector7::Zero(), rows) != Status::Ok) return false;
  return rows.size() == 8 && near(rows[1].lower, -320, 1e-3) && near(rows[7].upper, 320, 1e-3);
}

bool tank_and_monitor_keep_their_books() {
  rme::EnergyTank<float> tank(kPeriod);
  rme::PassivityMonitor<float> monitor(kPeriod);
  float out = 0;
  for (int k = 0; k < 20000; ++k) {
    if (tank.update(10) != Status::Ok) return false;
    out += tank.share() * 10 * kPeriod;
  }
  if (!(out <= 12.01F && tank.energy() >= 0)) return false;
  for (int k = 0; k <= 1000; ++k)  // a storage that takes all of a constant power
    if (monitor.update(2 * kPeriod * float(k), 2) != Status::Ok) return false;
  return near(monitor.residual(), 0, 1e-3) && monitor.update(kNan, 0) == Status::NonFiniteInput;
}

// The network, and the whole.

bool network_is_that_of_pytorch() {
  // The first of tests/data/network/golden_random.json.
  constexpr float kExpected[3][4] = {{-0.0939913F, -0.3688846F, 0.3590341F, -0.2450129F},
                                     {-0.3354283F, -0.6714211F, 0.6026367F, -0.1064261F},
                                     {-0.0041642F, -0.2385577F, 0.2878608F, -0.0835486F}};
  const auto weights = golden::random_weights<float>();
  const auto network = std::make_unique<rme::MismatchNetwork<float>>(*weights);
  const std::vector<double> mean(weights->normalization_mean.begin(), weights->normalization_mean.end());
  const std::vector<double> std(weights->normalization_std.begin(), weights->normalization_std.end());
  const auto windows = golden::random_windows(mean, std, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    rme::MismatchNetwork<float>::Output out;
    if (network->forward(windows[k].cast<float>(), out) != Status::Ok) return false;
    if (!near(out, Eigen::Map<const Eigen::Vector4f>(kExpected[k]), 2e-5)) return false;
  }
  return true;
}

bool self_attention_takes_the_mean_of_equal_samples() {
  rme::SelfAttention<float, 4, 8, 2> attention;
  Random random(11);
  attention.in_proj.weight = gaussian<Eigen::Matrix<float, 24, 8>>(random);
  attention.out_proj.weight.setIdentity();
  const Eigen::Matrix<float, 8, 1> x = gaussian<Eigen::Matrix<float, 8, 1>>(random);
  Eigen::Matrix<float, 8, 4> in, out;
  in.colwise() = x;  // of the same sample four times the mean is its value
  attention.forward(in, out);
  const Eigen::Matrix<float, 8, 1> value = attention.in_proj.weight.bottomRows<8>() * x;
  return near(out.col(0), value, 1e-5 * value.norm()) && near(out.col(3), value, 1e-5 * value.norm());
}

/// An arm of seven joints that no wrench is hidden from.
struct TrackedHand {
  rme::Estimator<float, 7> estimator{0.001};
  rme::Proprioception<float, 7> sample;
  TrackedHand() { sample.jacobian.leftCols<6>().setIdentity(); }
  bool hold(const Vector6& wrench, int ticks) {
    for (; ticks > 0; --ticks) {
      sample.tau_ext += 0.05F * (sample.jacobian.transpose() * wrench - sample.tau_ext);
      if (estimator.update(sample) != Status::Ok) return false;
    }
    return true;
  }
};

bool tracker_finds_carries_and_lets_go() {
  const auto hand = std::make_unique<TrackedHand>();
  const auto& state = hand->estimator.state();
  const rme::Payload<float> kilogram{1, {0.02F, 0, 0.1F}};
  const Vector6 weight = rme::payload_wrench(kilogram, hand->sample.rotation).vector();
  if (!hand->hold(Vector6::Zero(), 500) || !state.empty() || !hand->hold(weight, 200)) return false;
  if (state.empty() || !near(state.payload.mean[0], 1, 0.02) || !near(state.payload.mean[1], 0.02, 0.005)) return false;
  const auto carried = hand->estimator.compensation(hand->sample.jacobian, hand->sample.rotation);
  if (!near(carried.head<6>(), -weight, 0.3)) return false;
  auto bad = hand->sample;
  bad.tau_ext[3] = kNan;
  if (hand->estimator.update(bad) != Status::NonFiniteInput) return false;
  return hand->hold(Vector6::Zero(), 200) && state.empty() && state.event.kind == rme::EventKind::Removed;
}

bool tracker_is_not_fooled_by_a_push() {
  const auto hand = std::make_unique<TrackedHand>();
  const auto& state = hand->estimator.state();
  const Vector6 push = (Vector6() << 12, -9, 3, 0, 1, 0).finished();
  return hand->hold(Vector6::Zero(), 500) && hand->hold(push, 500) && near(state.payload.mean[0], 0, 0.05) &&
         hand->hold(Vector6::Zero(), 500) && state.empty() && state.event.kind == rme::EventKind::Pushed;
}

struct Case {
  const char* name;
  bool (*passes)();
};

const Case kCases[] = {
    {"MismatchDetector: sees a step once it has settled", detector_sees_a_step_when_it_has_settled},
    {"SampleWindow: the observer's lag taken out", window_takes_the_observers_lag_out},
    {"MomentumObserver: a step through its filter", observer_shows_a_step_through_its_filter},
    {"pseudo_wrench: the wrench that made the torque", pseudo_wrench_is_the_wrench_that_made_the_torque},
    {"check: bad samples are named", bad_samples_are_named},
    {"infer: quadrature and full covariance find the payload",
     solver_finds_the_payload<rme::VariationalInferenceConfig>},
    {"infer: mean field finds the payload", solver_finds_the_payload<rme::MeanFieldConfig>},
    {"published_likelihood: a quarter of the range", published_likelihood_is_a_quarter_of_the_range},
    {"push_log_evidence: object and push told apart", object_and_push_are_told_apart},
    {"SensorModel: the offset outlives an event, stiction does not", offset_outlives_an_event_and_stiction_does_not},
    {"compensation_torque, CompensationRamp: a kilogram let in",
     compensation_carries_a_kilogram_and_the_ramp_lets_it_in},
    {"PassiveController: spends what it books", passive_force_spends_what_it_books},
    {"LinearAttractor, LimitCycle: speed and circle", flows_keep_their_speed_and_their_circle},
    {"OrientationAttractor: the sine of the angle", orientation_turns_with_the_sine_of_the_angle},
    {"NullSpace: makes no wrench", null_space_makes_no_wrench},
    {"Cpic: cuts off what a box does not allow", cpic_cuts_off_what_a_box_does_not_allow},
    {"ActiveSetSolver: rows that the metric brings together", solver_tells_rows_apart_that_the_metric_brings_together},
    {"add_barrier, JointLimits: what their poles say", barriers_ask_for_what_their_poles_say},
    {"EnergyTank, PassivityMonitor: their books", tank_and_monitor_keep_their_books},
    {"MismatchNetwork: as in PyTorch", network_is_that_of_pytorch},
    {"SelfAttention: the mean of equal samples", self_attention_takes_the_mean_of_equal_samples},
    {"Estimator: finds, carries, lets go", tracker_finds_carries_and_lets_go},
    {"Estimator: not fooled by a push", tracker_is_not_fooled_by_a_push},
};

}  // namespace

int main() {
  int failed = 0, count = 0;
  for (const Case& c : kCases) {
    ++count;
    if (c.passes()) continue;
    ++failed;
    std::printf("FAILED %s\n", c.name);
  }
  std::printf("%d cases in float, %d failed\n", count, failed);
  return failed;
}
