#pragma once
/// Settings of the estimator, for what it cannot find out by itself.
#include <cmath>
#include <cstdint>
#include <optional>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/types.hpp>
#include <rme/sensing/torque_sign.hpp>
#include <rme/tracking/arm_prior.hpp>

namespace rme {

/// Settings of Estimator; the defaults suit a Panda. docs/tuning.md says how to find each.
template <typename Scalar, int Dofs>
struct EstimatorConfig {
  Vector3<Scalar> gravity = standard_gravity<Scalar>();  ///< g [m/s^2], world axes
  TorqueSign torque_sign = TorqueSign::External;         ///< of the tau_ext that the arm reports
  /// The heaviest payload that the arm is made for [kg], above 0 and at most 10,000. No larger mass is estimated, and
  /// the defaults for noise, offsets, friction, pushes and payloads scale with it.
  Scalar rated_payload = Scalar(3);
  /// Bandwidth of the first-order filter through which tau_ext comes [rad/s]: the gain K of the arm's momentum
  /// observer, 1 to 100,000; 0 if the torque is unfiltered. The filter is assumed to run at 1 kHz.
  double observer_bandwidth = 50;
  /// How often contact().contact may become true while nothing touches the arm and nothing is put into the hand [1/h],
  /// 0.001 to 1,000: once in ten hours. Its threshold follows from this and from what the arm has shown.
  double contact_false_alarms = 0.1;
  /// Kind of torque sensing, if it is known. Otherwise the estimator finds it out, for which the arm has to move.
  std::optional<Sensing> sensing = std::nullopt;
  /// Sizes of the joints' noise, offset, residual and friction, if they are known better than in
  /// ArmPrior::of(rated_payload); each number > 0.
  std::optional<ArmPrior<Scalar, Dofs>> arm = std::nullopt;
  /// What is likely to be picked up, if that is known better than in PayloadPrior::of(rated_payload); mass_mean is from
  /// 0 to rated_payload, standard deviations are > 0.
  std::optional<PayloadPrior<Scalar>> payload = std::nullopt;

  /// Checks all settings.
  /// @param dt  nominal control period [s], above 0 and at most 0.1
  /// @throws std::invalid_argument naming the field out of range
  void validate(double dt) const;
};

template <typename Scalar, int Dofs>
void EstimatorConfig<Scalar, Dofs>::validate(double dt) const {
  detail::require_positive(dt, "Estimator::dt", "> 0 s");
  detail::require(dt <= 0.1, "Estimator::dt", "at most 0.1 s", dt);
  detail::require(plausible(gravity) && gravity.norm() > 0, "EstimatorConfig::gravity", "finite and not zero",
                  gravity.norm());
  detail::require(torque_sign == TorqueSign::External || torque_sign == TorqueSign::Reaction,
                  "EstimatorConfig::torque_sign", "1 or -1", static_cast<int>(torque_sign));
  detail::require(rated_payload > 0 && rated_payload <= Scalar(1e4), "EstimatorConfig::rated_payload",
                  "above 0 and at most 10,000 kg", rated_payload);
  detail::require(observer_bandwidth == 0 || (observer_bandwidth >= 1 && observer_bandwidth <= 1e5),
                  "EstimatorConfig::observer_bandwidth", "0 or 1 to 100,000 rad/s", observer_bandwidth);
  detail::require(contact_false_alarms >= 1e-3 && contact_false_alarms <= 1e3, "EstimatorConfig::contact_false_alarms",
                  "0.001 to 1,000 per hour", contact_false_alarms);
  const auto positive = [](const auto& v, const char* field, const char* expected) {
    for (int i = 0; i < v.size(); ++i)
      detail::require(v[i] > 0 && v[i] <= Scalar(kLargestPlausible), field, expected, v[i]);
  };
  if (arm) {
    positive(arm->noise, "ArmPrior::noise", "> 0 N m");
    positive(arm->offset, "ArmPrior::offset", "> 0 N m");
    positive(arm->residual, "ArmPrior::residual", "> 0");
    positive(arm->coulomb, "ArmPrior::coulomb", "> 0 N m");
    positive(arm->viscous, "ArmPrior::viscous", "> 0 N m s/rad");
    detail::require(arm->friction_std > 0 && arm->friction_std <= Scalar(10), "ArmPrior::friction_std",
                    "above 0 and at most 10", arm->friction_std);
  }
  if (payload) {
    detail::require(payload->mass_mean >= 0 && payload->mass_mean <= rated_payload, "PayloadPrior::mass_mean",
                    "0 to rated_payload [kg]", payload->mass_mean);
    detail::require_positive(payload->mass_std, "PayloadPrior::mass_std", "> 0 kg");
    detail::require(plausible(payload->com_mean), "PayloadPrior::com_mean", "finite [m]", payload->com_mean.norm());
    positive(payload->com_std, "PayloadPrior::com_std", "> 0 m");
  }
}

}  // namespace rme
