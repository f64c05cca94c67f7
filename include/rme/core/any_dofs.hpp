#pragma once
/// One object of a class template <Scalar, Dofs>, for a number of joints that is known at run time.
#include <cstddef>
#include <rme/core/require.hpp>
#include <rme/core/types.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace rme::detail {

template <template <typename, int> class Object, typename Scalar, int Fewest, typename Counts>
struct AnyDofsOf;
template <template <typename, int> class Object, typename Scalar, int Fewest, std::size_t... More>
struct AnyDofsOf<Object, Scalar, Fewest, std::index_sequence<More...>> {
  using Type = std::variant<Object<Scalar, Fewest + static_cast<int>(More)>...>;
};

/// An Object<Scalar, N> for one N from Fewest to Most. The classes whose names begin with Runtime hold one:
/// so they compute what the class with N joints computes, to the last bit.
template <template <typename, int> class Object, typename Scalar, int Fewest, int Most>
using AnyDofs = typename AnyDofsOf<Object, Scalar, Fewest,
                                   std::make_index_sequence<static_cast<std::size_t>(Most - Fewest + 1)>>::Type;

/// Constructs the object for `joints` joints in place.
/// @param name      of the class, for the message
/// @param period    first argument of each constructor
/// @param settings  callable (std::integral_constant<int, N>): the second argument of the constructor for N joints
/// @throws std::invalid_argument if `joints` is not from Fewest to Most
template <template <typename, int> class Object, typename Scalar, int Fewest, int Most, int Dofs = Fewest,
          typename Period, typename Settings>
AnyDofs<Object, Scalar, Fewest, Most> make_any_dofs(const char* name, int joints, Period period,
                                                    const Settings& settings) {
  using Any = AnyDofs<Object, Scalar, Fewest, Most>;
  if (joints == Dofs)
    return Any(std::in_place_type<Object<Scalar, Dofs>>, period, settings(std::integral_constant<int, Dofs>()));
  if constexpr (Dofs < Most) {
    return make_any_dofs<Object, Scalar, Fewest, Most, Dofs + 1>(name, joints, period, settings);
  } else {
    refuse(std::string(name) + "::joints: expected " + std::to_string(Fewest) + " to " + std::to_string(Most) +
           ", got " + std::to_string(joints));
  }
}

/// A vector of Dofs numbers from one of dynamic size.
/// @throws std::invalid_argument naming the field, if the size is another one
template <int Dofs, typename Scalar>
JointVector<Scalar, Dofs> per_joint(const JointVector<Scalar, Eigen::Dynamic>& from, const char* field) {
  if (from.size() != Dofs)
    refuse(std::string(field) + ": expected " + std::to_string(Dofs) + " numbers, one per joint, got " +
           std::to_string(from.size()));
  return from;
}

/// Whether x has so many rows and columns.
template <typename Derived>
bool has_size(const Eigen::MatrixBase<Derived>& x, int rows, int columns) noexcept {
  return x.rows() == rows && x.cols() == columns;
}

}  // namespace rme::detail
