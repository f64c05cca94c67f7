#include <memory>
#include <rme/rme.hpp>

#include "headers/float_core/float_core.hpp"
#include "network/golden.hpp"

namespace float_core {
namespace {

bool network_is_that_of_pytorch() {
  // The first of tests/data/network/golden_random.json.
  constexpr float kExpected[3][4] = {{-0.0939913F, -0.3688846F, 0.3590341F, -0.2450129F},
                                     {-0.3354283F, -0.6714211F, 0.6026367F, -0.1064261F},
                                     {-0.0041642F, -0.2385577F, 0.2878608F, -0.0835486F}};
  const auto weights = golden::random_weights<float>();
  const auto network = std::make_unique<rme::MismatchNetwork<float>>(*weights);
  const std::vector<double> mean(weights->normalization_mean.begin(), weights->normalization_mean.end());
  const std::vector<double> std(weights->normalization_std.begin(), weights->normalization_std.end());
  const auto windows = golden::random_windows(mean, std, 3);
  for (std::size_t k = 0; k < 3; ++k) {
    rme::MismatchNetwork<float>::Output out;
    if (network->forward(windows[k].cast<float>(), out) != Status::Ok) return false;
    if (!near(out, Eigen::Map<const Eigen::Vector4f>(kExpected[k]), 2e-5)) return false;
  }
  return true;
}

bool self_attention_takes_the_mean_of_equal_samples() {
  rme::SelfAttention<float, 4, 8, 2> attention;
  Random random(11);
  attention.in_proj.weight = gaussian<Eigen::Matrix<float, 24, 8>>(random);
  attention.out_proj.weight.setIdentity();
  const Eigen::Matrix<float, 8, 1> x = gaussian<Eigen::Matrix<float, 8, 1>>(random);
  Eigen::Matrix<float, 8, 4> in, out;
  in.colwise() = x;  // of the same sample four times the mean is its value
  attention.forward(in, out);
  const Eigen::Matrix<float, 8, 1> value = attention.in_proj.weight.bottomRows<8>() * x;
  return near(out.col(0), value, 1e-5 * value.norm()) && near(out.col(3), value, 1e-5 * value.norm());
}

}  // namespace

const std::vector<Case> kNetwork = {
    {"MismatchNetwork: as in PyTorch", network_is_that_of_pytorch},
    {"SelfAttention: the mean of equal samples", self_attention_takes_the_mean_of_equal_samples},
};

}  // namespace float_core
