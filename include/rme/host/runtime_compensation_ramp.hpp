#pragma once
/// The compensation's ramp for hosts that learn the number of joints at run time.
#include <rme/core/any_dofs.hpp>
#include <rme/core/compensation.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <variant>

namespace rme {

/// A CompensationRamp (core/compensation.hpp) for vectors of dynamic size, with the same results to the last bit. Real
/// time: no call but the constructors allocates or throws.
template <typename Scalar, int Fewest = 1, int Most = 8>
class RuntimeCompensationRamp {
 public:
  using Vector = JointVector<Scalar, Eigen::Dynamic>;  ///< of joint torques

  /// @param joints       of the arm, Fewest to Most
  /// @param period       nominal control period [s], > 0
  /// @param torque_rate  how fast the torque of each joint may change [N m/s], > 0; joints numbers
  /// @throws std::invalid_argument naming the argument out of range
  RuntimeCompensationRamp(int joints, Scalar period, const Vector& torque_rate)
      : joints_(joints),
        any_(detail::make_any_dofs<CompensationRamp, Scalar, Fewest, Most>(
            "RuntimeCompensationRamp", joints, period, [&](auto dofs) {
              return CompensationRampConfig<Scalar, dofs>{
                  detail::per_joint<dofs>(torque_rate, "CompensationRampConfig::torque_rate")};
            })) {}
  /// The same, with the default rate.
  /// @param joints  of the arm, Fewest to Most
  /// @param period  nominal control period [s], > 0
  RuntimeCompensationRamp(int joints, Scalar period)
      : joints_(joints),
        any_(detail::make_any_dofs<CompensationRamp, Scalar, Fewest, Most>(
            "RuntimeCompensationRamp", joints, period,
            [](auto dofs) { return CompensationRampConfig<Scalar, dofs>(); })) {}

  /// The number of joints, as constructed.
  int joints() const noexcept { return joints_; }
  /// CompensationRamp::update().
  /// @param target  [N m], joints() numbers
  /// @return Ok; WrongSize or NonFiniteInput: the torque stays what it was
  template <typename Torque>
  Status update(const Eigen::MatrixBase<Torque>& target) noexcept {
    if (!detail::has_size(target, joints_, 1)) return Status::WrongSize;
    return std::visit(
        [&](auto& ramp) {
          const std::decay_t<decltype(ramp.torque())> fixed = target;
          return ramp.update(fixed);
        },
        any_);
  }
  /// The torque to command now [N m], joints() numbers; a view of this object's.
  Eigen::Map<const Vector> torque() const noexcept {
    return {std::visit([](const auto& ramp) { return ramp.torque().data(); }, any_), joints_};
  }
  /// CompensationRamp::reset().
  void reset() noexcept {
    std::visit([](auto& ramp) { ramp.reset(); }, any_);
  }

 private:
  int joints_;
  detail::AnyDofs<CompensationRamp, Scalar, Fewest, Most> any_;
};

}  // namespace rme
