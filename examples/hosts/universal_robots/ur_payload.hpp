#pragma once
/// For a torque controller on UR's client library (PolyScope 5.23, 10.11 or newer): the compensation, from RTDE.
#include <ur_client_library/rtde/data_package.h>
#include <rme/host/payload_compensation.hpp>
#include <rme/host/pinocchio.hpp>
#include <string>
#include <vector>

namespace hosts {

/// What UrPayload reads: to add to the RTDE output recipe. UrHandOver reads the last three.
inline std::vector<std::string> ur_recipe() {
  return {"actual_q", "actual_qd", "actual_current_as_torque", "payload", "payload_cog", "payload_inertia"};
}

/// Reads RTDE, and says what to add to your torque.
class UrPayload {
 public:
  using Vector = rme::JointVector<double, 6>;

  /// @param robot         from ur_description, with the tool that the robot was told of by its payload as well
  /// @param joints        names of the six joints, from the base
  /// @param end_effector  tool0: its axes are those of the payload that a UR is told of
  /// @param period        of the loop [s]: 0.002
  /// @param config        settings
  UrPayload(const pinocchio::Model& robot, const std::vector<std::string>& joints, const std::string& end_effector,
            double period, const rme::PayloadCompensationConfig<double, 6>& config)
      : sensing_(rme::pinocchio_arm(robot, joints), end_effector, period, config.estimator), payload_(period, config) {}

  /// Once for each package. Afterwards, add compensation().torque() to your torque, which contains no gravity: the robot
  /// adds that of its own model and payload, and takes it off the torque that it reports.
  /// @param data     with the fields of ur_recipe()
  /// @param period   measured [s]
  /// @param carried  torque with which the robot already carries a payload of rme's: UrHandOver::carried() [N m]
  rme::Status update(const urcl::rtde_interface::DataPackage& data, double period,
                     const Vector& carried = Vector::Zero()) {
    urcl::vector6d_t q{}, dq{}, torque{};
    if (!data.getData("actual_q", q) || !data.getData("actual_qd", dq) ||
        !data.getData("actual_current_as_torque", torque))
      return rme::Status::NotReady;
    const Vector positions = Eigen::Map<const Vector>(q.data());
    if (!rme::plausible(positions)) return rme::Status::NonFiniteInput;
    const Vector tau = Eigen::Map<const Vector>(torque.data()) + sensing_.gravity(positions) + carried;
    const rme::Status status = sensing_.update(positions, Eigen::Map<const Vector>(dq.data()), tau, period, sample_);
    return status == rme::Status::Ok ? payload_.update(sample_) : status;
  }
  rme::PayloadCompensation<double, 6>& compensation() { return payload_; }
  const rme::Proprioception<double, 6>& sample() const { return sample_; }  ///< of the last good update()

 private:
  rme::PinocchioSensing<6> sensing_;
  rme::PayloadCompensation<double, 6> payload_;
  rme::Proprioception<double, 6> sample_;
};

}  // namespace hosts
