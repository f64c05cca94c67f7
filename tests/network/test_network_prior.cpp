#include <memory>
#include <random>
#include <rme/network/network_prior.hpp>

#include "network/golden.hpp"
#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using Network = rme::MismatchNetwork<double>;
using Prior = rme::NetworkPrior<double, rme::PublishedArchitecture, double>;  // for closer comparisons
using Window = rme::SampleWindow<double, 7>;

/// An arm with a random Jacobian, torque and rotation at each tick.
struct Recording {
  Window window{0.001};
  std::vector<rme::Proprioception<double, 7>> ticks;

  explicit Recording(unsigned seed, int length, double torque = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (int k = 0; k < length; ++k) {
      rme::Proprioception<double, 7> tick;
      tick.jacobian = tick.jacobian.NullaryExpr([&] { return normal(random); });
      tick.tau_ext = tick.tau_ext.NullaryExpr([&] { return torque * normal(random); });
      tick.rotation = Eigen::Quaterniond{normal(random), normal(random), normal(random), normal(random)}
                          .normalized()
                          .toRotationMatrix();
      ticks.push_back(tick);
      REQUIRE(window.push(tick) == rme::Status::Ok);
    }
  }
};

TEST_CASE("NetworkPrior: asks the network about 20 pseudo-wrenches, each the newest of 10 ms, in the network's frame",
          "[network_prior]") {
  const unsigned seed = 5;
  CAPTURE(seed);
  const Recording recording(seed, 250);
  for (const auto frame : {rme::InputFrame::World, rme::InputFrame::EndEffector}) {
    auto weights = golden::random_weights<double>();
    weights->frame = frame;
    const auto network = std::make_unique<Network>(*weights);
    Network::Window input;
    for (int i = 0; i < 20; ++i) {
      const int k = 250 - 200 + 10 * i + 9;
      const auto& tick = recording.ticks[static_cast<std::size_t>(k)];
      const rme::Matrix6<double> damped =
          tick.jacobian * tick.jacobian.transpose() + 1e-2 * rme::Matrix6<double>::Identity();
      rme::Vector6<double> w = oracle::solve(damped, oracle::product(tick.jacobian, tick.tau_ext));
      if (frame == rme::InputFrame::EndEffector) {
        w.head<3>() = (tick.rotation.transpose() * w.head<3>()).eval();
        w.tail<3>() = (tick.rotation.transpose() * w.tail<3>()).eval();
      }
      input.row(i) = w.transpose();
    }
    Eigen::Vector4d expected = Eigen::Vector4d::Zero();
    REQUIRE(network->forward(input, expected) == rme::Status::Ok);

    rme::NetworkPriorConfig<double> config;
    config.farthest = 100;
    config.damping = 1e-2;
    Eigen::Vector4d guess = Eigen::Vector4d::Zero();
    REQUIRE(Prior(*network, 0.001, config).guess(recording.window, 200, guess));
    CHECK((guess - expected).cwiseAbs().maxCoeff() < 1e-9);
  }
}

TEST_CASE("NetworkPrior: a network in float serves an estimator in double", "[network_prior]") {
  const unsigned seed = 6;
  CAPTURE(seed);
  const Recording recording(seed, 250);
  const auto network = std::make_unique<Network>(*golden::random_weights<double>());
  const auto in_float = std::make_unique<rme::MismatchNetwork<float>>(*golden::random_weights<float>());
  rme::NetworkPriorConfig<double> config;
  config.farthest = 100;
  const auto expected = Prior(*network, 0.001, config)(recording.window, 200);
  const rme::NetworkPrior<double> prior(*in_float, 0.001, config);
  const auto said = prior(recording.window, 200);
  // The network's own tolerance against PyTorch in float.
  CHECK((said.mean - expected.mean).cwiseAbs().maxCoeff() < 1e-5);
  CHECK((said.covariance - expected.covariance).norm() < 1e-12);
  CHECK(said.mean != config.unknown.gaussian.mean);
}

TEST_CASE("NetworkPrior: across gravity the network speaks, along it the fixed prior", "[network_prior]") {
  const unsigned seed = 8;
  CAPTURE(seed);
  const Recording recording(seed, 250);
  const auto network = std::make_unique<Network>(*golden::random_weights<double>());
  rme::NetworkPriorConfig<double> config;
  config.farthest = 100;
  config.standard_deviation << 0.1, 0.2, 0.2, 0.2;
  config.unknown.gaussian =
      rme::PayloadGaussian<double>::independent({3, 0.1, 0.2, 0.3}, Eigen::Vector4d(1, 0.5, 0.5, 0.5));
  config.gravity << 3, -2, 6;  // an arm on a tilted wall
  const Prior prior(*network, 0.001, config);
  const auto [mean, covariance] = prior(recording.window, 200);
  Eigen::Vector4d guess = Eigen::Vector4d::Zero();
  REQUIRE(prior.guess(recording.window, 200, guess));

  // Two directions across gravity, in end-effector axes: with down, they are a basis.
  const Eigen::Vector3d down = recording.ticks.back().rotation.transpose() * Eigen::Vector3d(3, -2, 6) / 7;
  const Eigen::Vector3d one = down.unitOrthogonal(), other = down.cross(one);
  const Eigen::Vector3d com = mean.tail<3>();
  CHECK(mean[0] == guess[0]);
  CHECK(com.dot(one) == Approx(guess.tail<3>().dot(one)));
  CHECK(com.dot(other) == Approx(guess.tail<3>().dot(other)));
  CHECK(com.dot(down) == Approx(Eigen::Vector3d(0.1, 0.2, 0.3).dot(down)));
  Eigen::Matrix4d basis = Eigen::Matrix4d::Identity();
  basis.bottomRightCorner<3, 3>() << one, other, down;
  const Eigen::Matrix4d expected = Eigen::Vector4d(0.01, 0.04, 0.04, 0.25).asDiagonal();
  CHECK((basis.transpose() * covariance * basis).isApprox(expected));
}

TEST_CASE("NetworkPrior: where the network cannot know, the fixed prior stands", "[network_prior]") {
  const auto network = std::make_unique<Network>(*golden::random_weights<double>());
  rme::NetworkPriorConfig<double> config;
  config.unknown.gaussian.mean << 3, 0.1, 0.2, 0.3;
  const auto is_fixed = [&](const Recording& recording, std::size_t count, double farthest) {
    config.farthest = farthest;
    return Prior(*network, 0.001, config)(recording.window, count).mean == config.unknown.gaussian.mean;
  };
  const Recording light(6, 250), heavy(6, 250, 1000);
  CHECK_FALSE(is_fixed(light, 200, 100));
  SECTION("too few samples since the event") {
    CHECK(is_fixed(light, 199, 100));
  }
  SECTION("more samples than the window has") {
    CHECK(is_fixed(light, light.window.size() + 1, 100));
  }
  SECTION("a load far beyond those of the training") {
    CHECK(is_fixed(heavy, 200, 100));
  }
}

TEST_CASE("NetworkPrior: where a pseudo-wrench cannot be had there is no guess, and the fixed prior stands",
          "[network_prior]") {
  // Six equal rows of 2^19: J J^T is 2^38 everywhere, exactly, beside which the damping is lost.
  const auto network = std::make_unique<Network>(*golden::random_weights<double>());
  rme::NetworkPriorConfig<double> config;
  config.damping = 1e-9;
  Window window(0.001);
  rme::Proprioception<double, 7> tick;
  tick.jacobian.col(0).setConstant(524288);
  for (int k = 0; k < 200; ++k) REQUIRE(window.push(tick) == rme::Status::Ok);
  const Prior prior(*network, 0.001, config);
  Eigen::Vector4d guess(1, 2, 3, 4);
  CHECK_FALSE(prior.guess(window, 200, guess));
  CHECK(guess == Eigen::Vector4d(1, 2, 3, 4));
  CHECK(prior(window, 200).mean == config.unknown.gaussian.mean);
}

TEST_CASE("NetworkPrior: the defaults are those of docs/weights.md", "[network_prior]") {
  const rme::NetworkPriorConfig<double> config;
  CHECK(config.standard_deviation == Eigen::Vector4d(0.5, 0.02, 0.02, 0.02));
  CHECK(config.unknown.gaussian.mean == Eigen::Vector4d(0.8, 0, 0, 0.1));
  CHECK(config.unknown.gaussian.standard_deviation().isApprox(Eigen::Vector4d(0.6, 0.05, 0.05, 0.06), 1e-12));
  CHECK(config.farthest == 4);
  CHECK(config.gravity == Eigen::Vector3d(0, 0, -9.81));
  CHECK(config.spacing == 0.01);
  CHECK(config.damping == 0.01);
}

TEST_CASE("NetworkPrior: another control rate sees the same instants", "[network_prior]") {
  const auto network = std::make_unique<Network>(*golden::random_weights<double>());
  rme::NetworkPriorConfig<double> config;
  config.farthest = 100;
  const Recording recording(7, 1000);
  rme::SampleWindow<double, 7> slow(0.005);
  for (std::size_t k = 4; k < recording.ticks.size(); k += 5) REQUIRE(slow.push(recording.ticks[k]) == rme::Status::Ok);
  CHECK(Prior(*network, 0.005, config)(slow, 40).mean == Prior(*network, 0.001, config)(recording.window, 200).mean);
}

TEST_CASE("NetworkPrior: a setting out of range is refused by name", "[network_prior]") {
  const auto network = std::make_unique<Network>(*golden::random_weights<double>());
  rme::NetworkPriorConfig<double> config;
  CHECK_THROWS_WITH(Prior(*network, 0.0, config), contains("NetworkPrior::dt"));
  CHECK_THROWS_WITH(Prior(*network, 0.02, config), contains("NetworkPriorConfig::spacing"));
  config.gravity.setZero();
  CHECK_THROWS_WITH(Prior(*network, 0.001, config), contains("NetworkPriorConfig::gravity"));
  config = {};
  config.standard_deviation[2] = 0;
  CHECK_THROWS_WITH(Prior(*network, 0.001, config), contains("NetworkPriorConfig::standard_deviation"));
  config = {};
  config.farthest = 0;
  CHECK_THROWS_WITH(Prior(*network, 0.001, config), contains("NetworkPriorConfig::farthest"));
  config = {};
  config.damping = 0;
  CHECK_THROWS_WITH(Prior(*network, 0.001, config), contains("NetworkPriorConfig::damping"));
  config = {};
  config.unknown.gaussian.covariance(1, 1) = 0;
  CHECK_THROWS_WITH(Prior(*network, 0.001, config), contains("NetworkPriorConfig::unknown"));
}

}  // namespace
