#include "inference/likelihoods.hpp"

namespace rme::testing {

PayloadLikelihood<float> in_float(const PayloadLikelihood<double>& l) {
  PayloadLikelihood<float> lf;
  lf.yy = float(l.yy), lf.ya = float(l.ya), lf.aa = float(l.aa);
  lf.yB = l.yB.cast<float>(), lf.aB = l.aB.cast<float>(), lf.BB = l.BB.cast<float>();
  return lf;
}

PayloadGaussian<float> in_float(const PayloadGaussian<double>& prior) {
  return {prior.mean.cast<float>(), prior.covariance.cast<float>()};
}

}  // namespace rme::testing

namespace rme {

template Status infer_payload(const PayloadLikelihood<float>&, const PayloadGaussian<float>&, InferenceResult<float>&,
                              const VariationalInferenceConfig&, const Vector4<float>*) noexcept;

}  // namespace rme
