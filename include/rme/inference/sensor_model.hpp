#pragma once
/// Offset, friction and noise of the torque in a window of samples.
#include <algorithm>
#include <array>
#include <cmath>
#include <rme/core/require.hpp>
#include <rme/core/sum_of_logs.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/payload_statistics.hpp>

namespace rme {

/// Model of a joint's tau_ext (docs/theory.md (T37)):
///
///     tau_ext = payload + offset + stiction - coulomb * direction - viscous * dq + noise
template <typename Scalar, int Dofs>
struct SensorModel {
  using Vector = JointVector<Scalar, Dofs>;  ///< one number per joint

  /// Standard deviation of the error that varies within a window, with the correlation time below [N m], > 0. White
  /// noise with standard deviation s in samples of period dt counts as s sqrt(dt / (2 noise_correlation_time)).
  Vector noise;
  Scalar noise_correlation_time = Scalar(0.02);  ///< [s], > 0; must be the same in models that are compared
  Vector offset;    ///< standard deviation of the part that stays for minutes: sensor offset, model error [N m], > 0
  Vector stiction;  ///< standard deviation of the part that changes with every event: friction at rest [N m], > 0
  Vector coulomb_mean;  ///< Coulomb friction that tau_ext contains [N m], >= 0; 0 with link-side sensing
  Vector coulomb_std;   ///< its standard deviation [N m], > 0
  Vector viscous_mean;  ///< viscous friction that tau_ext contains [N m s/rad], >= 0
  Vector viscous_std;   ///< its standard deviation [N m s/rad], > 0

  /// Torque sensed behind the gears, as on most lightweight arms: it contains little friction.
  static SensorModel link_side();
  /// Torque from motor currents, or sensed before the gears: it contains the friction of the joints.
  static SensorModel joint_friction();

  /// @throws std::invalid_argument naming the field out of range
  void validate() const;

  /// Precision of one sample, per joint [1/(N m)^2]. If the error has the correlation time T, each of the samples dt
  /// apart counts as dt / (2 T) of an independent one, and at most as one.
  Vector precision(Scalar dt) const noexcept { return independence(dt) * noise.cwiseAbs2().cwiseInverse(); }
  /// As how many independent samples `count` samples of period dt count, per joint.
  Scalar independent_samples(Scalar dt, int count) const noexcept {
    return independence(dt) * static_cast<Scalar>(count);
  }
  /// Log of the noise's normaliser over `count` samples [nats], up to a term that all sensor models share. Add it to
  /// the evidence to compare sensor models.
  Scalar log_factor(Scalar dt, int count) const noexcept {
    return -independent_samples(dt, count) * sum_of_logs(noise);
  }

  /// Prior of the nuisances where no baseline is known.
  NuisanceGaussian<Scalar, Dofs> prior() const noexcept;

  /// Prior of the nuisances for the next event, given their posterior over a quiet window with an empty hand. The
  /// sensor's offset stays the same over the event, and stiction does not, but the quiet window shows only their sum:
  /// the share rho = offset^2 / (offset^2 + stiction^2) of its mean is kept (docs/theory.md (T40)), and the variance is
  /// increased accordingly. Friction coefficients stay.
  NuisanceGaussian<Scalar, Dofs> after_event(const NuisanceGaussian<Scalar, Dofs>& baseline) const noexcept;

 private:
  Scalar independence(Scalar dt) const noexcept { return std::min(Scalar(1), dt / (2 * noise_correlation_time)); }
  /// One value for the joints from the base to the elbow, which have larger torques and errors, and one for the wrist.
  static Vector graded(double proximal, double distal) noexcept {
    Vector v = Vector::Constant(static_cast<Scalar>(distal));
    v.template head<(Dofs + 1) / 2>().setConstant(static_cast<Scalar>(proximal));
    return v;
  }
};

template <typename Scalar, int Dofs>
SensorModel<Scalar, Dofs> SensorModel<Scalar, Dofs>::link_side() {
  SensorModel model;
  // White noise of 0.05 and 0.03 N m at 1 kHz.
  model.noise = graded(0.0079, 0.0047);
  model.offset = graded(0.1, 0.05);
  model.stiction = graded(0.001, 0.0005);
  model.coulomb_mean = model.viscous_mean = Vector::Zero();
  model.coulomb_std = graded(5e-4, 5e-4);
  model.viscous_std = graded(1e-3, 1e-3);
  return model;
}

template <typename Scalar, int Dofs>
SensorModel<Scalar, Dofs> SensorModel<Scalar, Dofs>::joint_friction() {
  SensorModel model;
  model.noise = graded(0.08, 0.05);  // mostly errors of the friction model
  model.offset = graded(0.1, 0.05);
  model.stiction = graded(0.1, 0.05);
  model.coulomb_mean = graded(0.2, 0.075);
  model.coulomb_std = graded(0.06, 0.03);
  model.viscous_mean = graded(0.08, 0.03);
  model.viscous_std = graded(0.05, 0.02);
  return model;
}

template <typename Scalar, int Dofs>
void SensorModel<Scalar, Dofs>::validate() const {
  const auto positive = [](const Vector& v, const char* field) {
    // The square must neither underflow nor overflow, even in float.
    for (int j = 0; j < Dofs; ++j)
      detail::require(v[j] >= Scalar(1e-12) && v[j] < Scalar(1e6), field, "> 0 in every joint", v[j]);
  };
  positive(noise, "SensorModel::noise");
  positive(offset, "SensorModel::offset");
  positive(stiction, "SensorModel::stiction");
  positive(coulomb_std, "SensorModel::coulomb_std");
  positive(viscous_std, "SensorModel::viscous_std");
  for (int j = 0; j < Dofs; ++j) {
    detail::require(coulomb_mean[j] >= 0 && coulomb_mean[j] < Scalar(1e6), "SensorModel::coulomb_mean", ">= 0 N m",
                    coulomb_mean[j]);
    detail::require(viscous_mean[j] >= 0 && viscous_mean[j] < Scalar(1e6), "SensorModel::viscous_mean",
                    ">= 0 N m s/rad", viscous_mean[j]);
  }
  detail::require(noise_correlation_time > 0 && noise_correlation_time < Scalar(1e6),
                  "SensorModel::noise_correlation_time", "> 0 s", noise_correlation_time);
}

template <typename Scalar, int Dofs>
NuisanceGaussian<Scalar, Dofs> SensorModel<Scalar, Dofs>::prior() const noexcept {
  NuisanceGaussian<Scalar, Dofs> nuisance;
  for (int j = 0; j < Dofs; ++j) {
    const auto s = static_cast<std::size_t>(j);
    nuisance.mean[s] << Scalar(0), coulomb_mean[j], viscous_mean[j];
    const NuisanceVector<Scalar> variance(offset[j] * offset[j] + stiction[j] * stiction[j],
                                          coulomb_std[j] * coulomb_std[j], viscous_std[j] * viscous_std[j]);
    nuisance.covariance[s] = variance.asDiagonal();
  }
  return nuisance;
}

template <typename Scalar, int Dofs>
NuisanceGaussian<Scalar, Dofs> SensorModel<Scalar, Dofs>::after_event(
    const NuisanceGaussian<Scalar, Dofs>& baseline) const noexcept {
  NuisanceGaussian<Scalar, Dofs> nuisance = baseline;
  for (int j = 0; j < Dofs; ++j) {
    const auto s = static_cast<std::size_t>(j);
    const Scalar lasting = offset[j] * offset[j], passing = stiction[j] * stiction[j];
    const Scalar kept = lasting / (lasting + passing);
    nuisance.mean[s][0] *= kept;
    nuisance.covariance[s].row(0) *= kept;
    nuisance.covariance[s].col(0) *= kept;
    nuisance.covariance[s](0, 0) += kept * passing + passing;  // kept * passing = var(offset | sum)
  }
  return nuisance;
}

}  // namespace rme
