#include <algorithm>
#include <limits>
#include <random>
#include <rme/core/wrench.hpp>
#include <rme/inference/event_inference.hpp>
#include <rme/inference/window_statistics.hpp>
#include <stdexcept>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"
#include "support/random_events.hpp"

namespace {

using rme::testing::gaussian3;
using rme::testing::wide_prior;
using Inference = rme::EventInference<double, 7>;
using Model = rme::SensorModel<double, 7>;
using Payload = rme::Payload<double>;
using Torque = rme::JointVector<double, 7>;

constexpr double kPeriod = 1e-3;

/// An arm in one pose, whose torque follows `model` to the letter: offset for good, stiction drawn for each window.
class Bench {
 public:
  Bench(unsigned seed, const Model& model) : random_(seed), model_(model) {
    std::uniform_real_distribution<double> u(-1, 1);
    for (int j = 0; j < 7; ++j) {  // seven random joint axes within reach of the flange
      const Eigen::Vector3d axis = gaussian3(random_).normalized();
      jacobian_.col(j) << axis.cross(0.4 * Eigen::Vector3d(u(random_), u(random_), u(random_))), axis;
    }
    rotation_ = Eigen::AngleAxisd(3 * u(random_), gaussian3(random_).normalized()).toRotationMatrix();
    offset_ = model.offset.cwiseProduct(normal());
    coulomb_ = model.coulomb_mean + model.coulomb_std.cwiseProduct(normal());
  }

  const rme::Jacobian<double, 7>& jacobian() const { return jacobian_; }

  /// 200 samples at rest after a small motion in random directions.
  Inference::Statistics window(const Payload& payload, const Eigen::Vector3d& push = Eigen::Vector3d::Zero()) {
    rme::PayloadObservation<double, 7> o;
    o.regressor = rme::payload_regressor<double, 7>(jacobian_, rotation_, rme::standard_gravity<double>());
    o.direction = normal().cwiseSign();
    const Torque constant = o.regressor.torque(payload) + jacobian_.topRows<3>().transpose() * push + offset_ +
                            model_.stiction.cwiseProduct(normal()) - coulomb_.cwiseProduct(o.direction);
    // Noise that stays the same for twice the correlation time, 40 ticks, and has the model's deviation.
    rme::WindowStatistics<double, 7> sums(40);
    for (int tick = 0; tick < 200; ++tick) {
      if (tick % 40 == 0) o.tau = constant + model_.noise.cwiseProduct(normal());
      sums.add(o);
    }
    return sums.about(Eigen::Vector3d::Zero());
  }

 private:
  Torque normal() {
    return Torque::NullaryExpr([this] { return normal_(random_); });
  }

  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  Model model_;
  rme::Jacobian<double, 7> jacobian_;
  Eigen::Matrix3d rotation_;
  Torque offset_, coulomb_;
};

/// The noise is the models', unless it is to be learned.
Inference inference_of(const std::vector<Model>& models, bool learn_noise = false) {
  return {kPeriod, models, {}, {}, learn_noise};
}
Inference default_inference() {
  return inference_of({Model::link_side(), Model::joint_friction()});
}

TEST_CASE("EventInference: an object, an empty hand, a push and nothing at all are told apart", "[event_inference]") {
  const unsigned seed = 110;
  CAPTURE(seed);
  const Payload before{0.8, {0.03, -0.02, 0.1}}, after{1.5, {-0.02, 0.04, 0.12}};
  const Eigen::Vector3d sideways(10, -6, 0);  // no weight pulls across gravity
  int false_alarms = 0;
  for (unsigned k = 0; k < 50; ++k) {
    CAPTURE(k);
    Bench bench(seed + k, Model::link_side());
    Inference inference = default_inference();
    inference.learn_baseline(bench.window({}));
    const auto judge = [&](const Payload& known, const Payload& now, const Eigen::Vector3d& push) {
      const auto window = bench.window(now, push);
      return inference.judge(window, wide_prior(), known, bench.jacobian());
    };
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    struct Case {
      const char* what;
      Payload known, now;
      Eigen::Vector3d push;
      double rme::Verdict<double>::*best;
    };
    for (const Case& c : {Case{"picked up", {}, after, none, &rme::Verdict<double>::payload},
                          {"one more on top", before, after, none, &rme::Verdict<double>::payload},
                          {"put down", before, {}, none, &rme::Verdict<double>::empty},
                          {"pushed, empty", {}, {}, sideways, &rme::Verdict<double>::push},
                          {"pushed, loaded", before, before, sideways, &rme::Verdict<double>::push},
                          {"nothing, loaded", before, before, none, &rme::Verdict<double>::unchanged}}) {
      CAPTURE(c.what);
      const auto verdict = judge(c.known, c.now, c.push);
      CAPTURE(verdict.payload, verdict.empty, verdict.unchanged, verdict.push);
      CHECK(verdict.*c.best == std::max({verdict.payload, verdict.empty, verdict.unchanged, verdict.push}));
      const bool changed = c.best == &rme::Verdict<double>::payload || c.best == &rme::Verdict<double>::empty;
      CHECK(verdict.is_payload() == changed);
      CHECK((verdict.log_odds() > 0) == changed);
      if (changed) CHECK(verdict.is_empty() == (c.now.mass == 0));
    }
    // An empty hand that stays empty: both words for it say the same. A payload of next to nothing explains it as well
    // up to the price of 0.6 kg of prior where the data tell 0.01: odds of 1 to 60 unless noise of 2.9 deviations
    // helps.
    const auto nothing = judge({}, {}, none);
    CHECK(nothing.empty == nothing.unchanged);
    if (nothing.is_payload()) ++false_alarms;
  }
  CHECK(false_alarms <= 2);
}

TEST_CASE("EventInference: several sensor models give the mixture of what each says alone", "[event_inference]") {
  const unsigned seed = 111;
  CAPTURE(seed);
  const Payload payload{1.1, {0.05, 0.02, 0.13}};
  for (unsigned k = 0; k < 20; ++k) {
    CAPTURE(k);
    Bench bench(seed + k, k % 2 == 0 ? Model::link_side() : Model::joint_friction());
    const auto quiet = bench.window({}), window = bench.window(payload);
    std::vector<rme::ModelAverage<double>> alone;
    for (const Model& model : {Model::link_side(), Model::joint_friction()}) {
      Inference one = inference_of({model});
      one.learn_baseline(quiet);
      alone.push_back(one.posterior(window, wide_prior()));
    }
    Inference both = default_inference();
    both.learn_baseline(quiet);
    const auto average = both.posterior(window, wide_prior());
    // p = e^l0 / (e^l0 + e^l1), and the law of total variance.
    const double l0 = alone[0].log_evidence(), l1 = alone[1].log_evidence(), p = 1 / (1 + std::exp(l1 - l0));
    CAPTURE(l0, l1);
    const auto a = alone[0].moments(), b = alone[1].moments();
    const Eigen::Vector4d d = a.mean - b.mean, sd = a.standard_deviation();
    const Eigen::Vector4d mean = p * a.mean + (1 - p) * b.mean;
    const Eigen::Matrix4d covariance = p * a.covariance + (1 - p) * b.covariance + p * (1 - p) * d * d.transpose();
    CHECK((average.moments().mean - mean).cwiseQuotient(sd).norm() < 1e-8);
    CHECK((average.moments().covariance - covariance).cwiseQuotient(sd * sd.transpose()).norm() < 1e-7);
    CHECK(average.log_evidence() == Approx(std::max(l0, l1) + std::log1p(std::exp(-std::abs(l0 - l1)))));
  }
}

TEST_CASE("EventInference: sensor models compete by the full density that each gives to the samples",
          "[event_inference]") {
  // With the payload known, what each joint shows is Gaussian: y ~ N(N mu, noise^2 + N Lambda N^T) with N = (1, -d,
  // -dq). The log evidence of two models differs by the difference of these densities, normalisers included.
  const unsigned seed = 115;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  std::vector<Model> models = {Model::link_side(), Model::joint_friction()};
  for (Model& model : models) model.noise_correlation_time = 1e-4;  // below dt / 2: every sample counts in full
  const Payload payload{1.1, {0.05, 0.02, 0.13}};
  const auto known = rme::PayloadGaussian<double>::independent(payload.vector(), Eigen::Vector4d::Constant(1e-7));
  const int T = 20;
  for (int k = 0; k < 10; ++k) {
    CAPTURE(k);
    const auto J = rme::Jacobian<double, 7>::NullaryExpr([&] { return 0.5 * n(random); }).eval();
    Inference::Statistics window;
    Eigen::MatrixXd y(T, 7), d(T, 7), v(T, 7);  // y without the payload's torque
    for (int t = 0; t < T; ++t) {
      rme::PayloadObservation<double, 7> o;
      o.regressor = rme::payload_regressor<double, 7>(J, Eigen::Matrix3d::Identity(), {0, 0, -9.81});
      for (int j = 0; j < 7; ++j) {
        v(t, j) = o.velocity[j] = 0.2 * std::sin(0.5 * t + j + k);
        d(t, j) = o.direction[j] = v(t, j) > 0 ? 1 : -1;
        y(t, j) = 0.05 * n(random) - 0.1 * d(t, j);
        o.tau[j] = y(t, j) + o.regressor.torque(payload)[j];
      }
      window.add(o);
    }
    std::vector<double> evidence, dense;
    for (const Model& model : models) {
      evidence.push_back(inference_of({model}).posterior(window, known).log_evidence());
      double sum = 0;
      for (int j = 0; j < 7; ++j) {
        Eigen::MatrixXd N(T, 3);
        N << Eigen::VectorXd::Ones(T), -d.col(j), -v.col(j);
        const Eigen::Vector3d mu(0, model.coulomb_mean[j], model.viscous_mean[j]);
        const Eigen::Vector3d variance(std::pow(model.offset[j], 2) + std::pow(model.stiction[j], 2),
                                       std::pow(model.coulomb_std[j], 2), std::pow(model.viscous_std[j], 2));
        Eigen::MatrixXd C = oracle::composed(N, variance, N);
        C.diagonal().array() += std::pow(model.noise[j], 2);
        sum += oracle::log_normal(y.col(j) - N * mu, C);
      }
      dense.push_back(sum);
    }
    CAPTURE(dense[0], dense[1]);
    // A deviation of 1e-7 kg and m times torques' precisions of up to 1e6 leaves about 1e-4 of gradient.
    CHECK(evidence[0] - evidence[1] == Approx(dense[0] - dense[1]).margin(1e-3).epsilon(1e-9));
  }
}

TEST_CASE("EventInference: the model that the arm follows is the one believed", "[event_inference]") {
  const unsigned seed = 112;
  CAPTURE(seed);
  const Payload payload{1.1, {0.05, 0.02, 0.13}};
  const std::vector<Model> models = {Model::link_side(), Model::joint_friction()};
  for (std::size_t truth = 0; truth < 2; ++truth) {
    CAPTURE(truth);
    int believed = 0;
    for (unsigned k = 0; k < 40; ++k) {
      Bench bench(seed + k, models[truth]);
      const auto quiet = bench.window({}), window = bench.window(payload);
      std::vector<double> evidence;
      for (const Model& model : models) {
        Inference one = inference_of({model});
        one.learn_baseline(quiet);
        evidence.push_back(one.posterior(window, wide_prior()).log_evidence());
      }
      if (evidence[truth] > evidence[1 - truth]) ++believed;
    }
    CHECK(believed >= 38);  // friction is 4 to 20 times what link-side sensing expects of it
  }
}

TEST_CASE("EventInference: a baseline sharpens the estimate, and forgetting it takes that back", "[event_inference]") {
  const unsigned seed = 113;
  CAPTURE(seed);
  const Payload payload{1.1, {0.05, 0.02, 0.13}};
  Bench bench(seed, Model::link_side());
  const auto quiet = bench.window({}), window = bench.window(payload);
  Inference inference = inference_of({Model::link_side()});
  const auto without = inference.posterior(window, wide_prior()).moments();
  inference.learn_baseline(quiet);
  const auto with = inference.posterior(window, wide_prior()).moments();
  inference.forget_baseline();
  const auto again = inference.posterior(window, wide_prior()).moments();
  // Without a baseline the offset's 0.1 N m is in the estimate; with it what noise leaves of the offset, 0.0095 /
  // sqrt(5) in 200 ms.
  CHECK(with.standard_deviation()[0] < 0.4 * without.standard_deviation()[0]);
  CHECK(again.mean == without.mean);
  CHECK(again.covariance == without.covariance);
  const Eigen::Vector4d error = with.mean - payload.vector();
  CHECK((error.cwiseQuotient(with.standard_deviation())).cwiseAbs().maxCoeff() < 4);
}

TEST_CASE("EventInference: a setting out of range is refused by name", "[event_inference]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(inference_of({}), contains("EventEstimatorConfig::sensors"));
  Model model = Model::link_side();
  model.offset[3] = 0;
  CHECK_THROWS_WITH(inference_of({Model::link_side(), model}), contains("SensorModel::offset"));
  Model slower = Model::joint_friction();
  slower.noise_correlation_time = 0.03;
  CHECK_THROWS_WITH(inference_of({Model::link_side(), slower}), contains("SensorModel::noise_correlation_time"));
  const std::vector<Model> models = {Model::link_side()};
  for (const double bad : {0.0, -1.0, nan}) {
    CHECK_THROWS_WITH(Inference(kPeriod, models, {bad, 1}, {}), contains("PushPrior::force"));
    CHECK_THROWS_WITH(Inference(kPeriod, models, {1, bad}, {}), contains("PushPrior::moment"));
  }
  CHECK_THROWS_WITH(Inference(kPeriod, models, {}, {0, 1e-4}), contains("VariationalInferenceConfig::max_iterations"));
}

TEST_CASE("EventInference: a verdict comes with the posterior of the whole event", "[event_inference]") {
  Bench bench(115, Model::link_side());
  Inference inference = default_inference();
  inference.learn_baseline(bench.window({}));
  const auto settled = bench.window({1.0, {0, 0, 0.1}});
  auto event = bench.window({1.0, {0, 0, 0.1}});
  event += settled;
  rme::ModelAverage<double> given;
  (void)inference.judge(settled, event, wide_prior(), {}, bench.jacobian(), given);
  const auto average = inference.posterior(event, wide_prior());
  REQUIRE_FALSE(given.empty());
  CHECK(given.log_evidence() == average.log_evidence());
  CHECK(given.moments().mean == average.moments().mean);
  CHECK(given.moments().covariance == average.moments().covariance);
}

TEST_CASE("EventInference: noise beyond the sensor model's widens the posterior as if the model had named it",
          "[event_inference]") {
  Model quiet = Model::link_side(), loud = quiet;
  quiet.noise /= 10;
  Bench bench(116, loud);
  const auto window = bench.window({1.0, {0.02, -0.03, 0.1}});
  rme::ModelAverage<double> average;
  const auto verdict = inference_of({quiet}, true).judge(window, window, wide_prior(), {}, bench.jacobian(), average);
  // 35 means of noise of 100 times the variance, less what 4 parameters and 7 offsets take up.
  CHECK(verdict.excess > 30);
  CHECK(verdict.excess < 150);
  Model named = quiet;
  named.noise *= std::sqrt(verdict.excess);
  const auto expected = inference_of({named}).posterior(window, wide_prior());
  // To the solver's tolerance, since the two started from different means.
  const double tolerance = rme::VariationalInferenceConfig().tolerance;
  const Eigen::Vector4d sd = expected.moments().standard_deviation();
  CHECK((average.moments().mean - expected.moments().mean).cwiseQuotient(sd).norm() < tolerance);
  CHECK((average.moments().covariance - expected.moments().covariance).cwiseQuotient(sd * sd.transpose()).norm() <
        tolerance);
  CHECK(average.log_evidence() == Approx(expected.log_evidence()));
  // Less noise than the model's changes nothing: it may be chance.
  const auto calm = inference_of({loud}, true).judge(Bench(117, quiet).window({}), wide_prior(), {}, bench.jacobian());
  CHECK(calm.excess == 1);
}

TEST_CASE("EventInference: what cannot be inferred leaves the average empty and the verdict unchanged",
          "[event_inference]") {
  Bench bench(114, Model::link_side());
  const Inference inference = default_inference();
  auto prior = wide_prior();
  prior.covariance.setZero();
  const auto window = bench.window({1.0, {0, 0, 0.1}});
  CHECK(inference.posterior(window, prior).empty());
  rme::ModelAverage<double> posterior;
  posterior.add(wide_prior(), 0);
  const auto verdict = inference.judge(window, window, prior, {}, bench.jacobian(), posterior);
  CHECK(posterior.empty());
  CHECK_FALSE(verdict.is_payload());
  CHECK(verdict.unchanged > verdict.push);
}

using Statistics = Inference::Statistics;
static_assert(noexcept(std::declval<Inference&>().learn_baseline(std::declval<const Statistics&>())));
static_assert(noexcept(std::declval<Inference&>().forget_baseline()));
static_assert(noexcept(std::declval<const Inference&>().posterior(
    std::declval<const Statistics&>(), std::declval<const rme::PayloadGaussian<double>&>())));
static_assert(noexcept(std::declval<const Inference&>().judge(
    std::declval<const Statistics&>(), std::declval<const Statistics&>(),
    std::declval<const rme::PayloadGaussian<double>&>(), std::declval<const Payload&>(),
    std::declval<const rme::Jacobian<double, 7>&>(), std::declval<rme::ModelAverage<double>&>())));

}  // namespace
