#include <cmath>
#include <random>
#include <rme/published/pseudo_wrench_sequence.hpp>
#include <vector>

#include "support/catch.hpp"

namespace {

using rme::InputFrame;
using rme::Status;
using Tick = rme::Proprioception<double, 6>;
using Sequence = Eigen::Matrix<double, 20, 6>;

/// Ticks whose Jacobian is the identity, so that a pseudo-wrench is tau_ext over 1 + damping; tick k has torque k.
std::vector<Tick> numbered(int count) {
  std::vector<Tick> ticks(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    ticks[static_cast<std::size_t>(k)].jacobian.setIdentity();
    ticks[static_cast<std::size_t>(k)].tau_ext.setConstant(k);
  }
  return ticks;
}

Status sequence_of(const std::vector<Tick>& ticks, double damping, InputFrame frame, Sequence& out) {
  const auto at = [&ticks](int i) noexcept -> const Tick& { return ticks.at(static_cast<std::size_t>(i)); };
  return rme::pseudo_wrench_sequence<double, 6>(static_cast<int>(ticks.size()), at, damping, frame, out);
}

TEST_CASE("pseudo_wrench_sequence: each is the newest of a twentieth of the window", "[published]") {
  Sequence sequence;
  for (const int count : {20, 50, 200, 237}) {
    CAPTURE(count);
    REQUIRE(sequence_of(numbered(count), 0.25, InputFrame::World, sequence) == Status::Ok);
    for (int i = 0; i < 20; ++i) {
      // The last whole sample that part i, which ends at (i + 1) count / 20, holds.
      const double newest = std::floor((i + 1) * count / 20.0) - 1;
      CHECK((sequence.row(i).array() - newest / 1.25).abs().maxCoeff() < 1e-12);
    }
  }
}

TEST_CASE("pseudo_wrench_sequence: it finds the wrench that acts, in the axes asked for", "[published]") {
  const unsigned seed = 510;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Tick> ticks(20);
  const rme::Vector6<double> wrench = rme::Vector6<double>::NullaryExpr([&] { return normal(random); });
  for (Tick& tick : ticks) {
    tick.jacobian = tick.jacobian.NullaryExpr([&] { return normal(random); });
    tick.jacobian.diagonal().array() += 5;  // far from singular: damping leaves the wrench nearly as it is
    tick.tau_ext = tick.jacobian.transpose() * wrench;
    tick.rotation = Eigen::AngleAxisd(normal(random), Eigen::Vector3d(1, 2, 2) / 3).toRotationMatrix();
  }
  Sequence world, hand;
  REQUIRE(sequence_of(ticks, 1e-9, InputFrame::World, world) == Status::Ok);
  REQUIRE(sequence_of(ticks, 1e-9, InputFrame::EndEffector, hand) == Status::Ok);
  for (int i = 0; i < 20; ++i) {
    CAPTURE(i);
    const Eigen::Matrix3d& R = ticks[static_cast<std::size_t>(i)].rotation;
    CHECK((world.row(i).transpose() - wrench).norm() < 1e-6);
    CHECK((R * hand.row(i).head<3>().transpose() - wrench.head<3>()).norm() < 1e-6);
    CHECK((R * hand.row(i).tail<3>().transpose() - wrench.tail<3>()).norm() < 1e-6);
  }
}

TEST_CASE("pseudo_wrench_sequence: too few samples and bad ones are refused by name", "[published]") {
  Sequence sequence;
  CHECK(sequence_of(numbered(19), 0.01, InputFrame::World, sequence) == Status::NotReady);
  CHECK(sequence_of(numbered(20), 0.0, InputFrame::World, sequence) == Status::NotPositiveDefinite);
  auto ticks = numbered(40);
  ticks[20].tau_ext[3] = std::nan("");
  CHECK(sequence_of(ticks, 0.01, InputFrame::World, sequence) == Status::Ok);  // that one is not looked at
  ticks[21].tau_ext[3] = std::nan("");
  CHECK(sequence_of(ticks, 0.01, InputFrame::World, sequence) == Status::NonFiniteInput);
}

}  // namespace
