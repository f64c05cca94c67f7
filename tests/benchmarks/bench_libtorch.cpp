// bench_libtorch MODEL.pt MODEL.json: the same network in TorchScript and in rme, one thread, same windows, same run.
// MODEL.pt comes from tests/benchmarks/trace.py. Prints medians of 10,000 calls after 1,000 to warm up.
#include <ATen/Parallel.h>
#include <torch/script.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <rme/network/json.hpp>
#include <run_network/json_file.hpp>
#include <vector>

#include "network/golden.hpp"

namespace {

template <typename Call>
double median_us(const Call& call) {
  std::vector<double> times;
  for (int k = 0; k < 11000; ++k) {
    const auto start = std::chrono::steady_clock::now();
    call(static_cast<std::size_t>(k) % 100);
    const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
    if (k >= 1000) times.push_back(spent.count());
  }
  std::nth_element(times.begin(), times.begin() + 5000, times.end());
  return times[5000];
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s MODEL.pt MODEL.json\n", argv[0]);
    return 2;
  }
  using Network = rme::MismatchNetwork<float>;
  const auto network =
      std::make_unique<Network>(rme::model_from_json<float>(rme::examples::read_json_file(argv[2])).weights);
  at::set_num_threads(1);
  const c10::InferenceMode inference;
  torch::jit::Module traced = torch::jit::load(argv[1]);

  std::vector<Network::Window> windows;
  std::vector<torch::Tensor> tensors;
  for (const auto& window : golden::random_windows(std::vector<double>(6, 0), std::vector<double>(6, 4), 100)) {
    windows.push_back(window.cast<float>());
    const Eigen::Matrix<float, 20, 6, Eigen::RowMajor> rows = windows.back();
    tensors.push_back(torch::from_blob(const_cast<float*>(rows.data()), {1, 20, 6}).clone());
  }
  double largest = 0;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    Network::Output out = Network::Output::Zero();
    if (network->forward(windows[i], out) != rme::Status::Ok) return 1;
    const torch::Tensor said = traced.forward({tensors[i]}).toTensor();
    for (int k = 0; k < 4; ++k) {
      largest = std::max(largest, static_cast<double>(std::abs(out[k] - said[0][k].item<float>())));
    }
  }
  Network::Output out = Network::Output::Zero();
  const double ours = median_us([&](std::size_t i) { (void)network->forward(windows[i], out); });
  const double theirs = median_us([&](std::size_t i) { (void)traced.forward({tensors[i]}); });
  std::printf("largest difference %.1e; rme %.2f us, TorchScript %.1f us: %.1f times\n", largest, ours, theirs,
              theirs / ours);
  return 0;
}
