#include "synthetic_arm/random_pose.hpp"

#include <rme/core/cholesky.hpp>
#include <rme/core/small_matrix.hpp>

namespace rme::examples {

bool is_mobile(const Jacobian<double, 7>& jacobian, double least) {
  // The eigenvalues of J J^T are the squares of the singular values. To find them would take longer.
  Matrix6<double> beyond = rme::detail::outer_square(jacobian);
  for (int i = 0; i < 6; ++i) beyond(i, i) -= least * least;
  return Cholesky<double, 6>(beyond).positive_definite();
}

}  // namespace rme::examples
