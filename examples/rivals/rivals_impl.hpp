#pragma once
/// Implementation of rivals.hpp, for rivals_dofs.cpp.in, which compiles it for each number of joints.
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/published/published_pipeline.hpp>

#include "rivals/observer_matched.hpp"
#include "rivals/rivals.hpp"
#ifdef RME_HAS_KDL
#include "rivals/kdl_wrench.hpp"
#endif

namespace rme::examples {

namespace detail {

constexpr double kMemory = 5;  // of what forgets [s]
constexpr double kSilent = std::numeric_limits<double>::quiet_NaN();

inline Rival recursive(const LogBlocks& log, const Tare& tare, double rated) {
  const double mass = 1 / rated, moment = 1 / (0.2 * rated);  // a lever of 0.2 m
  RecursiveLeastSquares fit(Eigen::Vector4d(mass, moment, moment, moment).cwiseAbs2(), kMemory);
  const Eigen::MatrixXd torque = log.tau - tare.torque(log);
  Rival out{"recursive least squares", {}};
  for (Eigen::Index i = 0; i < log.blocks(); ++i) {
    Eigen::MatrixXd H(log.joints(), 4);
    for (Eigen::Index j = 0; j < log.joints(); ++j) H.row(j) = log.payload[static_cast<std::size_t>(j)].row(i);
    fit.age(log.duration[i]);
    fit.add(H, torque.row(i).transpose(), log.duration[i] * tare.weight);
    out.masses.push_back({log.end[i], fit.solution()[0], kSilent});
  }
  return out;
}

/// Calls `function(sample, known, period)` for each sample, with the torque's sign as TorqueSign::External has it, and
/// with the part of it that is known from the log of the empty hand [N m].
template <int Dofs, typename Function>
void each_sample(const Log<Dofs>& log, const Samples<Dofs>& samples, const LogBlocks& blocks, const Tare& tare,
                 const Function& function) {
  const Eigen::MatrixXd known = tare.torque(blocks);
  Eigen::Index block = 0;
  for (std::size_t k = 0; k < samples.sample.size(); ++k) {
    Proprioception<double, Dofs> sample = samples.sample[k];
    sample.tau_ext *= static_cast<double>(samples.sign);
    while (block + 1 < blocks.blocks() && blocks.end[block] < log.t[samples.row[k]]) ++block;
    function(k, sample, JointVector<double, Dofs>(known.row(block)),
             sample.period > 0 ? sample.period : samples.timing.period);
  }
}

template <int Dofs>
Rival observer_matched(const RivalInput<Dofs>& input, const LogBlocks& blocks, const Samples<Dofs>* empty,
                       const LogBlocks* empty_blocks, const Tare& tare) {
  const auto& config = input.settings.config;
  const auto fresh = [&](double memory) {
    return ObserverMatchedLeastSquares<Dofs>(config.gravity, config.rated_payload, input.samples.bandwidth, memory);
  };
  double virtual_object = 0;  // its mass
  if (empty) {
    auto fit = fresh(0);
    each_sample(*input.empty, *empty, *empty_blocks, tare,
                [&](std::size_t, const auto& sample, const auto& known, double period) {
                  fit.update(sample, known, period, tare.weight);
                });
    virtual_object = fit.solution()[0];
  }
  constexpr double kEvery = 0.02;  // [s]
  Rival out{"observer-matched", {}};
  auto fit = fresh(kMemory);
  double last = -kEvery;
  each_sample(input.log, input.samples, blocks, tare,
              [&](std::size_t k, const auto& sample, const auto& known, double period) {
                fit.update(sample, known, period, tare.weight);
                const double t = input.log.t[input.samples.row[k]];
                if (!out.masses.empty() && t - last < kEvery) return;
                last = t;
                out.masses.push_back({t, fit.solution()[0] - virtual_object, kSilent});
              });
  return out;
}

template <int Dofs>
Rival published(const RivalInput<Dofs>& input, const LogBlocks& blocks, const Tare& tare) {
  const double period = input.samples.timing.period;
  PublishedPipelineConfig<double> config;
  config.gravity = input.settings.config.gravity;
  config.damping = input.network->damping;
  config.collection = std::max(config.collection, 20.5 * period);  // 20 samples are what the network sees
  PublishedPipeline<double, Dofs> pipeline(period, *input.network->network, config);
  Rival out{"published pipeline", {}};
  each_sample(input.log, input.samples, blocks, tare, [&](std::size_t k, auto sample, const auto& known, double) {
    sample.tau_ext -= known;
    if (pipeline.update(sample) != Status::Ok) return;
    const auto& payload = pipeline.state().posterior;
    const bool none = pipeline.state().estimates == 0;
    out.masses.push_back({input.log.t[input.samples.row[k]], none ? 0 : payload.mean[0],
                          none ? kSilent : payload.standard_deviation()[0]});
  });
  return out;
}

#ifdef RME_HAS_KDL
template <int Dofs>
Rival kdl_wrench(const RivalInput<Dofs>& input, const LogBlocks& blocks, const Tare& tare) {
  constexpr double kGain = 50;  // as that of the other observers [1/s]
  // Of 1e-5, 0.03, 0.1, 0.2, 0.3 and 0.5, the best value for KDL on the recordings of docs/real_arms.md. With 1e-5, its
  // default, the error is tens of kilograms: near singular poses it divides friction by almost zero.
  constexpr double kSingular = 0.1;
  const RecordedArm<Dofs>& arm = input.settings.arm;
  const double sign = static_cast<double>(input.settings.config.torque_sign);
  KdlTipMass<Dofs> tip(arm.model, arm.rotor_inertia, input.samples.timing.period, kGain, kSingular);
  Rival out{"KDL's wrench", {}};
  double sum = 0, weight = 0;
  each_sample(
      input.log, input.samples, blocks, tare, [&](std::size_t k, const auto& sample, const auto& known, double period) {
        const std::size_t row = input.samples.row[k];
        const JointVector<double, Dofs> tau =
            sign * arm.gains.cwiseProduct(input.log.tau[row]) + known - load_friction(arm, input.log.q[row], sample.dq);
        const double keep = std::exp(-period / kMemory);
        sum = keep * sum + period * tip.update(input.log.q[row], sample.dq, tau);
        weight = keep * weight + period;
        out.masses.push_back({input.log.t[row], sum / weight, kSilent});
      });
  return out;
}
#endif

}  // namespace detail

template <int Dofs>
std::vector<Rival> run_rivals(const RivalInput<Dofs>& input) {
  const ArmSettings<Dofs>& settings = input.settings;
  const LogBlocks blocks = blocks_of(input.log, input.samples, settings.arm);
  Tare tare = Tare::none(Dofs);
  Samples<Dofs> empty;
  LogBlocks empty_blocks;
  if (input.empty) {
    if (input.empty->tau_ext.empty() != input.log.tau_ext.empty())
      throw LogError(input.empty->name + ": has other columns than " + input.log.name);
    empty = samples_of(*input.empty, settings.arm, settings.config);
    empty_blocks = blocks_of(*input.empty, empty, settings.arm);
    tare = Tare::of(empty_blocks);
  }
  std::vector<Rival> out;
  out.push_back(detail::recursive(blocks, tare, settings.config.rated_payload));
  out.push_back(detail::observer_matched(input, blocks, input.empty ? &empty : nullptr, &empty_blocks, tare));
  if (input.network) out.push_back(detail::published(input, blocks, tare));
#ifdef RME_HAS_KDL
  if (input.log.tau_ext.empty() && !input.simulated) out.push_back(detail::kdl_wrench(input, blocks, tare));
#endif
  out.push_back(
      {"batch least squares", {{input.log.t.back(), batch_least_squares(blocks, tare.weight)[0], detail::kSilent}}});
  return out;
}

}  // namespace rme::examples
