#include <precompiled/rme.hpp>

namespace rme {

template Status pseudo_wrench(const Eigen::MatrixBase<Jacobian<double, 7>>&,
                              const Eigen::MatrixBase<JointVector<double, 7>>&, double, Wrench<double>&) noexcept;
template class MismatchDetector<7>;
template class PayloadStatistics<double, 7>;
template Status exact_posterior(const PayloadLikelihood<double>&, const PayloadGaussian<double>&,
                                ExactPosterior<double>&) noexcept;
template Status infer_payload(const PayloadLikelihood<double>&, const PayloadGaussian<double>&,
                              InferenceResult<double>&, const VariationalInferenceConfig&,
                              const Vector4<double>*) noexcept;
template Status infer_payload(const PayloadLikelihood<double>&, const PayloadGaussian<double>&,
                              InferenceResult<double>&, const MeanFieldConfig&) noexcept;

}  // namespace rme
