#include <deque>
#include <fstream>
#include <random>
#include <rme/sensing/mismatch_detector.hpp>
#include <stdexcept>

#include "support/catch.hpp"

namespace {

using rme::MismatchDetector;
using rme::MismatchDetectorConfig;
using rme::Status;
using Scalar1 = MismatchDetector<1>::Signal;

/// Algorithm 1 as printed, with the absolute value that the scan drops: x holds the last 500 samples, x[0] is sample 1.
struct AlgorithmOne {
  double activation_threshold, stabilization_threshold;
  std::deque<double> x;

  bool update(double norm) {
    x.push_back(norm);
    if (x.size() > 500) x.pop_front();
    if (x.size() < 500) return false;
    const auto at = [this](int i) { return x[static_cast<std::size_t>(i - 1)]; };
    const auto mean = [&at](int from, int to) {
      double sum = 0;
      for (int i = from; i <= to; ++i) sum += at(i);
      return sum / (to - from + 1);
    };
    const bool rapid_change = std::abs(at(500) - at(1)) > activation_threshold;
    const double stabilization_checks[] = {mean(431, 450), mean(351, 370), mean(271, 290)};
    const double end_stabilization = mean(491, 500);
    bool stabilization = true;
    for (const double check : stabilization_checks)
      if (std::abs(check - end_stabilization) > stabilization_threshold) stabilization = false;
    return rapid_change && stabilization;
  }
};

/// Plays the signal to both; returns how often they detected.
template <typename NextSample>
int expect_equal(int samples, NextSample&& next) {
  const MismatchDetectorConfig config = MismatchDetectorConfig::published();
  MismatchDetector<1> detector(1e-3, config);
  AlgorithmOne literal{config.activation_threshold, config.stabilisation_threshold, {}};
  int detections = 0;
  for (int k = 0; k < samples; ++k) {
    const double norm = next();
    const bool expected = literal.update(norm);
    detections += expected ? 1 : 0;
    if (detector.update(Scalar1(norm)) != Status::Ok || detector.detected() != expected) {
      CAPTURE(k, norm);
      REQUIRE(detector.detected() == expected);
    }
  }
  return detections;
}

TEST_CASE("MismatchDetector: equals a literal Algorithm 1 on a million random samples", "[detector]") {
  const unsigned seed = 50;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, 0.05);
  std::exponential_distribution<double> size(0.7);
  std::uniform_int_distribution<int> pause(50, 1500);
  double level = 1, target = 1;
  int left = 700;
  const int detections = expect_equal(1000000, [&] {
    if (--left == 0) {  // steps of all sizes, some before the last one has settled
      target = size(random);
      left = pause(random);
    }
    level += 0.05 * (target - level);  // the observer's 20 ms
    return std::abs(level + noise(random));
  });
  CHECK(detections > 10000);
  CHECK(detections < 900000);
}

TEST_CASE("MismatchDetector: equals a literal Algorithm 1 on a recorded attachment", "[detector]") {
  std::ifstream file(RME_TEST_DATA "/attach_norm.csv");
  std::string header;
  REQUIRE(std::getline(file, header));
  std::vector<double> norms;
  for (double norm; file >> norm;) norms.push_back(norm);
  REQUIRE(norms.size() == 1500);
  std::size_t k = 0;
  CHECK(expect_equal(1500, [&] { return norms[k++]; }) > 0);
}

TEST_CASE("MismatchDetector: neither a year of running nor a large level leaves a trace in the sums", "[detector]") {
  // 2^20 N m for 20,000 ticks wraps the 64-bit sums; the published algorithm on the last 500 samples knows nothing of
  // it.
  const MismatchDetectorConfig config = MismatchDetectorConfig::published();
  MismatchDetector<1> detector(1e-3, config);
  for (int k = 0; k < 20000; ++k) REQUIRE(detector.update(Scalar1(1048576.0)) == Status::Ok);
  AlgorithmOne literal{config.activation_threshold, config.stabilisation_threshold, {}};
  for (int k = 0; k < 500; ++k) literal.update(1048576.0);
  for (int k = 0; k < 700; ++k) {
    const double norm = 1048570 + std::sin(0.01 * k);
    const bool expected = literal.update(norm);
    REQUIRE(detector.update(Scalar1(norm)) == Status::Ok);
    REQUIRE(detector.detected() == expected);
  }
}

TEST_CASE("MismatchDetector: the published form fires within a transient, the default waits until it is over",
          "[detector]") {
  // A step of 10 N m through the observer's 20 ms, noise-free: within 0.2 N m of its end after 20 ln(50) = 78 ms.
  const auto first_detection = [](const MismatchDetectorConfig& config) {
    MismatchDetector<1> detector(1e-3, config);
    double level = 0;
    for (int k = 0; k < 2000; ++k) {
      if (k >= 1000) level += 0.0488 * (10 - level);
      (void)detector.update(Scalar1(level));
      if (detector.detected()) return k - 1000;
    }
    return -1;
  };
  CHECK(first_detection(MismatchDetectorConfig::published()) >= 0);
  CHECK(first_detection(MismatchDetectorConfig::published()) < 10);
  CHECK(first_detection(MismatchDetectorConfig()) > 78);
  CHECK(first_detection(MismatchDetectorConfig()) < 400);
}

TEST_CASE("MismatchDetector: removal is a change as well", "[detector]") {
  MismatchDetector<1> detector(1e-3);
  int detections = 0;
  for (int k = 0; k < 1500; ++k) {
    REQUIRE(detector.update(Scalar1(k < 800 ? 5.0 : 0.1)) == Status::Ok);
    detections += detector.detected() ? 1 : 0;
  }
  CHECK(detections > 0);
}

TEST_CASE("MismatchDetector: a change that leaves the norm alone is seen by all joints together", "[detector]") {
  MismatchDetector<2> joints(1e-3);
  MismatchDetector<1> norm(1e-3);
  bool seen_by_joints = false, seen_by_norm = false;
  for (int k = 0; k < 1500; ++k) {
    const Eigen::Vector2d tau = k < 800 ? Eigen::Vector2d(3, 0) : Eigen::Vector2d(0, 3);
    REQUIRE(joints.update(tau) == Status::Ok);
    REQUIRE(norm.update(Scalar1(tau.norm())) == Status::Ok);
    seen_by_joints = seen_by_joints || joints.detected();
    seen_by_norm = seen_by_norm || norm.detected();
  }
  CHECK(seen_by_joints);
  CHECK_FALSE(seen_by_norm);
}

TEST_CASE("MismatchDetector: at 250 Hz it sees the same step after the same time", "[detector]") {
  const auto delay = [](double dt) {
    MismatchDetector<1> detector(dt);
    for (int k = 0;; ++k) {
      (void)detector.update(Scalar1(k * dt < 1 - 1e-9 ? 0.0 : 3.0));
      if (detector.detected()) return k * dt - 1;
      if (k * dt > 3) return -1.0;
    }
  };
  CHECK(delay(0.004) == Approx(delay(0.001)).margin(0.01));
  CHECK(delay(0.001) > 0);
}

TEST_CASE("MismatchDetector: bad samples are refused and leave no trace", "[detector]") {
  MismatchDetector<1> detector(1e-3), clean(1e-3);
  for (int k = 0; k < 1200; ++k) {
    const double norm = k < 700 ? 0.2 : 2.0;
    if (k % 10 == 3) {
      CHECK(detector.update(Scalar1(std::nan(""))) == Status::NonFiniteInput);
      CHECK(detector.update(Scalar1(std::numeric_limits<double>::infinity())) == Status::NonFiniteInput);
      CHECK(detector.update(Scalar1(-2e6)) == Status::NonFiniteInput);
    }
    REQUIRE(detector.update(Scalar1(norm)) == Status::Ok);
    REQUIRE(clean.update(Scalar1(norm)) == Status::Ok);
    REQUIRE(detector.detected() == clean.detected());
  }
}

/// A window that begins at 0, stands at `level` in between, and at `last` in its newest 10 ms.
MismatchDetector<1> after(double level, double last, const MismatchDetectorConfig& config) {
  MismatchDetector<1> detector(1e-3, config);
  for (int k = 0; k < 700; ++k) REQUIRE(detector.update(Scalar1(k < 250 ? 0 : k < 690 ? level : last)) == Status::Ok);
  return detector;
}

TEST_CASE(
    "MismatchDetector: a change equal to its threshold is not rapid, and means that differ by theirs have settled",
    "[detector]") {
  // (T44): > and <=. Quarters of a newton metre are exact in the sums.
  MismatchDetectorConfig config = MismatchDetectorConfig::published();
  config.activation_threshold = 1.25;
  config.stabilisation_threshold = 0.25;
  const double step = 1.0 / 1048576;
  CHECK_FALSE(after(1, 1.25, config).rapid_change());
  CHECK(after(1, 1.25 + step, config).rapid_change());
  CHECK(after(1, 1.25, config).stabilised());
  CHECK_FALSE(after(1, 1.25 + step, config).stabilised());
}

TEST_CASE("MismatchDetector: after a large change what is left may be its ratio, after a small one the threshold",
          "[detector]") {
  MismatchDetectorConfig config;
  config.stabilisation_threshold = 0.2;
  config.stabilisation_ratio = 0.05;
  config.edge_average = 0;
  CHECK(after(96, 100, config).stabilised());  // 4 N m off, of 5
  CHECK_FALSE(after(94, 100, config).stabilised());
  CHECK(after(0.85, 1, config).stabilised());  // 0.15 N m off, of 0.2
  CHECK_FALSE(after(0.75, 1, config).stabilised());
}

TEST_CASE("MismatchDetector: a span that rounding would push beyond the window ends with it", "[detector]") {
  // 10.4 periods are 10 samples; an age of 8.5 and a length of 1.9 are 9 and 2.
  MismatchDetectorConfig config;
  config.window = 10.4;
  config.check_age = {0, 0, 8.5};
  config.check_average = 1.9;
  MismatchDetector<1> detector(1, config);
  for (int k = 0; k < 50; ++k) {
    REQUIRE(detector.update(Scalar1(5)) == Status::Ok);
    CHECK(detector.stabilised() == (k >= 9));
    CHECK_FALSE(detector.rapid_change());
  }
}

TEST_CASE("MismatchDetector: a setting out of range is refused by name", "[detector]") {
  MismatchDetectorConfig config;
  config.activation_threshold = std::nan("");
  CHECK_THROWS_WITH(MismatchDetector<1>(1e-3, config), contains("activation_threshold"));
  config = MismatchDetectorConfig();
  config.check_age[2] = 0.6;
  CHECK_THROWS_WITH(MismatchDetector<1>(1e-3, config), contains("check_age"));
  CHECK_THROWS_WITH(MismatchDetector<1>(0), contains("dt"));
  // A fraction; 1 would call everything settled.
  for (const double ratio : {-0.1, 1.0, 2.0, std::nan("")}) {
    config = MismatchDetectorConfig();
    config.stabilisation_ratio = ratio;
    CHECK_THROWS_WITH(MismatchDetector<1>(1e-3, config), contains("stabilisation_ratio"));
  }
  // At least an oldest and a newest sample, and less than memory for a day.
  config = MismatchDetectorConfig();
  CHECK_NOTHROW(MismatchDetector<1>(0.25, config));
  CHECK_THROWS_WITH(MismatchDetector<1>(0.26, config), contains("::window") && contains("got 1.92"));
  config.window = 5e6;
  CHECK_THROWS_WITH(MismatchDetector<1>(0.5, config), contains("::window") && contains("got 10000000.0"));
  CHECK_THROWS_WITH(MismatchDetector<1>(0.25, config), contains("::window") && contains("got 20000000.0"));
  // A span may fill the window, and no more; one of 0 s is a single sample.
  config = MismatchDetectorConfig();
  config.check_age = {0.48, 0, 0};
  CHECK_NOTHROW(MismatchDetector<1>(1e-3, config));
  config.check_age[0] = 0.49;
  CHECK_THROWS_WITH(MismatchDetector<1>(1e-3, config), contains("check_age") && contains("got 0.51"));
  config.check_age = {0, 0, 0};
  for (const double average : {0.0, 0.5}) {
    config.check_average = average;
    CHECK_NOTHROW(MismatchDetector<1>(1e-3, config));
  }
  for (const double average : {-0.1, 0.6, std::nan("")}) {
    config.check_average = average;
    CHECK_THROWS_WITH(MismatchDetector<1>(1e-3, config), contains("check_average"));
  }
}

}  // namespace
