#include "trial.hpp"

#include <stdexcept>

namespace rme::examples {

namespace {

PublishedPipelineConfig<double> published_config(double collection) {
  PublishedPipelineConfig<double> config;
  config.collection = collection;
  config.damping = shipped_network().damping;
  return config;
}

void require_ok(const char* who, Status status) {
  if (status != Status::Ok) throw std::runtime_error(std::string(who) + ": " + to_string(status));
}

}  // namespace

EstimatorConfig<double, 7> told(const SyntheticArmConfig<7>& arm) {
  EstimatorConfig<double, 7> config;
  config.sensing = arm.friction.coulomb.isZero() ? Sensing::LinkSide : Sensing::JointFriction;
  return config;
}

const NetworkFile& shipped_network() {
  static const NetworkFile file = read_network_file(RME_EXAMPLE_WEIGHTS);
  return file;
}

Trial::Trial(const SyntheticArmConfig<7>& arm_config, const HostConfig& host_config, const Vector& start, Method method,
             double collection)
    : arm(panda(), arm_config, start),
      host(panda(), host_config),
      estimator(kPeriod, method == Method::TrackerTold ? told(arm_config) : EstimatorConfig<double, 7>()),
      published(kPeriod, *shipped_network().network, published_config(collection), arm_config.seed),
      config_(host_config),
      method_(method) {}

auto Trial::command() -> const Vector& {
  const auto& [position, rotation, jacobian] = arm.kinematics();
  const Proprioception<double, 7> sample{arm.tau_ext(), jacobian, rotation, arm.dq()};
  require_ok("Estimator", estimator.update(sample));
  require_ok("PublishedPipeline", published.update(sample));
  const Event& event = estimator.state().event;
  if (event.number != last_event_ && event.kind != EventKind::Pushed) ++found_;
  last_event_ = event.number;
  const Vector compensation = method_ == Method::None        ? Vector::Zero().eval()
                              : method_ == Method::Published ? published.compensation(jacobian, rotation)
                                                             : estimator.compensation(jacobian, rotation);
  const Vector& torque = host.update(arm, compensation);
  if (host.status() != Status::Infeasible) require_ok("Host", host.status());
  return torque;
}

Eigen::Vector4d Trial::truth() const {
  const RigidBody payload = arm.payload();
  Eigen::Vector4d truth;
  truth << payload.mass, payload.com;
  return truth;
}

}  // namespace rme::examples
