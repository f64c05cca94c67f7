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
template <int Fewest, int Most>
class AnyCompensationRamp : public detail::AnyPart<CompensationRamp, Fewest, Most> {
 public:
  /// @param torque_rate  [N m/s], one number per joint
  /// @throws std::invalid_argument naming the field out of range
  template <typename Rates>
  AnyCompensationRamp(int joints, double period, const Eigen::MatrixBase<Rates>& torque_rate)
      : detail::AnyPart<CompensationRamp, Fewest, Most>("CompensationRamp", joints, [&](auto count) {
          return CompensationRamp<double, decltype(count)::value>(period, {torque_rate});
        }) {}
  /// @param target  [N m], joints()
  template <typename Target>
  Status update(const Eigen::MatrixBase<Target>& target) noexcept {
    return std::visit([&](auto& ramp) { return ramp.update(target); }, this->any_);
  }
  /// @return the torque's first number; the others follow it
  const double* torque() const noexcept {
    return std::visit([](const auto& ramp) { return ramp.torque().data(); }, this->any_);
  }
};

/// MomentumObserver (sensing/momentum_observer.hpp).
template <int Fewest, int Most>
class AnyMomentumObserver : public detail::AnyPart<MomentumObserver, Fewest, Most> {
 public:
  /// @param gain  K [rad/s], one number per joint
  /// @throws std::invalid_argument naming the field out of range
  template <typename Gains>
  AnyMomentumObserver(int joints, double dt, const Eigen::MatrixBase<Gains>& gain)
      : detail::AnyPart<MomentumObserver, Fewest, Most>("MomentumObserver", joints, [&](auto count) {
          return MomentumObserver<double, decltype(count)::value>(dt, {gain});
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
  /// @return the first number of tau_ext; the others follow it
  const double* tau_ext() const noexcept {
    return std::visit([](const auto& observer) { return observer.tau_ext().data(); }, this->any_);
  }
};

}  // namespace rme::python
