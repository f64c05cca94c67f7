// rme_enclosure_cost: what does a bound cost, beside a probability?
//
// A simulated Panda at rest in poses near its ready pose (0.5 rad about it in each joint) takes up payloads of 0.2 to
// 2.5 kg. The first table draws readings whose errors are Gaussian, with a third of their bounds for standard
// deviations, cut off at the bounds, and compares the enclosure with the Gaussian posterior of the very same readings.
// The second one runs rme::Estimator. Prints the tables of docs/tracking.md. Exit code 0 if no truth was outside its
// enclosure and none was empty.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <rme/core/cholesky.hpp>
#include <rme/estimator.hpp>
#include <rme/inference/payload_enclosure.hpp>
#include <string>
#include <vector>

#include "enclosure_trial.hpp"
#include "io/program.hpp"
#include "support/held_arm.hpp"

namespace {

using rme::PayloadBox;
using rme::PayloadEnclosure;
using rme::Status;
using rme::examples::panda;
using rme::testing::Torque7;
using Config = rme::PayloadEnclosureConfig<double, 7>;

constexpr const char* kUsage =
    R"(usage: rme_enclosure_cost [options]

How wide is the enclosure of a payload, and how wide the posterior? Simulated Panda.

  --trials N        readings of each row (default 2000); the estimator runs on a tenth of them
  --seed N          (default 1)
  --help            this text

Exit codes: 0 no truth was outside its enclosure; 1 one was; 2 unusable arguments.
)";

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}
double median(const std::vector<double>& values) {
  return quantile(values, 0.5);
}

/// The largest gravity torque that links whose masses are wrong by this share leave in the poses of the tables.
Torque7 link_bound(double share) {
  std::mt19937_64 random(1);
  Torque7 largest = Torque7::Zero();
  for (int k = 0; k < 500; ++k) {
    const Torque7 q = rme::testing::random_pose_near_ready(random);
    Torque7 sum = Torque7::Zero();
    for (std::size_t l = 0; l < panda().links.size(); ++l) {
      auto one = panda();
      for (std::size_t i = 0; i < one.links.size(); ++i)
        if (i != l) one.links[i].body = {};
      sum += one.dynamics(q, Torque7::Zero()).gravity.cwiseAbs();
    }
    largest = largest.cwiseMax(sum);
  }
  return share * largest;
}

/// Half the width of the 90 % interval of the mass [kg], of the linear Gaussian model of the same readings: a third of
/// each bound is a standard deviation, and the offset is one unknown per joint.
double posterior_width(const rme::testing::Trial& trial, const Config& config, bool changes) {
  using Matrix = Eigen::Matrix<double, 11, 11>;
  Matrix precision = Matrix::Zero();
  precision(0, 0) = 1;                                // 1 kg
  for (int i = 1; i < 4; ++i) precision(i, i) = 100;  // 0.1 kg m
  const auto third = [](double bound) { return bound * bound / 9; };
  for (int j = 0; j < 7; ++j) precision(4 + j, 4 + j) = changes ? 1 : 1 / third(config.offset[j]);
  for (const auto& pose : trial.poses) {
    for (int j = 0; j < 7; ++j) {
      Eigen::Matrix<double, 11, 1> row = Eigen::Matrix<double, 11, 1>::Zero();
      row.head<4>() << pose.regressor.a[j], pose.regressor.B.row(j).transpose();
      row[4 + j] = changes ? 0 : 1;
      const double variance = changes ? third(config.drift[j]) + 2 * third(config.friction[j])
                                      : third(config.drift[j]) / 2 + third(config.friction[j]) + third(config.link[j]);
      precision += row * row.transpose() / variance;
    }
  }
  return 1.645 * std::sqrt(rme::Cholesky<double, 11>(precision).inverse()(0, 0));
}

struct Row {
  const char* what;
  Config config;
  bool changes;  // before and after; else only after
};

bool readings(const Row& row, int poses, unsigned seed, int trials) {
  std::mt19937_64 random(seed);
  PayloadEnclosure<double, 7> enclosure(row.config);
  std::vector<double> width, com, posterior;
  int outside = 0, empty = 0;
  for (int k = 0; k < trials; ++k) {
    const auto trial = rme::testing::random_trial(random, row.config, poses, rme::testing::Errors::Gaussian);
    enclosure.clear();
    for (const auto& pose : trial.poses)
      (void)(row.changes ? enclosure.add_change(pose.before, pose.after, pose.regressor)
                         : enclosure.add_loaded(pose.after, pose.regressor));
    PayloadBox<double> box;
    const Status status = enclosure.solve(box);
    empty += status != Status::Ok;
    if (status != Status::Ok) continue;
    outside += !rme::testing::contains(box, trial.truth);
    width.push_back(500 * (box.mass_upper - box.mass_lower));
    com.push_back(500 * (box.com_upper - box.com_lower).maxCoeff());
    posterior.push_back(1000 * posterior_width(trial, row.config, row.changes));
  }
  std::printf("| %-48s | %5d | %10.0f | %14.0f | %13.0f | %8.0f | %7d | %5d |\n", row.what, poses, median(width),
              quantile(width, 0.9), median(posterior), median(com), outside, empty);
  return outside == 0 && empty == 0;
}

/// One second after an attachment, at rest, the estimator beside the enclosure of the difference of two means over
/// 0.2 s.
bool tracked(unsigned seed, int arms) {
  std::mt19937_64 random(seed);
  const Config config = rme::testing::panda_bounds();
  std::vector<double> width, interval, error, middle;
  int held = 0, outside = 0, empty = 0;
  const auto estimator = std::make_unique<rme::Estimator<double, 7>>(rme::testing::HeldArm::kPeriod);
  for (int k = 0; k < arms; ++k) {
    rme::testing::HeldArm arm(random());
    *estimator = rme::Estimator<double, 7>(rme::testing::HeldArm::kPeriod);
    const auto trial = rme::testing::random_trial(random, config, 1, rme::testing::Errors::Gaussian);
    const Torque7 pose = rme::testing::random_pose_near_ready(random);
    const auto run = [&](int ticks) {
      Torque7 sum = Torque7::Zero();
      for (int t = 0; t < ticks; ++t) {
        const auto& sample = arm.tick();
        (void)estimator->update(sample);
        if (t >= ticks - 200) sum += sample.tau_ext;
      }
      return Torque7(sum / 200);
    };
    arm.move(pose, 2);
    const Torque7 before = run(3000);
    arm.hold(trial.truth);
    const Torque7 after = run(1000);
    PayloadEnclosure<double, 7> enclosure(config);
    (void)enclosure.add_change(before, after, rme::testing::panda_regressor(arm.pose()));
    PayloadBox<double> box;
    const Status status = enclosure.solve(box);
    empty += status != Status::Ok;
    if (status != Status::Ok) continue;
    outside += !rme::testing::contains(box, trial.truth);
    const auto& payload = estimator->state().payload;
    const double off = std::abs(payload.mean[0] - trial.truth.mass);
    width.push_back(500 * (box.mass_upper - box.mass_lower));
    middle.push_back(1000 * std::abs((box.mass_upper + box.mass_lower) / 2 - trial.truth.mass));
    interval.push_back(1645 * payload.standard_deviation()[0]);
    error.push_back(1000 * off);
    held += 1000 * off <= interval.back();
  }
  std::printf(
      "\n| %d attachments, 1 s after each | half width [g], median | error of its middle [g], median | worst | "
      "truth inside |\n|---|---:|---:|---:|---:|\n",
      arms);
  std::printf("| enclosure | %.0f | %.1f | %.0f | %.1f %% |\n", median(width), median(middle), quantile(middle, 1),
              100.0 * (arms - outside - empty) / arms);
  std::printf("| `Estimator`, 90 %% interval | %.0f | %.1f | %.0f | %.1f %% |\n", median(interval), median(error),
              quantile(error, 1), 100.0 * held / arms);
  return outside == 0 && empty == 0;
}

int run(rme::examples::Arguments& arguments) {
  const auto trials = static_cast<int>(arguments.whole("--trials", 10, 1000000).value_or(2000));
  const auto seed = static_cast<unsigned>(arguments.whole("--seed", 0).value_or(1));
  arguments.finish();
  Row difference{"after minus before: drift alone", rme::testing::panda_bounds(), true};
  Row friction{"the same, friction of 0.1 N m in each joint", difference.config, true};
  friction.config.friction.setConstant(0.1);
  Row alone{"after alone: offset of three standard deviations", difference.config, false};
  alone.config.offset = 3 * panda().typical_offset + alone.config.drift / 2;
  alone.config.link.setZero();
  Row good_links{"  and links whose mass is wrong by 3 % at most", alone.config, false};
  good_links.config.link = link_bound(0.03);
  Row links{"  and links whose mass is wrong by 5 % at most", alone.config, false};
  links.config.link = link_bound(0.05);
  Row cancelled{"after minus before: 5 % on links, offset, drift", links.config, true};
  std::printf("| %-48s | poses | median [g] | 90 %% below [g] | posterior [g] | com [mm] | outside | empty |\n",
              "readings, and what is stated");
  std::printf("|%s|------:|-----------:|---------------:|--------------:|---------:|--------:|------:|\n",
              std::string(50, '-').c_str());
  bool good = true;
  for (const Row& row : {difference, friction, alone, good_links, links, cancelled})
    for (int poses = 1; poses <= 3; ++poses) good = readings(row, poses, seed, trials) && good;
  good = tracked(seed, std::max(2, trials / 10)) && good;
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return rme::examples::run_program("rme_enclosure_cost", kUsage, argc, argv, run);
}
