// run_network WEIGHTS.json INPUTS.json: prints the outputs of an exported network, to check that the export is right.
//
// If there is an error, standard output stays empty.
#include <cstdio>
#include <memory>
#include <rme/network/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/json_file.hpp"
#include "io/program.hpp"

namespace {

constexpr const char* kUsage =
    R"(usage: run_network WEIGHTS.json INPUTS.json

INPUTS.json is an array of windows, each 20 samples x 6 channels: raw (un-normalised) pseudo-wrenches, force [N] then
moment [N m], oldest sample first, in the axes that the weights file states under input.frame. Prints an array with one
array per window, (mass [kg], com_x, com_y, com_z [m]), 9 significant digits.

Exit codes: 0 done; 2 unusable arguments; 3 a file that cannot be read or used.
)";

using rme::examples::Arguments;
using Network = rme::MismatchNetwork<double>;

std::unique_ptr<Network> load_network(const std::string& path) {
  const nlohmann::json file = rme::examples::read_json_file(path);
  try {
    return std::make_unique<Network>(rme::model_from_json<double>(file).weights);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

std::vector<Network::Output> answers(const Network& network, const std::string& path) {
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

int run(Arguments& arguments) {
  const std::string weights = arguments.positional("WEIGHTS.json"), inputs = arguments.positional("INPUTS.json");
  arguments.finish();
  const std::vector<Network::Output> outputs = answers(*load_network(weights), inputs);
  std::printf("[");
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    std::printf(i == 0 ? "\n  [" : ",\n  [");
    for (int k = 0; k < outputs[i].size(); ++k) std::printf(k == 0 ? "%.9g" : ", %.9g", outputs[i][k]);
    std::printf("]");
  }
  std::printf("\n]\n");
  if (std::fflush(stdout) != 0) throw std::runtime_error("cannot write to standard output");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return rme::examples::run_program("run_network", kUsage, argc, argv, run);
}
