#include "trial.hpp"

#include <stdexcept>

namespace rme::examples {

auto Trial::command() -> const Vector& {
  const auto& [position, rotation, jacobian] = arm.kinematics();
  Status status = estimator.update({arm.tau_ext(), jacobian, rotation, arm.dq()});
  if (status != Status::Ok) throw std::runtime_error(std::string("Estimator: ") + to_string(status));
  const Vector compensation = compensate_ ? estimator.compensation(jacobian, rotation) : Vector::Zero().eval();
  const Vector& torque = host.update(arm, compensation);
  status = host.status();
  if (status != Status::Ok && status != Status::Infeasible)
    throw std::runtime_error(std::string("Host: ") + to_string(status));
  return torque;
}

}  // namespace rme::examples
