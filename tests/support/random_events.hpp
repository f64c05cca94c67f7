#pragma once
/// Random payload events for the inference tests: random poses (any J, R), payloads, offsets and noise. The events are
/// drawn from the statistical model itself, with numbers of the size that a Panda has.
#include <Eigen/Core>
#include <array>
#include <random>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/inference/payload_statistics.hpp>
#include <vector>

namespace rme::testing {

constexpr int kDofs = 7;

/// The torque of a joint beside the payload's: N beta with beta ~ N(mean, covariance), in each sample another row of N.
struct JointFaults {
  Eigen::Matrix<double, Eigen::Dynamic, 3> N;  ///< 1, -direction of friction, -velocity
  Eigen::Vector3d mean;                        ///< offset [N m], Coulomb friction [N m], viscous friction [N m s/rad]
  Eigen::Matrix3d covariance;
};

struct Event {
  Eigen::Vector4d truth;
  PayloadStatistics<double, kDofs> statistics;
  JointVector<double, kDofs> precision;  ///< of the white noise [1/(N m)^2]
  std::array<JointFaults, kDofs> faults;
  std::vector<PayloadObservation<double, kDofs>> samples;
};

/// The likelihood of an event's samples with its faults integrated out, from the full covariance of each joint: neither
/// too sharp nor too wide, as an honest one would be.
/// @param precision  of the white noise, in place of the event's
PayloadLikelihood<double> likelihood_of(const Event& event, const JointVector<double, kDofs>& precision);
PayloadLikelihood<double> likelihood_of(const Event& event);

Eigen::Vector3d gaussian3(std::mt19937_64& random);

/// A pose of an arm that nobody has built.
struct Pose {
  Jacobian<double, kDofs> jacobian;
  Eigen::Matrix3d rotation;
};

/// Seven random joint axes within reach of the flange.
Pose random_pose(std::mt19937_64& random);

/// A payload of 0.2 to 2 kg, CoM within 8 cm across and 20 cm along z; `samples` ticks at rest or swinging gently.
Event random_event(std::mt19937_64& random, int samples = 50, bool friction = false);

/// The prior of the tests: what one expects of things that hands pick up.
PayloadGaussian<double> wide_prior();

}  // namespace rme::testing
