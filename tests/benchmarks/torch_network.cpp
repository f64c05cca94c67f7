#include "benchmarks/torch_network.hpp"

#include <ATen/Parallel.h>
#include <torch/script.h>

namespace rme::benchmarks {

struct TorchNetwork::State {
  c10::InferenceMode inference;
  torch::jit::Module module;
  torch::Tensor input = torch::empty({1, 20, 6});
};

TorchNetwork::TorchNetwork(const std::string& path) {
  at::set_num_threads(1);
  state_ = std::make_unique<State>();
  state_->module = torch::jit::load(path);
  for (int k = 0; k < 200; ++k) (void)forward(Network::Window::Zero());  // its optimiser watches the first calls
}
TorchNetwork::~TorchNetwork() = default;

TorchNetwork::Network::Output TorchNetwork::forward(const Network::Window& window) {
  using Rows = Eigen::Matrix<float, 20, 6, Eigen::RowMajor>;
  Eigen::Map<Rows>(state_->input.data_ptr<float>()) = window;
  const torch::Tensor said = state_->module.forward({state_->input}).toTensor();
  return Eigen::Map<const Network::Output>(said.data_ptr<float>());
}

}  // namespace rme::benchmarks
