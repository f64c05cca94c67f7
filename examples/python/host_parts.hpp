#pragma once
/// The compensation ramp and the momentum observer for a number of joints known at run time: those of fixed size, one of
/// which is in use. Results are the same to the last bit.
#include <rme/core/compensation.hpp>
#include <rme/core/require.hpp>
#include <rme/sensing/momentum_observer.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace rme::python {

namespace detail {

template <template <typename, int> class Part, int Fewest, typename More>
struct PartOfAny;
template <template <typename, int> class Part, int Fewest, int... More>
struct PartOfAny<Part, Fewest, std::integer_sequence<int, More...>> {
  using Type = std::variant<Part<double, Fewest + More>...>;
};

/// Part<double, joints>.
template <template <typename, int> class Part, int Fewest, int Most>
class AnyPart {
 public:
  /// @param name  of the part, for messages
  /// @param make  callable (std::integral_constant<int, Dofs>) -> Part<double, Dofs>
  template <typename Make>
  AnyPart(const char* name, int joints, const Make& make) : joints_(joints), any_(made<Fewest>(name, joints, make)) {}
  int joints() const noexcept { return joints_; }
  void reset() noexcept {
    std::visit([](auto& part) { part.reset(); }, any_);
  }

 protected:
  using Any = typename PartOfAny<Part, Fewest, std::make_integer_sequence<int, Most - Fewest + 1>>::Type;

  template <int Dofs, typename Make>
  static Any made(const char* name, int joints, const Make& make) {
    if (joints == Dofs) return Any(make(std::integral_constant<int, Dofs>()));
    if constexpr (Dofs < Most) {
      return made<Dofs + 1>(name, joints, make);
    } else {
      rme::detail::refuse(std::string(name) + "::joints: expected " + std::to_string(Fewest) + " to " +
                          std::to_string(Most) + ", got " + std::to_string(joints));
    }
  }

  int joints_;
  Any any_;
};

}  // namespace detail

/// CompensationRamp (core/compensation.hpp).
template <typename Scalar, int Fewest, int Most>
class RuntimeCompensationRamp : public detail::AnyPart<CompensationRamp, Fewest, Most> {
 public:
  using Vector = JointVector<Scalar, Eigen::Dynamic>;  ///< of joint torques

  /// @param torque_rate  [N m/s], joints numbers
  /// @throws std::invalid_argument naming the field out of range
  RuntimeCompensationRamp(int joints, Scalar period, const Vector& torque_rate)
      : detail::AnyPart<CompensationRamp, Fewest, Most>("RuntimeCompensationRamp", joints, [&](auto count) {
          return CompensationRamp<Scalar, decltype(count)::value>(period, {torque_rate});
        }) {}
  /// @param target  [N m], joints() numbers
  template <typename Target>
  Status update(const Eigen::MatrixBase<Target>& target) noexcept {
    return std::visit([&](auto& ramp) { return ramp.update(target); }, this->any_);
  }
  /// [N m], joints() numbers: a view.
  Eigen::Map<const Vector> torque() const noexcept {
    return {std::visit([](const auto& ramp) { return ramp.torque().data(); }, this->any_), this->joints_};
  }
};

/// MomentumObserver (sensing/momentum_observer.hpp).
template <typename Scalar, int Fewest, int Most>
class RuntimeMomentumObserver : public detail::AnyPart<MomentumObserver, Fewest, Most> {
 public:
  using Vector = JointVector<Scalar, Eigen::Dynamic>;  ///< one number per joint

  /// @param gain  K [rad/s], joints numbers
  /// @throws std::invalid_argument naming the field out of range
  RuntimeMomentumObserver(int joints, Scalar dt, const Vector& gain)
      : detail::AnyPart<MomentumObserver, Fewest, Most>("RuntimeMomentumObserver", joints, [&](auto count) {
          return MomentumObserver<Scalar, decltype(count)::value>(dt, {gain});
        }) {}
  /// The arguments are those of MomentumObserver::update(), of size joints().
  template <typename Joints, typename Square>
  Status update(const Eigen::MatrixBase<Joints>& tau, const Eigen::MatrixBase<Joints>& dq,
                const Eigen::MatrixBase<Square>& mass_matrix, const Eigen::MatrixBase<Joints>& coriolis_transpose,
                const Eigen::MatrixBase<Joints>& gravity, double period) noexcept {
    return std::visit(
        [&](auto& observer) { return observer.update(tau, dq, mass_matrix, coriolis_transpose, gravity, period); },
        this->any_);
  }
  /// [N m], joints() numbers: a view.
  Eigen::Map<const Vector> tau_ext() const noexcept {
    return {std::visit([](const auto& observer) { return observer.tau_ext().data(); }, this->any_), this->joints_};
  }
};

}  // namespace rme::python
