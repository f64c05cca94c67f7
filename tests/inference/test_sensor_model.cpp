#include <limits>
#include <random>
#include <rme/inference/sensor_model.hpp>
#include <stdexcept>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using rme::Status;
using Model = rme::SensorModel<double, 7>;
using Nuisance = rme::NuisanceGaussian<double, 7>;

TEST_CASE("SensorModel: after an event the offset stays, the stiction is drawn anew, and friction is what was learned",
          "[sensor_model]") {
  // The story told densely, joint by joint: o ~ N(0, offset^2), s1 and s2 ~ N(0, stiction^2), Coulomb c and viscous v
  // with their priors, all independent. A quiet window shows y_t = o + s1 - c d_t - v dq_t + noise; wanted are the
  // moments of (o + s2, c, v) given y. Conditioned in one go, with the 5x5 covariance of (o, s1, s2, c, v).
  const unsigned seed = 80;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  std::uniform_real_distribution<double> between(0.3, 3);
  for (int k = 0; k < 30; ++k) {
    CAPTURE(k);
    Model model = Model::joint_friction();
    for (auto* field : {&model.noise, &model.offset, &model.stiction, &model.coulomb_std, &model.viscous_std})
      *field = field->unaryExpr([&](double x) { return x * between(random); });
    model.noise_correlation_time = 1e-4;  // below dt / 2: every sample counts in full
    const int T = 30;
    std::vector<Eigen::Matrix<double, 7, 1>> y(T), d(T), dq(T);
    rme::PayloadStatistics<double, 7> quiet;
    for (int t = 0; t < T; ++t) {
      const auto s = static_cast<std::size_t>(t);
      rme::PayloadObservation<double, 7> o;
      for (int j = 0; j < 7; ++j) {
        o.velocity[j] = 0.2 * std::sin(0.3 * t + j);
        o.direction[j] = o.velocity[j] > 0 ? 1 : -1;
        o.tau[j] = 0.1 * n(random) - 0.2 * o.direction[j] - 0.1 * o.velocity[j] + 0.05 * n(random);
      }
      quiet.add(o);
      y[s] = o.tau;
      d[s] = o.direction;
      dq[s] = o.velocity;
    }
    Nuisance learned;
    REQUIRE(quiet.nuisance_posterior(model.precision(1e-3), model.prior(), learned) == Status::Ok);
    const Nuisance next = model.after_event(learned);

    for (int j = 0; j < 7; ++j) {
      CAPTURE(j);
      using Vector5 = Eigen::Matrix<double, 5, 1>;
      Vector5 mean, variance;
      mean << 0, 0, 0, model.coulomb_mean[j], model.viscous_mean[j];
      variance << model.offset[j], model.stiction[j], model.stiction[j], model.coulomb_std[j], model.viscous_std[j];
      variance = variance.cwiseAbs2();
      const Eigen::Matrix<double, 5, 5> prior = variance.asDiagonal();
      Eigen::MatrixXd H(T, 5);
      Eigen::VectorXd residual(T);
      for (int t = 0; t < T; ++t) {
        const auto s = static_cast<std::size_t>(t);
        H.row(t) << 1, 1, 0, -d[s][j], -dq[s][j];
        residual[t] = y[s][j] - H.row(t).dot(mean);
      }
      const Eigen::MatrixXd S =
          H * prior * H.transpose() + model.noise[j] * model.noise[j] * Eigen::MatrixXd::Identity(T, T);
      const Eigen::MatrixXd gain = oracle::solve(S, H * prior).transpose();
      Eigen::Matrix<double, 3, 5> wanted;
      wanted << 1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1;
      const Eigen::Vector3d expected_mean = wanted * (mean + gain * residual);
      const Eigen::Matrix3d expected = wanted * (prior - gain * H * prior) * wanted.transpose();
      const auto s = static_cast<std::size_t>(j);
      const Eigen::Vector3d sd = expected.diagonal().cwiseSqrt();
      CHECK((next.mean[s] - expected_mean).cwiseQuotient(sd).norm() < 1e-9);
      CHECK((next.covariance[s] - expected).cwiseQuotient(sd * sd.transpose()).norm() < 1e-9);
    }
  }
}

TEST_CASE("SensorModel: a baseline that shows nothing leaves the prior as it was", "[sensor_model]") {
  const Model model = Model::joint_friction();
  const Nuisance prior = model.prior(), next = model.after_event(prior);
  for (std::size_t j = 0; j < 7; ++j) {
    CHECK((next.mean[j] - prior.mean[j]).norm() < 1e-15);
    CHECK((next.covariance[j] - prior.covariance[j]).norm() < 1e-15);
  }
}

TEST_CASE("SensorModel: samples closer than the noise's memory count for less", "[sensor_model]") {
  // 1 / 0.05^2 = 400 per independent sample; 1 ms apart under 20 ms of memory each is worth 1 / 40 of one. 50 ms apart
  // they are independent, and never worth more than one.
  Model model = Model::link_side();
  model.noise.setConstant(0.05);
  model.noise_correlation_time = 0.02;
  CHECK(model.precision(1e-3)[2] == Approx(400.0 / 40));
  CHECK(model.precision(0.04)[2] == Approx(400));
  CHECK(model.precision(0.05)[2] == Approx(400));
  // The normaliser -log(0.05) of each of 200 / 40 = 5 samples in each of seven joints.
  CHECK(model.log_factor(1e-3, 200) == Approx(-5 * 7 * std::log(0.05)));
}

TEST_CASE("SensorModel: a setting out of range is refused by name", "[sensor_model]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  CHECK_NOTHROW(Model::link_side().validate());
  CHECK_NOTHROW(Model::joint_friction().validate());
  struct Field {
    Eigen::Matrix<double, 7, 1> Model::*member;
    const char* name;
    bool may_be_zero;
  };
  for (const Field& field : {Field{&Model::noise, "SensorModel::noise", false},
                             {&Model::offset, "SensorModel::offset", false},
                             {&Model::stiction, "SensorModel::stiction", false},
                             {&Model::coulomb_mean, "SensorModel::coulomb_mean", true},
                             {&Model::coulomb_std, "SensorModel::coulomb_std", false},
                             {&Model::viscous_mean, "SensorModel::viscous_mean", true},
                             {&Model::viscous_std, "SensorModel::viscous_std", false}}) {
    CAPTURE(field.name);
    for (const double bad : {-0.1, nan, infinity, 0.0}) {
      if (bad == 0 && field.may_be_zero) continue;
      CAPTURE(bad);
      Model model = Model::joint_friction();
      (model.*field.member)[6] = bad;
      CHECK_THROWS_WITH(model.validate(), contains(std::string(field.name) + ":"));
    }
  }
  for (const double bad : {0.0, -1.0, nan, infinity}) {
    Model model = Model::link_side();
    model.noise_correlation_time = bad;
    CHECK_THROWS_WITH(model.validate(), contains("SensorModel::noise_correlation_time"));
  }
}

static_assert(noexcept(std::declval<const Model&>().after_event(std::declval<const Nuisance&>())));
static_assert(noexcept(std::declval<const Model&>().prior()));
static_assert(noexcept(std::declval<const Model&>().precision(1e-3)));

}  // namespace
