#pragma once
/// One run of an experiment: an arm under CPIC, tick after tick. The published pipeline and the tracker get its samples;
/// the compensation is that of one of them, or none.
#include <array>
#include <cpic_host/host.hpp>
#include <cstdint>
#include <io/network_file.hpp>
#include <rme/estimator.hpp>
#include <rme/published/published_pipeline.hpp>
#include <synthetic_arm/panda.hpp>

#include "paper/experiment/setup.hpp"

namespace rme::examples {

/// The estimate that the compensation is computed from.
enum class Method : std::uint8_t {
  None,         // no compensation
  Published,    // PublishedPipeline
  Tracker,      // Estimator with its default settings
  TrackerTold,  // Estimator whose setting `sensing` is that of the arm
};

constexpr std::array<Method, 3> kMethods = {Method::None, Method::Published, Method::Tracker};
constexpr const char* name_of(Method method) {
  constexpr const char* names[] = {"CPIC alone", "published pipeline", "tracker", "tracker told of the sensing"};
  return names[static_cast<std::size_t>(method)];
}

/// Default settings, but `sensing` is set to that of the arm.
EstimatorConfig<double, 7> told(const SyntheticArmConfig<7>& arm);

/// The network of examples/models/panda.json, in the published architecture.
/// @throws std::runtime_error if it cannot be read
const NetworkFile& shipped_network();

class Trial {
 public:
  using Vector = JointVector<double, 7>;
  using Published = PublishedPipeline<double, 7>;

  /// @param method      whose estimate is compensated
  /// @param collection  time for which the published pipeline collects samples after a detection [s]
  Trial(const SyntheticArmConfig<7>& arm_config, const HostConfig& host_config, const Vector& start, Method method,
        double collection = PublishedPipelineConfig<double>().collection);

  /// Updates the estimators, then the controller, with the arm's present state.
  /// @return the torque to command [N m]
  /// @throws std::runtime_error if the estimators or the controller refuse a sample: here that is a bug
  const Vector& command();
  /// command(), then moves the arm on by one millisecond. Afterwards `arm` is in its new state; `host` and the
  /// estimators are in the state of the tick before.
  void tick() { arm.step(command()); }

  Eigen::Vector3d position_error() const { return arm.kinematics().position - config_.target; }  // world axes [m]
  /// Angle between the flange's orientation and the target's [rad].
  double orientation_error() const {
    return config_.orientation.angularDistance(Eigen::Quaterniond(arm.kinematics().rotation));
  }
  /// Mass and centre of mass of all that is in the hand [kg, m, m, m].
  Eigen::Vector4d truth() const;
  /// A method's estimate of it; for the published pipeline, its last one.
  const PayloadGaussian<double>& belief(Method method) const {
    return method == Method::Published ? published.state().posterior : estimator.state().payload;
  }
  /// How often a method has found another payload than before, an empty hand included.
  std::uint64_t answers(Method method) const {
    return method == Method::Published ? published.state().estimates : found_;
  }

  SyntheticArm<7> arm;
  Host host;
  Estimator<double, 7> estimator;
  Published published;

 private:
  HostConfig config_;
  Method method_;
  int last_event_ = 0;
  std::uint64_t found_ = 0;  // events that were no pushes
};

}  // namespace rme::examples
