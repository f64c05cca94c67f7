#pragma once
/// The accuracy that a user may expect of rme on an arm: that of rme::Estimator itself, with the settings that will run,
/// when payloads are simulated onto logs of the empty hand from which these settings were not made.
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "paper/injection/payload_injection.hpp"
#include "precompiled/any_joints.hpp"
#include "replay_log/options.hpp"

namespace rme::examples {

/// When the estimates are compared with the truth, after the payload is attached [s].
constexpr std::array<double, 3> kAfter = {0.2, 1, 5};
/// Masses of the simulated payloads, as shares of the rated payload. Errors are of those from kWeighed on; the lighter
/// ones show what is found at all.
constexpr std::array<double, 7> kShares = {0.01, 0.02, 0.05, 0.1, 0.2, 0.35, 0.5};
constexpr std::size_t kWeighed = 3;

/// The estimate some time after a simulated payload was attached.
struct TrialAnswer {
  std::size_t after;  ///< index into kAfter
  bool moving;        ///< the arm has moved for more than half of that time
  bool found;         ///< something is probably held
  double error;       ///< of the mass [kg]
  double deviation;   ///< stated standard deviation of the mass [kg]
  double centre;      ///< distance of the estimated centre of mass from the true one [m]
};

/// A simulated payload.
struct Trial {
  double t;           ///< when it is attached [s]
  std::size_t share;  ///< index into kShares
  double mass;        ///< [kg]
  std::vector<TrialAnswer> answers;
};

/// What came of a part of the logs that the settings were not made from.
struct HeldOutTest {
  std::vector<Trial> trials;
  double seconds = 0;       ///< of the part, as it was recorded: an empty hand
  int false_payloads = 0;   ///< events that attached something to the empty hand
  double largest_mass = 0;  ///< largest mass that was held with a probability above 0.9 while the hand was empty [kg]
};

/// Errors after some time, at rest or in motion.
struct PromiseRow {
  std::size_t after;  ///< index into kAfter
  bool moving;
  int answers;
  double error;     ///< mean absolute error of the mass [kg]
  double worst;     ///< error that one answer in twenty exceeds [kg]
  double coverage;  ///< share of the 90 % intervals of the mass that hold it
  double centre;    ///< mean distance of the centre of mass from the true one [m]
};

/// The errors, summed up.
struct Promise {
  std::vector<PromiseRow> rows;
  std::array<double, kAfter.size()> lightest;  ///< that is found in 95 % within each time [kg]; infinite: none
  double coverage = 1;                         ///< of all answers after a second and more
};

/// Sums up.
/// @param rated  rated payload [kg]
Promise promise_of(const HeldOutTest& test, double rated);

/// The settings with wider priors: noise, offset and residual are `factor` times as large.
template <int Dofs>
EstimatorConfig<double, Dofs> widened(EstimatorConfig<double, Dofs> config, double factor) {
  ArmPrior<double, Dofs> arm = config.arm.value_or(ArmPrior<double, Dofs>::of(config.rated_payload));
  arm.noise *= factor;
  arm.offset *= factor;
  arm.residual *= factor;
  config.arm = arm;
  return config;
}

/// Attaches payloads of each mass to a log of the empty hand at instants that are evenly spread from `begin` to `end` [s],
/// each to an estimator that was started five seconds earlier; and plays the log from `begin` to `end` as it is. Adds the
/// results to `test`.
/// @param samples   of the log
/// @param instants  number of instants
/// @param random    draws centres of mass: within 8 cm across, and up to 20 cm along the z axis of the tip
template <int Dofs>
void rehearse(const Log<Dofs>& log, const Samples<Dofs>& samples, const ArmSettings<Dofs>& settings, double begin,
              double end, int instants, std::mt19937_64& random, HeldOutTest& test) {
  constexpr double kWarm = 1, kBefore = 5, kLater = 0.1, kMoves = 0.02, kSlowest = 0.1;  // [s], ..., [rad/s], [s]
  EstimatorConfig<double, Dofs> config = settings.config;
  config.observer_bandwidth = samples.bandwidth;
  config.torque_sign = samples.sign;
  const auto motion = motion_of(log, samples);
  const auto fresh = std::make_unique<const Estimator<double, Dofs>>(std::min(samples.timing.period, kSlowest), config);
  const auto estimator = std::make_unique<Estimator<double, Dofs>>(*fresh);
  const auto copy = std::make_unique<Estimator<double, Dofs>>(*fresh);
  const auto uniform = [&random](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const auto time_of = [&](std::size_t k) { return log.t[samples.row[k]]; };
  const auto attach = [&](std::size_t share, double t) {
    Payload<double> payload;
    payload.mass = kShares[share] * settings.config.rated_payload;
    for (int i = 0; i < 2; ++i) payload.com[i] = uniform(-0.08, 0.08);
    payload.com[2] = uniform(0, 0.2);
    const double radius = uniform(0.015, 0.04);  // of gyration: boxes of 4 to 10 cm
    const Injected injection{
        t, InertialParameters<double>::of_body(payload, payload.mass * radius * radius * Eigen::Matrix3d::Identity())};
    const Samples<Dofs> loaded = injected(log, samples, motion, settings.arm.model.gravity_vector, injection, t,
                                          std::min(end, t + kAfter.back() + kLater));
    Trial trial{t, share, payload.mass, {}};
    double moved = 0;
    for (std::size_t i = 0; i < loaded.sample.size() && trial.answers.size() < kAfter.size(); ++i) {
      const double since = log.t[loaded.row[i]] - t;
      if (since >= kAfter[trial.answers.size()]) {
        const auto& state = copy->state();
        trial.answers.push_back({trial.answers.size(), moved > 0.5 * since, !state.empty(),
                                 state.payload.mean[0] - payload.mass, state.payload.standard_deviation()[0],
                                 (state.payload.mean.template tail<3>() - payload.com).norm()});
      }
      if (loaded.sample[i].dq.cwiseAbs().maxCoeff() > kMoves) moved += loaded.sample[i].period;
      static_cast<void>(copy->update(loaded.sample[i]));  // a sample that is refused does not count
    }
    test.trials.push_back(trial);
  };

  // Five seconds fit in for as many instants as possible, at least for the first half of a short part.
  const double first = std::max(begin, log.t.front() + kWarm);
  const double last = std::max(end - kAfter.back() - kLater, 0.5 * (first + end));
  for (int i = 0; i < instants; ++i) {
    const double t = first + (last - first) * (i + 0.5) / instants;
    *estimator = *fresh;
    for (std::size_t k = 0; k < samples.sample.size() && time_of(k) < t; ++k)
      if (time_of(k) >= t - kBefore) static_cast<void>(estimator->update(samples.sample[k]));
    for (std::size_t share = 0; share < kShares.size(); ++share) {
      *copy = *estimator;
      attach(share, t);
    }
  }

  *estimator = *fresh;
  int events = 0;
  for (std::size_t k = 0; k < samples.sample.size(); ++k) {
    if (time_of(k) < begin || time_of(k) >= end) continue;
    static_cast<void>(estimator->update(samples.sample[k]));
    const auto& state = estimator->state();
    if (state.event.number > events && state.event.kind == EventKind::Attached) ++test.false_payloads;
    events = state.event.number;
    if (state.held > 0.9) test.largest_mass = std::max(test.largest_mass, state.payload.mean[0]);
  }
  test.seconds += end - begin;
}

}  // namespace rme::examples
