#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <rme/host/object_catalogue.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "realtime/allocations_of.hpp"
#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using rme::Holding;
using rme::Mode;
using Catalogue = rme::ObjectCatalogue<double, 4>;
using Config = rme::ObjectCatalogueConfig<double>;
using Gaussian = rme::PayloadGaussian<double>;
using State = rme::EstimatorState<double>;
using Vector = rme::Vector4<double>;
using Matrix = rme::Matrix4<double>;

const rme::PayloadPrior<double> kPrior = rme::PayloadPrior<double>::of(3);

/// Something is held, and (m, m r) ~ N(mean, covariance).
State holding(const Vector& mean, const Matrix& covariance, double held = 1) {
  State state;
  state.held = held;
  state.probability = {};
  state.probability[Mode::Held] = held;
  state.probability[Mode::Empty] = 1 - held;
  state.inertial.mean.head<4>() = mean;
  state.inertial.covariance.topLeftCorner<4, 4>() = covariance;
  return state;
}
/// The same from mass and centre of mass, known to a deviation of the mass and of the first moment.
State holding(double mass, const Eigen::Vector3d& com, double deviation, double moment_deviation, double held = 1) {
  Vector mean;
  mean << mass, mass * com;
  Vector variance = Vector::Constant(moment_deviation * moment_deviation);
  variance[0] = deviation * deviation;
  return holding(mean, variance.asDiagonal(), held);
}

/// Factor of the covariance of (m, m r) that the estimator's prior has for a payload that shows this mass.
Matrix prior_factor(double mean, double variance) {
  return kPrior.factor(mean * mean + variance).topLeftCorner<4, 4>();
}
/// Log of a normal density without its factor of 2 pi.
class LogNormal {
 public:
  LogNormal(const Vector& mean, const Matrix& covariance)
      : mean_(mean), precision_(covariance.inverse()), constant_(-0.5 * std::log(covariance.determinant())) {}
  double operator()(const Vector& x) const { return constant_ - 0.5 * (x - mean_).dot(precision_ * (x - mean_)); }

 private:
  Vector mean_;
  Matrix precision_;
  double constant_;
};
/// Calls use(standard deviations, weight) on a grid over four standard normal numbers.
template <typename Use>
void on_a_grid(int steps, const Use& use) {
  const auto at = [&](int i) { return 10.0 * (i + 0.5) / steps - 5; };
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      for (int k = 0; k < steps; ++k)
        for (int l = 0; l < steps; ++l) {
          const Vector z(at(i), at(j), at(k), at(l));
          use(z, std::exp(-0.5 * z.squaredNorm()));
        }
}

TEST_CASE("ObjectCatalogue: probabilities are those of a dense numerical integration over mass and centre of mass",
          "[catalogue]") {
  const unsigned seed = 3640;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int trial = 0; trial < 6; ++trial) {
    CAPTURE(trial);
    // A posterior that has a share of the prior's variance along each of four random axes.
    Vector mean;
    mean << 0.4 + 0.1 * trial, 0, 0, 0;
    const Matrix L = prior_factor(mean[0], 0);
    Vector share;
    for (int i = 0; i < 4; ++i) share[i] = 0.02 + 0.5 * uniform(random);
    const Matrix axes = oracle::random_rotation(random, 4);
    const Matrix covariance = L * axes * share.asDiagonal() * axes.transpose() * L.transpose();
    for (int i = 1; i < 4; ++i) mean[i] = mean[0] * (kPrior.com_mean[i - 1] + 0.05 * (uniform(random) - 0.5));
    const Matrix factor = prior_factor(mean[0], covariance(0, 0));
    const LogNormal posterior(mean, covariance), prior(kPrior.mean().head<4>(), factor * factor.transpose());

    Catalogue catalogue;
    std::vector<Gaussian> objects;
    for (int k = 0; k < 3; ++k) {
      Gaussian object;
      object.mean << 0.3 + 0.2 * k, 0.02, -0.01 * k, 0.1;
      const Matrix A = oracle::random_matrix(random, 4, 4);
      const Vector deviation = k == 2 ? Vector(0.01, 0.06, 0.06, 0.07) : Vector(0.01, 0.01, 0.01, 0.02);
      const Matrix correlated = 0.2 * A * A.transpose() + Matrix::Identity();
      const Vector root = correlated.diagonal().cwiseSqrt();
      object.covariance =
          deviation.cwiseQuotient(root).asDiagonal() * correlated * Matrix(deviation.cwiseQuotient(root).asDiagonal());
      objects.push_back(object);
      catalogue.add("object " + std::to_string(k), object, 1 + k);
    }

    // int N(m, r; object) posterior(m, m r) / prior(m, m r): the objects' Gaussian is over (m, r) here.
    std::array<double, 3> factors{};
    double all = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Matrix root = rme::Cholesky<double, 4>(objects[k].covariance).lower();
      double sum = 0, weights = 0;
      on_a_grid(24, [&](const Vector& z, double weight) {
        Vector phi = objects[k].mean + root * z;
        phi.tail<3>() *= phi[0];
        sum += weight * std::exp(posterior(phi) - prior(phi));
        weights += weight;
      });
      factors[k] = 0.95 * (1 + static_cast<double>(k)) / 6 * sum / weights;
      all += factors[k];
    }
    const double held = 0.7;
    const double total = (1 - held) + held * (0.05 + all);
    const auto answer = catalogue.identify(holding(mean, covariance, held));
    // (m, m r) of an object is taken for Gaussian. Its mass is known to 1 to 3 %, and so the densities to about as much.
    CHECK(answer.nothing == Approx((1 - held) / total).epsilon(0.03));
    CHECK(answer.unknown == Approx(held * 0.05 / total).epsilon(0.03));
    for (std::size_t k = 0; k < 3; ++k) CHECK(answer.object[k] == Approx(held * factors[k] / total).epsilon(0.03));
    CHECK(answer.changing == 0);
  }
}

/// An estimator at rest in a linear world: it measures mass and the moments across gravity, with noise.
class Rest {
 public:
  Rest(double mass_noise, double moment_noise) { noise_ << mass_noise, moment_noise, moment_noise; }
  template <typename Random>
  State measure(double mass, const Eigen::Vector3d& com, Random& random) const {
    std::normal_distribution<double> n;
    Eigen::Vector3d y(mass, mass * com[0], mass * com[1]);
    for (int i = 0; i < 3; ++i) y[i] += noise_[i] * n(random);
    const Matrix L = kPrior.factor(std::max(1e-3, y[0] * y[0] + noise_[0] * noise_[0])).topLeftCorner<4, 4>();
    const Eigen::Matrix<double, 3, 4> H = Eigen::Matrix<double, 3, 4>::Identity();
    const Matrix P = L * L.transpose();
    const Eigen::Matrix3d S = H * P * H.transpose() + Eigen::Matrix3d(noise_.cwiseAbs2().asDiagonal());
    const Eigen::Matrix<double, 4, 3> K = P * H.transpose() * S.inverse();
    const Vector prior_mean = kPrior.mean().head<4>();
    return holding(prior_mean + K * (y - H * prior_mean), P - K * H * P);
  }

 private:
  Eigen::Vector3d noise_;
};

TEST_CASE("ObjectCatalogue: of picks at random, each answer is right as often as it says", "[catalogue]") {
  const unsigned seed = 3641;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  Catalogue catalogue;
  // Two that differ by their mass alone, one by its centre of mass, one of which only the mass is known.
  const std::array<Gaussian, 3> gripped = {Gaussian::independent({0.40, 0.02, 0, 0.1}, {0.005, 0.01, 0.01, 0.01}),
                                           Gaussian::independent({0.43, 0.02, 0, 0.1}, {0.010, 0.01, 0.01, 0.01}),
                                           Gaussian::independent({0.42, -0.04, 0.03, 0.06}, {0.010, 0.02, 0.02, 0.02})};
  for (int k = 0; k < 3; ++k) catalogue.add("gripped " + std::to_string(k), gripped[static_cast<std::size_t>(k)]);
  catalogue.add("mass only", 0.46, 0.01);

  constexpr int kPicks = 40'000, kBins = 10;
  const Rest arm(0.015, 0.004);
  std::array<double, kBins> stated{}, right{}, variance{};
  int decided = 0, wrong = 0;
  for (int pick = 0; pick < kPicks; ++pick) {
    const double which = std::uniform_real_distribution(0.0, 1.0)(random);
    const int truth = which < 0.05 ? 4 : std::min(3, static_cast<int>((which - 0.05) / 0.95 * 4));
    double mass = 0;
    Eigen::Vector3d com = kPrior.com_mean;
    if (truth < 3) {
      const Gaussian& object = gripped[static_cast<std::size_t>(truth)];
      const Vector deviation = object.standard_deviation();
      mass = object.mean[0] + deviation[0] * n(random);
      for (int i = 0; i < 3; ++i) com[i] = object.mean[1 + i] + deviation[1 + i] * n(random);
    } else {
      for (int i = 0; i < 3; ++i) com[i] += kPrior.com_std[i] * n(random);
      mass = 0.46 + 0.01 * n(random);
      // The prior is a Gaussian over (m, m r): a mass below zero is drawn and measured like any other.
      if (truth == 4) mass = kPrior.mass_mean + kPrior.mass_std * n(random);
    }
    const auto answer = catalogue.identify(arm.measure(mass, com, random));
    for (int k = 0; k < 5; ++k) {
      const double p = k < 4 ? answer.object[static_cast<std::size_t>(k)] : answer.unknown;
      const auto bin = static_cast<std::size_t>(std::min(kBins - 1, static_cast<int>(kBins * p)));
      stated[bin] += p;
      variance[bin] += p * (1 - p);
      right[bin] += k == truth ? 1 : 0;
    }
    if (answer.holding == Holding::CannotTell) continue;
    ++decided;
    wrong += answer.holding != (truth < 4 ? Holding::Known : Holding::Unknown) || (truth < 4 && answer.index != truth);
  }
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    CAPTURE(bin, stated[bin], right[bin]);
    CHECK(variance[bin] > 0);
    CHECK(std::abs(right[bin] - stated[bin]) < 3.5 * std::sqrt(variance[bin]) + 0.01 * stated[bin]);
  }
  CAPTURE(decided, wrong);
  CHECK(decided > kPicks / 10);  // of 30 g, measured to 15 g
  CHECK(wrong < 0.02 * decided);
}

TEST_CASE("ObjectCatalogue: it tells objects by mass, by centre of mass, and does not tell what it cannot",
          "[catalogue]") {
  Catalogue catalogue;
  const Vector deviation(0.005, 0.01, 0.01, 0.02);
  CHECK(catalogue.add("mug", 0.31, 0.005) == 0);
  CHECK(catalogue.add("drill by its handle", Gaussian::independent({1.2, 0.06, 0, 0.1}, deviation)) == 1);
  CHECK(catalogue.add("drill by its chuck", Gaussian::independent({1.2, -0.04, 0, 0.1}, deviation)) == 2);
  REQUIRE(catalogue.size() == 3);
  CHECK(catalogue.name(2) == std::string("drill by its chuck"));
  CHECK(catalogue.name(3) == std::string());
  CHECK(catalogue.name(-1) == std::string());

  auto held = catalogue.identify(holding(0.312, {0.03, 0.05, 0.1}, 0.01, 0.005));
  CHECK(held.holding == Holding::Known);
  CHECK(held.index == 0);
  CHECK(held.likeliest == 0);
  held = catalogue.identify(holding(1.21, {0.055, 0, 0.1}, 0.01, 0.01));
  CHECK(held.holding == Holding::Known);
  CHECK(held.index == 1);
  held = catalogue.identify(holding(1.21, {-0.035, 0, 0.1}, 0.01, 0.01));
  CHECK(held.index == 2);
  // Where the moment is not known yet, the two grips are alike.
  held = catalogue.identify(holding(1.21, {0.055, 0, 0.1}, 0.01, 1));
  CHECK(held.holding == Holding::CannotTell);
  CHECK(held.index == -1);
  CHECK(held.object[1] + held.object[2] > 0.98);
  held = catalogue.identify(holding(0.7, {0, 0, 0.1}, 0.01, 0.005));
  CHECK(held.holding == Holding::Unknown);
  CHECK(held.index == -1);
  held = catalogue.identify(holding(0, {0, 0, 0.1}, 0.3, 0.1, 0.001));
  CHECK(held.holding == Holding::Nothing);
}

TEST_CASE("ObjectCatalogue: what the samples do not show of the centre of mass counts neither for nor against",
          "[catalogue]") {
  // At rest, the moment along gravity, here z, keeps its prior: that of a payload of the mass which the torque shows.
  const double deviation = 0.005, mass = 0.5;
  const Matrix L = prior_factor(mass, deviation * deviation);
  Vector mean;
  mean << mass, mass * 0.02, 0, mass * kPrior.com_mean[2];
  Matrix covariance = Matrix::Zero();
  covariance.diagonal() << deviation * deviation, 1e-5, 1e-5, std::pow(L(3, 3), 2);
  const auto shares = [&](double z) {
    Catalogue catalogue;
    catalogue.add("low", Gaussian::independent({0.5, 0.02, 0, 0.05}, {0.01, 0.01, 0.01, 0.01}));
    catalogue.add("other", Gaussian::independent({0.5, 0.02, 0, z}, {0.01, 0.01, 0.01, 0.01}));
    return catalogue.identify(holding(mean, covariance)).object;
  };
  // The prior says 0.1 +- 0.07 m: used twice, it would prefer 0.1 to 0.3 m by a factor of exp(4).
  for (const double z : {0.05, 0.1, 0.2, 0.3}) {
    CAPTURE(z);
    CHECK(shares(z)[1] / shares(z)[0] == Approx(1).epsilon(0.01));
  }
}

TEST_CASE("ObjectCatalogue: an empty catalogue tells an empty hand from a full one", "[catalogue]") {
  const Catalogue catalogue;
  auto held = catalogue.identify(holding(0.5, {0, 0, 0.1}, 0.01, 0.005, 0.995));
  CHECK(held.holding == Holding::Unknown);
  CHECK(held.unknown == Approx(0.995));
  CHECK(held.nothing == Approx(0.005));
  CHECK(held.likeliest == -1);
  held = catalogue.identify(holding(0.5, {0, 0, 0.1}, 0.01, 0.005, 0.6));
  CHECK(held.holding == Holding::CannotTell);
  held = catalogue.identify(State());
  CHECK(held.holding == Holding::Nothing);
}

TEST_CASE("ObjectCatalogue: while the payload changes, nothing is decided", "[catalogue]") {
  Catalogue catalogue;
  catalogue.add("mug", 0.31, 0.005);
  State state = holding(0.31, {0, 0, 0.1}, 0.01, 0.005);
  REQUIRE(catalogue.identify(state).holding == Holding::Known);
  state.probability[Mode::Held] = 0.2;
  state.probability[Mode::Changing] = 0.8;
  const auto answer = catalogue.identify(state);
  CHECK(answer.holding == Holding::CannotTell);
  CHECK(answer.changing == Approx(0.8));
  CHECK(answer.likeliest == 0);
  CHECK(answer.object[0] + answer.unknown + answer.nothing == Approx(0.2));
}

TEST_CASE("ObjectCatalogue: a torque that the model does not explain makes it less sure", "[catalogue]") {
  Catalogue catalogue;
  catalogue.add("mug", 0.31, 0.005);
  catalogue.add("jar", 0.37, 0.005);
  State state = holding(0.315, {0, 0, 0.1}, 0.012, 0.005);
  REQUIRE(catalogue.identify(state).holding == Holding::Known);
  state.health = 60;  // of the mass, 12 g become 54 g, as in state.payload
  CHECK(catalogue.identify(state).holding == Holding::CannotTell);
}

TEST_CASE("ObjectCatalogue: an object that is picked up more often is likelier in proportion", "[catalogue]") {
  Catalogue catalogue;
  catalogue.add("rare", 0.31, 0.005, 1);
  catalogue.add("frequent", 0.31, 0.005, 9);
  const auto answer = catalogue.identify(holding(0.31, {0, 0, 0.1}, 0.01, 0.005));
  CHECK(answer.object[1] / answer.object[0] == Approx(9));
}

TEST_CASE("ObjectCatalogue: a wrong setting or object is refused, and the message names it", "[catalogue]") {
  Config config;
  config.certain = 0.4;
  CHECK_THROWS_WITH(Catalogue(config), contains("ObjectCatalogueConfig::certain: expected 0.5 to below 1"));
  config.certain = std::nan("");
  CHECK_THROWS_WITH(Catalogue(config), contains("certain"));
  for (const double share : {0.0, 1.0, std::nan("")}) {
    config = Config();
    config.unknown_share = share;
    CHECK_THROWS_WITH(Catalogue(config), contains("unknown_share"));
  }
  config = Config();
  config.unknown.com_std[1] = 0;
  CHECK_THROWS_WITH(Catalogue(config), contains("PayloadPrior::com_std"));
  config = Config();
  config.unknown.mass_std = -1;
  CHECK_THROWS_WITH(Catalogue(config), contains("PayloadPrior::mass_std"));
  config = Config();
  config.unknown.mass_mean = -1;
  CHECK_THROWS_WITH(Catalogue(config), contains("PayloadPrior::mass_mean"));
  config = Config();
  config.unknown.com_mean[2] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(Catalogue(config), contains("PayloadPrior::com_mean"));

  Catalogue catalogue;
  CHECK_THROWS_WITH(catalogue.add("", 0.3, 0.01), contains("name: expected 1 to 31 bytes, got 0"));
  CHECK_THROWS_WITH(catalogue.add(std::string(32, 'x'), 0.3, 0.01), contains("got 32"));
  CHECK_NOTHROW(catalogue.add(std::string(31, 'x'), 0.3, 0.01));
  CHECK(catalogue.name(0) == std::string(31, 'x'));
  for (const double mass : {0.0, -0.2, std::nan(""), std::numeric_limits<double>::infinity()})
    CHECK_THROWS_WITH(catalogue.add("mug", mass, 0.01), contains("ObjectCatalogue::add(\"mug\"): mass: expected > 0"));
  for (const double deviation : {-0.01, std::nan("")})
    CHECK_THROWS_WITH(catalogue.add("mug", 0.3, deviation), contains("standard deviation of the mass"));
  for (const double weight : {0.0, -1.0, std::nan("")})
    CHECK_THROWS_WITH(catalogue.add("mug", 0.3, 0.01, weight), contains("weight: expected > 0"));
  Gaussian object = Gaussian::independent({0.3, 0, 0, 0.1}, {0.01, 0.01, 0.01, 0.01});
  object.mean[2] = std::nan("");
  CHECK_THROWS_WITH(catalogue.add("mug", object), contains("finite centre of mass"));
  const auto refused = [&](const auto& spoil, const char* message) {
    Gaussian bad = Gaussian::independent({0.3, 0, 0, 0.1}, {0.01, 0.01, 0.01, 0.01});
    spoil(bad.covariance);
    CHECK_THROWS_WITH(catalogue.add("mug", bad), contains(message));
  };
  refused([](Matrix& V) { V(1, 1) = -1e-6; }, "covariance: expected finite, with a diagonal >= 0");
  refused([](Matrix& V) { V(0, 2) = V(2, 0) = std::nan(""); }, "covariance");
  refused([](Matrix& V) { V(0, 2) = 1e-5; }, "covariance: expected symmetric");
  refused([](Matrix& V) { V(0, 2) = V(2, 0) = 1.1e-4; }, "covariance: expected positive semidefinite");
  refused([](Matrix& V) { V(2, 2) = 0, V(0, 2) = V(2, 0) = 1e-5; }, "covariance: expected symmetric");

  CHECK(catalogue.add("mug", 0.3, 0) == 1);  // known exactly
  CHECK_THROWS_WITH(catalogue.add("mug", 0.4, 0.01), contains("\"mug\"): an object of this name is already there"));
  catalogue.add("jar", 0.4, 0.01);
  catalogue.add("can", 0.5, 0.01);
  CHECK_THROWS_WITH(catalogue.add("pan", 0.6, 0.01), contains("\"pan\"): there is room for 4 objects only"));
  CHECK(catalogue.size() == 4);
}

TEST_CASE("ObjectCatalogue: whatever the state holds, the answer is finite, and a number that is not says nothing",
          "[catalogue]") {
  Catalogue catalogue;
  catalogue.add("mug", 0.3, 0);
  catalogue.add("jar", 0.4, 0.01);
  const State good = holding(0.3, {0, 0, 0.1}, 0.01, 0.005);
  const double nan = std::nan(""), infinite = std::numeric_limits<double>::infinity();
  std::vector<State> states(9, good);
  states[0].held = nan;
  states[1].health = infinite;
  states[2].inertial.mean[2] = nan;
  states[3].inertial.covariance(3, 1) = infinite;
  states[4].probability[Mode::Changing] = nan;
  states[5].held = -0.1;
  for (std::size_t i = 0; i < 6; ++i) {
    CAPTURE(i);
    const auto answer = catalogue.identify(states[i]);
    CHECK(answer.holding == Holding::CannotTell);
    CHECK(answer.changing == 1);
    CHECK(answer.object[0] == 0);
  }
  // An exact payload, one as light as nothing, and one that nothing is known of.
  states[6].inertial.covariance.setZero();
  states[7] = holding(1e-9, {0, 0, 0}, 0, 0);
  states[8].inertial.covariance.diagonal().setConstant(1e6);
  for (std::size_t i = 6; i < 9; ++i) {
    CAPTURE(i);
    const auto answer = catalogue.identify(states[i]);
    double sum = answer.nothing + answer.unknown + answer.changing;
    for (const double p : answer.object) {
      CHECK(p >= 0);
      sum += p;
    }
    CHECK(sum == Approx(1));
  }
  CHECK(catalogue.identify(states[6]).index == 0);
  CHECK(catalogue.identify(states[8]).holding == Holding::CannotTell);
}

TEST_CASE("ObjectCatalogue: in float it says the same", "[catalogue]") {
  const unsigned seed = 3642;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  Catalogue catalogue;
  rme::ObjectCatalogue<float, 4> in_float;
  const Gaussian drill = Gaussian::independent({0.45, 0.06, 0, 0.1}, {0.005, 0.01, 0.01, 0.02});
  catalogue.add("mug", 0.4, 0.005);
  catalogue.add("drill", drill);
  in_float.add("mug", 0.4F, 0.005F);
  in_float.add("drill", {drill.mean.cast<float>(), drill.covariance.cast<float>()});
  const Rest arm(0.01, 0.004);
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    const double mass = std::uniform_real_distribution(0.35, 0.5)(random);
    const double x = std::uniform_real_distribution(-0.05, 0.1)(random);
    const State state = arm.measure(mass, {x, 0, 0.1}, random);
    rme::EstimatorState<float> rounded;
    rounded.held = 1;
    rounded.probability = {};
    rounded.probability[Mode::Held] = 1;
    rounded.inertial = {state.inertial.mean.cast<float>(), state.inertial.covariance.cast<float>()};
    const auto exact = catalogue.identify(state);
    const auto answer = in_float.identify(rounded);
    // The posterior has 1e-4 of the prior's variance, of which a float's 6e-8 are 6e-4.
    for (std::size_t i = 0; i < 2; ++i) CHECK(double(answer.object[i]) == Approx(exact.object[i]).margin(2e-3));
    CHECK(double(answer.unknown) == Approx(exact.unknown).margin(2e-3));
  }
}

#ifdef RME_COUNTS_ALLOCATIONS
TEST_CASE("ObjectCatalogue: a query allocates nothing", "[catalogue]") {
  Catalogue catalogue;
  catalogue.add("an object with quite a long nam", Gaussian::independent({0.3, 0, 0, 0.1}, {0.01, 0.01, 0.01, 0.01}));
  const State state = holding(0.3, {0, 0, 0.1}, 0.01, 0.005);
  auto holding = Holding::CannotTell;
  CHECK(rme::testing::allocations_of([&] { holding = catalogue.identify(state).holding; }) == 0);
  CHECK(holding == Holding::Known);
}
#endif

TEST_CASE("Holding: each has its name for logs", "[catalogue]") {
  CHECK(rme::to_string(Holding::CannotTell) == std::string("cannot tell"));
  CHECK(rme::to_string(Holding::Nothing) == std::string("nothing"));
  CHECK(rme::to_string(Holding::Known) == std::string("known"));
  CHECK(rme::to_string(Holding::Unknown) == std::string("unknown"));
}

}  // namespace
