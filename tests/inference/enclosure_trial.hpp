#pragma once
/// Readings of a Panda at rest whose errors stay within stated bounds, drawn term by term as docs/theory.md (T46) has
/// them.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>
#include <rme/inference/payload_enclosure.hpp>
#include <synthetic_arm/panda.hpp>
#include <vector>

namespace rme::testing {

using Torque7 = JointVector<double, 7>;

/// What is stated of a Panda's sensors: the noise that is left in a reading is an eighth of the typical offset, and three
/// of its standard deviations bound it; nothing else differs between two readings.
inline PayloadEnclosureConfig<double, 7> panda_bounds() {
  PayloadEnclosureConfig<double, 7> config;
  config.drift = 6.0 / 8.0 * examples::panda().typical_offset;
  config.mass_limit = 3;
  config.com_lower.setConstant(-0.25);
  config.com_upper.setConstant(0.25);
  return config;
}

struct RestingPose {
  PayloadRegressor<double, 7> regressor;
  Torque7 before, after;
};

struct Trial {
  Payload<double> truth;
  std::vector<RestingPose> poses;

  Vector4<double> phi() const {
    Vector4<double> out;
    out << truth.mass, truth.mass * truth.com;
    return out;
  }
};

/// How the errors are distributed: at either bound, evenly between the bounds, or Gaussian with a third of the bound for
/// a standard deviation, cut off at the bound.
enum class Errors { AtBounds, WithinBounds, Gaussian };

inline PayloadRegressor<double, 7> panda_regressor(const Torque7& q) {
  const auto at = examples::panda().kinematics(q);
  return payload_regressor<double, 7>(at.jacobian, at.rotation, standard_gravity<double>());
}

inline Torque7 random_pose_near_ready(std::mt19937_64& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  Torque7 q = examples::panda().ready;
  for (int j = 0; j < 7; ++j) q[j] += 0.5 * u(random);
  return q;
}

/// A payload of 0.2 to 2.5 kg within 0.2 m, read before and after in each pose. Errors whose bound is infinite are of the
/// size of an arm's, 1 N m.
/// @param factor  by which the errors exceed their bounds
inline Trial random_trial(std::mt19937_64& random, const PayloadEnclosureConfig<double, 7>& config, int poses,
                          Errors errors, double factor = 1) {
  std::uniform_real_distribution<double> u(-1, 1);
  std::normal_distribution<double> normal;
  const auto error = [&](double bound) {
    const double size = factor * (std::isfinite(bound) ? bound : 1);
    if (errors == Errors::Gaussian) return size * std::clamp(normal(random) / 3, -1.0, 1.0);
    const double x = u(random);
    return size * (errors == Errors::WithinBounds ? x : x > 0 ? 1 : -1);
  };
  Trial trial;
  trial.truth.mass = 1.35 + 1.15 * u(random);
  for (int i = 0; i < 3; ++i) trial.truth.com[i] = 0.2 * u(random);
  Torque7 offset;  // about which it drifts by half the drift
  for (int j = 0; j < 7; ++j) {
    const double drift = std::min(config.drift[j], 2 * config.offset[j]);
    offset[j] = error(std::isfinite(config.offset[j]) ? config.offset[j] - drift / 2 : 1);
  }
  for (int k = 0; k < poses; ++k) {
    RestingPose pose;
    pose.regressor = panda_regressor(random_pose_near_ready(random));
    const Torque7 payload = pose.regressor.torque(trial.truth);
    for (int j = 0; j < 7; ++j) {
      const double drift = std::min(config.drift[j], 2 * config.offset[j]);
      const double link = error(config.link[j]);
      for (const bool loaded : {false, true}) {
        double& reading = loaded ? pose.after[j] : pose.before[j];
        reading = offset[j] + link;
        const double gain = error(config.gain[j]);
        if (loaded) reading += (1 + gain) * payload[j];
        const double drifted = error(drift / 2), friction = error(config.friction[j]);
        reading += drifted + friction;
      }
    }
    trial.poses.push_back(pose);
  }
  return trial;
}

/// Whether the truth is in the box.
template <typename Scalar>
bool contains(const PayloadBox<Scalar>& box, const Payload<double>& truth) {
  bool inside = double(box.mass_lower) <= truth.mass && truth.mass <= double(box.mass_upper);
  for (int i = 0; i < 3; ++i) {
    const double moment = truth.mass * truth.com[i];
    inside = inside && double(box.moment_lower[i]) <= moment && moment <= double(box.moment_upper[i]) &&
             double(box.com_lower[i]) <= truth.com[i] && truth.com[i] <= double(box.com_upper[i]);
  }
  return inside;
}

}  // namespace rme::testing
