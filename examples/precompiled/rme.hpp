#pragma once
// Precompiled for the examples, the tests and the benchmarks: what most of them include, and what most of them instantiate,
// which the files beside this one do once for all. A program that does not see this file compiles just the same.
#include <Eigen/Dense>
#include <random>
#include <rme/control/barriers.hpp>
#include <rme/control/cpic.hpp>
#include <rme/control/passive_controller.hpp>
#include <rme/estimator.hpp>
#include <rme/host/payload_compensation.hpp>
#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/mean_field.hpp>
#include <rme/inference/payload_statistics.hpp>
#include <rme/inference/stochastic_vi.hpp>
#include <rme/network/mismatch_network.hpp>
#include <rme/published/published_pipeline.hpp>
#include <rme/sensing/mismatch_detector.hpp>
#include <rme/sensing/momentum_observer.hpp>
#include <rme/sensing/pseudo_wrench.hpp>

namespace rme {

extern template class Cholesky<double, 4>;
extern template class Cholesky<double, 6>;
extern template PayloadRegressor<double, 7> payload_regressor<double, 7>(const Jacobian<double, 7>&,
                                                                         const Matrix3<double>&,
                                                                         const Vector3<double>&) noexcept;
extern template Status pseudo_wrench(const Eigen::MatrixBase<Jacobian<double, 7>>&,
                                     const Eigen::MatrixBase<JointVector<double, 7>>&, double,
                                     Wrench<double>&) noexcept;
extern template class MismatchDetector<7>;
extern template class PayloadStatistics<double, 7>;
extern template Status exact_posterior(const PayloadLikelihood<double>&, const PayloadGaussian<double>&,
                                       ExactPosterior<double>&) noexcept;
extern template Status infer_payload(const PayloadLikelihood<double>&, const PayloadGaussian<double>&,
                                     InferenceResult<double>&, const VariationalInferenceConfig&,
                                     const Vector4<double>*) noexcept;
extern template Status infer_payload(const PayloadLikelihood<double>&, const PayloadGaussian<double>&,
                                     InferenceResult<double>&, const MeanFieldConfig&) noexcept;
extern template Status infer_payload(const PayloadLikelihood<double>&, const PayloadGaussian<double>&,
                                     InferenceResult<double>&, const StochasticViConfig&, std::mt19937_64&) noexcept;
extern template class MismatchNetwork<double>;
extern template class MismatchNetwork<float>;
extern template struct InertialParameters<double>;
extern template class CompensationRamp<double, 7>;
extern template class MomentumObserver<double, 7>;
extern template class Estimator<double, 7>;
extern template class PayloadCompensation<double, 7>;
extern template class PublishedPipeline<double, 7>;
extern template class PassiveController<double>;
extern template class JointLimits<double, 7>;
extern template class Cpic<double, 7, 8>;
extern template class Cpic<double, 7>;

}  // namespace rme
