#include <precompiled/rme.hpp>

namespace rme {

template class Cholesky<double, 4>;
template class Cholesky<double, 6>;
template PayloadRegressor<double, 7> payload_regressor<double, 7>(const Jacobian<double, 7>&, const Matrix3<double>&,
                                                                  const Vector3<double>&) noexcept;
template PayloadRegressor<double, 7> payload_regressor<double, 7>(const Jacobian<double, 7>&, const Matrix3<double>&,
                                                                  const Vector3<double>&, const FlangeMotion<double>&,
                                                                  double) noexcept;
template Status pseudo_wrench(const Eigen::MatrixBase<Jacobian<double, 7>>&,
                              const Eigen::MatrixBase<JointVector<double, 7>>&, double, Wrench<double>&) noexcept;
template class SampleWindow<double, 7>;
template class MismatchDetector<7>;
template struct SensorModel<double, 7>;
template class PayloadStatistics<double, 7>;
template Status exact_posterior(const PayloadLikelihood<double>&, const PayloadGaussian<double>&,
                                ExactPosterior<double>&) noexcept;
template Status infer(const PayloadLikelihood<double>&, const PayloadGaussian<double>&, InferenceResult<double>&,
                      const VariationalInferenceConfig&, const Vector4<double>*) noexcept;
template Status infer(const PayloadLikelihood<double>&, const PayloadGaussian<double>&, InferenceResult<double>&,
                      const MeanFieldConfig&) noexcept;
template class Estimator<double, 7>;
template class PassiveController<double>;
template class JointLimits<double, 7>;
template class Cpic<double, 7, 8>;
template class Cpic<double, 7>;

}  // namespace rme
