#include "network/shipped_prior.hpp"

#include <run_network/network_file.hpp>

struct ShippedPrior::State {
  rme::examples::NetworkFile file = rme::examples::read_network_file(RME_PANDA_MODEL);
  rme::NetworkPrior<double> prior{*file.network, 0.001, file.config};
  bool asked = false;
  rme::PayloadGaussian<double> said;
};

ShippedPrior::ShippedPrior() : state_(std::make_shared<State>()) {}

rme::PayloadGaussian<double> ShippedPrior::operator()(const rme::SampleWindow<double, 7>& window,
                                                      std::size_t count) const noexcept {
  Eigen::Vector4d guess;
  state_->asked = state_->prior.guess(window, count, guess);
  return state_->said = state_->prior(window, count);
}

bool ShippedPrior::asked() const noexcept {
  return state_->asked;
}
const rme::PayloadGaussian<double>& ShippedPrior::said() const noexcept {
  return state_->said;
}
