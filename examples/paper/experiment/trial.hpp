#pragma once
/// One run of an experiment: an arm under CPIC, tick after tick. The published pipeline and the tracker listen; one of
/// them, or nobody, carries the payload.
#include <array>
#include <cpic_host/host.hpp>
#include <cstdint>
#include <rme/estimator.hpp>
#include <rme/published/published_pipeline.hpp>
#include <run_network/network_file.hpp>
#include <synthetic_arm/panda.hpp>

#include "paper/experiment/setup.hpp"

namespace rme::examples {

/// Whose estimate reaches the controller.
enum class Method : std::uint8_t {
  None,
  Published,
  Tracker,      // Estimator with its default settings
  TrackerTold,  // the same, and somebody has told it whether the arm's torque sensing sees friction
};

constexpr std::array<Method, 3> kMethods = {Method::None, Method::Published, Method::Tracker};
constexpr const char* name_of(Method method) {
  constexpr const char* names[] = {"CPIC alone", "published pipeline", "tracker", "tracker told of the sensing"};
  return names[static_cast<std::size_t>(method)];
}

/// What the settings of an estimator that is told of the arm's sensing are.
EstimatorConfig<double, 7> told(const SyntheticArmConfig<7>& arm);

/// The network of examples/models/panda.json, in the published architecture.
/// @throws std::runtime_error if it cannot be read
const NetworkFile& shipped_network();

class Trial {
 public:
  using Vector = JointVector<double, 7>;
  using Published = PublishedPipeline<double, 7>;

  /// @param collection  of the published pipeline, after a detection [s]
  Trial(const SyntheticArmConfig<7>& arm_config, const HostConfig& host_config, const Vector& start, Method method,
        double collection = PublishedPipelineConfig<double>().collection);

  /// Estimators, then controller, at the present time.
  /// @return the torque to command [N m]
  /// @throws std::runtime_error if the estimators or the controller refuse a sample: here that is a bug
  const Vector& command();
  /// The same, then the arm's next millisecond. What the members say afterwards belongs to the new time but for the
  /// host's, which is of the tick before.
  void tick() { arm.step(command()); }

  Eigen::Vector3d position_error() const { return arm.kinematics().position - config_.target; }  // world axes [m]
  /// [rad]
  double orientation_error() const {
    return config_.orientation.angularDistance(Eigen::Quaterniond(arm.kinematics().rotation));
  }
  /// All that is in the hand.
  Eigen::Vector4d truth() const;
  /// What a method believes of it; of the published pipeline, its last estimate.
  const PayloadGaussian<double>& belief(Method method) const {
    return method == Method::Published ? published.state().posterior : estimator.state().payload;
  }
  /// How often a method has found another payload than before, be it an empty hand.
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
