// run_network WEIGHTS.json INPUTS.json: what does an exported network say? The check that an export is right.
//
// INPUTS.json is an array of windows, each 20 samples x 6 channels: raw (un-normalised) pseudo-wrenches, force [N] then
// moment [N m], oldest sample first, in the axes that the weights file states under input.frame.
// Prints an array with one array per window, (mass [kg], com_x, com_y, com_z [m]), 9 significant digits.
// Exit code: 0, or 2 for arguments it cannot use, or 3 for a file it cannot read or use; then standard output is empty.
#include <cstdio>
#include <memory>
#include <rme/network/json.hpp>
#include <string>
#include <vector>

#include "json_file.hpp"

namespace {

using Network = rme::MismatchNetwork<double>;

std::unique_ptr<Network> load_network(const std::string& path) {
  const nlohmann::json file = rme::examples::read_json_file(path);
  try {
    return std::make_unique<Network>(rme::model_from_json<double>(file).weights);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

std::vector<Network::Output> run(const Network& network, const std::string& path) {
  const nlohmann::json file = rme::examples::read_json_file(path);
  if (!file.is_array())
    throw std::runtime_error(path + ": expected an array of windows, got " + rme::detail::describe(file));
  std::vector<Network::Output> outputs(file.size());
  for (std::size_t i = 0; i < file.size(); ++i) {
    const std::string name = path + ": window [" + std::to_string(i) + "]";
    Eigen::Matrix<double, Network::Window::RowsAtCompileTime, Network::Window::ColsAtCompileTime, Eigen::RowMajor>
        window;
    double* numbers = window.data();
    rme::detail::read_numbers(file[i], name, std::array{int(window.rows()), int(window.cols())}, numbers);
    if (network.forward(window, outputs[i]) != rme::Status::Ok) {
      throw std::runtime_error(name + ": the output is not finite");
    }
  }
  return outputs;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s WEIGHTS.json INPUTS.json\n", argc > 0 ? argv[0] : "run_network");
    return 2;
  }
  std::vector<Network::Output> outputs;
  try {
    outputs = run(*load_network(argv[1]), argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "run_network: %s\n", error.what());
    return 3;
  }
  std::printf("[");
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    std::printf(i == 0 ? "\n  [" : ",\n  [");
    for (int k = 0; k < outputs[i].size(); ++k) std::printf(k == 0 ? "%.9g" : ", %.9g", outputs[i][k]);
    std::printf("]");
  }
  std::printf("\n]\n");
  return std::fflush(stdout) == 0 ? 0 : 3;
}
