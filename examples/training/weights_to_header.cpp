// weights_to_header WEIGHTS.json NAME: prints a weights file as a C++ header, for a controller without files or JSON.
//
//     weights_to_header panda.json panda_weights > panda_weights.hpp
//
//     #include "panda_weights.hpp"
//     static const rme::MismatchNetwork<float> network(panda_weights);
#include <cctype>
#include <cstdio>
#include <io/json_file.hpp>
#include <io/program.hpp>
#include <memory>
#include <rme/network/json.hpp>
#include <stdexcept>
#include <string>

namespace {

using Model = rme::MismatchModel<float>;
using rme::examples::ArgumentError;
using rme::examples::Arguments;

constexpr const char* kUsage =
    R"(usage: weights_to_header WEIGHTS.json NAME

Prints the weights as a C++ header with a constant NAME, which must be a C++ identifier.

Exit codes: 0 done; 2 unusable arguments; 3 unusable weights.
)";

bool is_identifier(const std::string& name) {
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0]))) return false;
  for (const char c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_') return false;
  }
  return true;
}

/// A literal of exactly this float: 9 digits suffice.
std::string literal(float value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.9g", static_cast<double>(value));
  std::string number = text;
  if (number.find_first_of(".e") == std::string::npos) number += ".0";
  return number + "f";
}

template <typename Array>
void print_array(const char* name, const Array& array) {
  std::printf("    // %s\n    {{", name);
  for (std::size_t i = 0; i < array.size(); ++i) {
    std::printf("%s%s", i == 0 ? "" : i % 10 == 0 ? ",\n      " : ", ", literal(array[i]).c_str());
  }
  std::printf("}},\n");
}

void print_header(const Model& model, const std::string& name) {
  const auto& weights = model.weights;
  const bool world = weights.frame == rme::InputFrame::World;
  std::printf("#pragma once\n// Made by rme's weights_to_header.\n#include <rme/network/weights.hpp>\n\n");
  std::printf("inline constexpr rme::MismatchNetworkWeights<float> %s{\n", name.c_str());
  std::printf("    rme::InputFrame::%s,\n", world ? "World" : "EndEffector");
  // An aggregate needs its members in order; for_each_tensor has the same order.
  print_array("normalization.mean", weights.normalization_mean);
  print_array("normalization.std", weights.normalization_std);
  rme::for_each_tensor(weights, [](const char* tensor, const auto&, const auto& array) { print_array(tensor, array); });
  std::printf("};\n");
}

int run(Arguments& arguments) {
  const std::string file = arguments.positional("WEIGHTS.json"), name = arguments.positional("NAME");
  arguments.finish();
  if (!is_identifier(name)) throw ArgumentError("NAME: \"" + name + "\" is no C++ identifier");
  const auto model = std::make_unique<Model>(rme::model_from_json<float>(rme::examples::read_json_file(file)));
  print_header(*model, name);
  if (std::fflush(stdout) != 0) throw std::runtime_error("cannot write to standard output");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return rme::examples::run_program("weights_to_header", kUsage, argc, argv, run);
}
