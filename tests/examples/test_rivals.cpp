#include <rivals/observer_matched.hpp>
#include <rivals/run_score.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"
#include "swinging_panda.hpp"

namespace {

using namespace rme::examples;
using rme::testing::Swing;
using rme::testing::swinging_panda;

TEST_CASE("RecursiveLeastSquares: without forgetting, it is the batch solution of all rows", "[rivals]") {
  std::mt19937 random(3);
  const Eigen::MatrixXd H = oracle::random_matrix(random, 60, 4);
  const Eigen::VectorXd y = oracle::random_matrix(random, 60, 1),
                        weight = oracle::random_matrix(random, 60, 1).cwiseAbs2();
  const Eigen::Vector4d ridge(0.1, 0.2, 0.3, 0.4);
  RecursiveLeastSquares fit(ridge, 0);
  for (int i = 0; i < 60; i += 6) {
    fit.age(1);
    fit.add(H.middleRows(i, 6), y.segment(i, 6), weight.segment(i, 6));
  }
  const Eigen::MatrixXd W = weight.asDiagonal();
  const Eigen::MatrixXd A = H.transpose() * W * H + Eigen::MatrixXd(ridge.asDiagonal());
  CHECK((fit.solution() - oracle::solve(A, H.transpose() * W * y)).norm() < 1e-12);
}

TEST_CASE("RecursiveLeastSquares: what changes is followed as its memory says, and the ridge is not forgotten",
          "[rivals]") {
  // One parameter, a row of 1 a second: A and b are geometric series with the ratio k = exp(-1/5).
  const double k = std::exp(-0.2), ridge = 0.3;
  RecursiveLeastSquares fit(Eigen::VectorXd::Constant(1, ridge), 5);
  const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1);
  double A = 0, b = 0;
  for (int i = 0; i < 30; ++i) {
    const double y = i < 20 ? 2 : 5;
    fit.age(1);
    fit.add(one, Eigen::VectorXd::Constant(1, y), Eigen::VectorXd::Ones(1));
    A = (1 - std::pow(k, i + 1)) / (1 - k);
    b = k * b + y;
    CHECK(fit.solution()[0] == Approx(b / (A + ridge)));
  }
}

/// Arm, settings, samples and blocks of a log.
struct Played {
  ArmSettings<7> settings;
  Log<7> log;
  Samples<7> samples;
  LogBlocks blocks;
  explicit Played(const Swing& swing) : log(swinging_panda(swing)) {
    settings.arm.model = panda();
    samples = samples_of(log, settings.arm, settings.config);
    blocks = blocks_of(log, samples, settings.arm);
  }
};

TEST_CASE("Tare: offset and friction of the empty arm, and nothing of them is left", "[rivals]") {
  Swing swing;
  swing.coulomb = 0.4;
  swing.viscous = 0.2;
  swing.offset = 0.1;
  const Played empty(swing);
  const Tare tare = Tare::of(empty.blocks);
  for (int j = 0; j < 7; ++j) {
    CAPTURE(j);
    CHECK(tare.offset[j] == Approx(0.1).margin(0.01));
    CHECK(tare.coulomb[j] == Approx(0.4).margin(0.04));
    CHECK(tare.viscous[j] == Approx(0.2).margin(0.06));
  }
  const Eigen::MatrixXd left = empty.blocks.tau - tare.torque(empty.blocks);
  CHECK(left.norm() < 0.25 * empty.blocks.tau.norm());
  CHECK(Tare::none(7).torque(empty.blocks).isZero(0));
}

TEST_CASE("ObserverMatchedLeastSquares: the ten parameters of what swings, whatever the observer's bandwidth",
          "[rivals]") {
  Swing swing;
  swing.payload = box(1.2, {0.03, -0.02, 0.08}, {0.2, 0.15, 0.1});
  const auto truth = rme::InertialParameters<double>::of_body({1.2, {0.03, -0.02, 0.08}}, swing.payload.inertia);
  for (const double bandwidth : {10.0, 50.0, 0.0}) {
    CAPTURE(bandwidth);
    const Log<7> log = swinging_panda(swing);
    ArmSettings<7> settings;
    settings.arm.model = panda();
    settings.config.observer_bandwidth = bandwidth;
    const Samples<7> samples = samples_of(log, settings.arm, settings.config);
    ObserverMatchedLeastSquares<7> fit(settings.config.gravity, 3, bandwidth, 0);
    for (const auto& sample : samples.sample)  // noise of 1 mN m, beside which the ridge does not count
      fit.update(sample, rme::JointVector<double, 7>::Zero(), 0.004, Eigen::VectorXd::Constant(7, 1e6));
    // What the trapezoidal rule of the observer leaves at 250 Hz is below a thousandth.
    CHECK((fit.solution() - truth.vector()).head<4>().norm() < 2e-3);
    CHECK((fit.solution() - truth.vector()).tail<6>().norm() < 2e-3);
  }
}

TEST_CASE("run_rivals: each finds what the hand holds, with the tare of the empty arm", "[rivals]") {
  Swing swing;
  swing.coulomb = 0.4;
  swing.offset = 0.3;
  swing.noise = 0.02;
  const Played empty(swing);
  swing.phase = 20;
  swing.payload = box(1.2, {0.03, -0.02, 0.08}, {0.1, 0.1, 0.1});
  const Played loaded(swing);
  const auto run = [&](bool with_tare, bool simulated) {
    return run_rivals<7>(
        {loaded.log, loaded.samples, loaded.settings, with_tare ? &empty.log : nullptr, nullptr, simulated});
  };
  const std::vector<Rival> tared = run(true, false), raw = run(false, false);
  REQUIRE(tared.size() >= 3);
  REQUIRE(tared.size() == raw.size());
  for (std::size_t i = 0; i < tared.size(); ++i) {
    CAPTURE(tared[i].name);
    REQUIRE(!tared[i].masses.empty());
    const double error = std::abs(tared[i].masses.back().mass - 1.2);
    CHECK(error < 0.05);
    // Batch least squares finds offset and friction by itself. The others are wrong without a tare.
    if (tared[i].name != "batch least squares") CHECK(std::abs(raw[i].masses.back().mass - 1.2) > 2 * error);
  }
  for (const Rival& rival : run(true, true)) CHECK(rival.name != "KDL's wrench");
  Log<7> other = empty.log;
  other.tau_ext = other.tau;
  CHECK_THROWS_AS(run_rivals<7>({loaded.log, loaded.samples, loaded.settings, &other, nullptr, false}), LogError);
}

TEST_CASE("run_rivals: the published pipeline estimates with the network it is given", "[rivals]") {
  // At rest until 2 s, and with 1 kg from then on: the step that it waits for.
  Played still{Swing()};
  const auto& arm = still.settings.arm.model;
  const rme::Payload<double> payload{1, {0, 0, 0.1}};
  const auto at = arm.kinematics(arm.ready);
  const rme::JointVector<double, 7> pull = at.jacobian.transpose() * rme::payload_wrench(payload, at.rotation).vector();
  Log<7> log = still.log;
  log.tau.clear();
  for (std::size_t i = 0; i < log.size(); ++i) {
    log.q[i] = arm.ready;
    log.dq[i].setZero();
    log.tau_ext.push_back(log.t[i] < 2 ? rme::JointVector<double, 7>(0 * pull) : pull);
  }
  still.settings.config.observer_bandwidth = 0;
  const Samples<7> samples = samples_of(log, still.settings.arm, still.settings.config);
  const NetworkFile network = read_network_file(RME_NETWORK);
  const auto published = [&](const NetworkFile* given) {
    for (const Rival& rival : run_rivals<7>({log, samples, still.settings, nullptr, given, false}))
      if (rival.name == "published pipeline") return rival.masses;
    return std::vector<MassAt>();
  };
  CHECK(published(nullptr).empty());
  const std::vector<MassAt> masses = published(&network);
  REQUIRE(masses.size() == log.size());
  CHECK(masses[250].mass == 0);
  CHECK(std::isnan(masses[250].deviation));
  CHECK(masses.back().mass == Approx(1).margin(0.1));
  CHECK(masses.back().deviation > 0);
}

TEST_CASE("score_run: errors, their time, and what an empty hand was taken to hold", "[rivals]") {
  // 2 kg in the hand, from t = 100 s on; 1 kg is estimated until 103 s, then 2.1 until 107 s, then 1.9, at 10 Hz.
  std::vector<MassAt> masses;
  for (int k = 0; k <= 100; ++k)
    masses.push_back({100 + 0.1 * k, k < 30 ? 1 : k < 70 ? 2.1 : 1.9, k < 75 ? 0.1 : 0.05});
  const RunScore score = score_run(masses, 2, 100, 102);
  CHECK(score.mean_error == Approx(0.1));
  CHECK(score.largest_error == Approx(1));  // at 102 s, when it has moved for two seconds
  CHECK(score_run(masses, 2, 100, 104).largest_error == Approx(0.1));
  CHECK(score.end_error == Approx(0.1));
  CHECK(score.close == Approx(2.9).margin(0.11));
  CHECK(score.largest_mass == Approx(2.1));
  // 1.645 * 0.1 holds an error of 0.1, 1.645 * 0.05 does not: 105 to 107.4 s of 105 to 110 s.
  CHECK(score.held == Approx(0.49).margin(0.03));
  CHECK(std::isnan(score_run(masses, 4, 100, 102).close));
  const RunScore once = score_run({{110, 1.5, std::nan("")}}, 2, 100, 102);
  CHECK(once.mean_error == Approx(0.5));
  CHECK(once.end_error == Approx(0.5));
  CHECK(std::isnan(once.held));
}

TEST_CASE("moved_for: an arm that rests at first has moved for two seconds two seconds after it began", "[rivals]") {
  Played still{Swing()};
  for (std::size_t i = 0; i < still.log.size() && still.log.t[i] < 3; ++i) still.samples.sample[i].dq.setZero();
  CHECK(moved_for(still.log, still.samples, 2) == Approx(5).margin(0.01));
  CHECK(moved_for(still.log, still.samples, 60) == still.log.t.back());
}

}  // namespace
