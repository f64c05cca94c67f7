#include <precompiled/rme.hpp>

namespace rme {

template class Cholesky<double, 4>;
template class Cholesky<double, 6>;
template PayloadRegressor<double, 7> payload_regressor<double, 7>(const Jacobian<double, 7>&, const Matrix3<double>&,
                                                                  const Vector3<double>&) noexcept;
template struct InertialParameters<double>;
template class MomentumObserver<double, 7>;
template class Estimator<double, 7>;

}  // namespace rme
