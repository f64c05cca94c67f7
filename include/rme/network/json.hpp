#pragma once
/// A network's JSON form (docs/weights.md). Link rme::json.
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <rme/core/describe_json.hpp>
#include <rme/core/require.hpp>
#include <rme/network/mismatch_network.hpp>
#include <rme/network/weights.hpp>
#include <string>
#include <utility>

namespace rme {

/// The contents of a weights file. It holds the weights by value, 213 KB in float: do not put it on a small stack.
template <typename Scalar, typename Architecture = PublishedArchitecture>
struct MismatchModel {
  std::string robot;                                     ///< the arm it was trained for, e.g. "Franka Emika Panda"
  std::string end_effector;                              ///< the frame that "end effector" means, e.g. "flange"
  nlohmann::json training = nlohmann::json::object();    ///< how it was trained, free-form
  MismatchNetworkWeights<Scalar, Architecture> weights;  ///< of the network
};

/// The model that a JSON value describes.
/// @throws std::invalid_argument naming the first field that is missing, unknown, of another type, shape or
///         architecture, or not a finite number in Scalar, with what was expected and what was found
template <typename Scalar, typename Architecture = PublishedArchitecture>
MismatchModel<Scalar, Architecture> model_from_json(const nlohmann::json& file);

/// The JSON value of a model; model_from_json() gives the same model back.
/// @throws std::invalid_argument if a number is not finite or a standard deviation is not > 0
template <typename Scalar, typename Architecture>
nlohmann::json model_to_json(const MismatchModel<Scalar, Architecture>& model);

namespace detail {

constexpr const char* kWeightsFormat = "rme.mismatch_network";
constexpr int kWeightsVersion = 1;
constexpr int kDeepestTraining = 32;

[[noreturn]] inline void refuse_json(const std::string& path, const std::string& expected, const std::string& got) {
  refuse(path + ": expected " + expected + ", got " + got);
}

inline std::string join(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

/// Refuses any value but an object with exactly these keys.
inline void require_keys(const nlohmann::json& object, const std::string& path,
                         std::initializer_list<const char*> keys) {
  if (!object.is_object()) refuse_json(path.empty() ? "weights file" : path, "an object", describe(object));
  for (const char* key : keys) {
    if (!object.contains(key)) refuse_json(join(path, key), "a value", "none");
  }
  for (const auto& item : object.items()) {
    bool known = false;
    for (const char* key : keys) known = known || item.key() == key;
    if (!known) refuse_json(join(path, item.key()), "no such field", describe(item.value()));
  }
}

/// Refuses any value but this integer; 8.0 and "8" are refused in place of 8.
inline void require_integer(const nlohmann::json& object, const std::string& path, const char* key, int expected) {
  const nlohmann::json& value = object.at(key);
  if (!value.is_number_integer() || value != expected) {
    refuse_json(join(path, key), std::to_string(expected), describe(value));
  }
}

inline std::string read_string(const nlohmann::json& object, const char* key) {
  const nlohmann::json& value = object.at(key);
  if (!value.is_string()) refuse_json(key, "a string", describe(value));
  return value.get<std::string>();
}

/// Writes the numbers of a nested array of `shape` to `out` and the following, row-major. A number must be finite: JSON
/// text cannot contain a NaN, but a JSON value in memory can.
template <typename Scalar, std::size_t Rank>
void read_numbers(const nlohmann::json& value, const std::string& path, const std::array<int, Rank>& shape,
                  Scalar*& out, std::size_t axis = 0) {
  if (axis == Rank) {
    constexpr double largest = static_cast<double>(std::numeric_limits<Scalar>::max());
    if (!value.is_number()) refuse_json(path, "a number", describe(value));
    const double number = value.get<double>();
    if (!(std::abs(number) <= largest)) {
      refuse_json(path, "a finite number of at most " + nlohmann::json(largest).dump(), describe(value));
    }
    *out++ = static_cast<Scalar>(number);
    return;
  }
  const auto size = static_cast<std::size_t>(shape[axis]);
  if (!value.is_array() || value.size() != size) {
    refuse_json(path, "an array of " + std::to_string(size), describe(value));
  }
  for (std::size_t i = 0; i < size; ++i) {
    read_numbers(value[i], path + "[" + std::to_string(i) + "]", shape, out, axis + 1);
  }
}

/// The nested array of `shape` made of the numbers from `in` on.
template <typename Scalar, std::size_t Rank>
nlohmann::json write_numbers(const std::array<int, Rank>& shape, const Scalar*& in, std::size_t axis = 0) {
  if (axis == Rank) return *in++;
  nlohmann::json value = nlohmann::json::array();
  for (int i = 0; i < shape[axis]; ++i) value.push_back(write_numbers(shape, in, axis + 1));
  return value;
}

/// Refuses a value that is nested more deeply than `levels`. Copying and writing a JSON value recurse: a file with a
/// million brackets would overflow the stack.
inline void require_depth(const nlohmann::json& value, const std::string& path, int levels) {
  if (!value.is_structured()) return;
  if (levels == 0) refuse_json(path, "at most " + std::to_string(kDeepestTraining) + " levels of nesting", "more");
  for (const auto& child : value) require_depth(child, path, levels - 1);
}

}  // namespace detail

template <typename Scalar, typename Architecture>
MismatchModel<Scalar, Architecture> model_from_json(const nlohmann::json& file) {
  using A = Architecture;
  using namespace detail;
  require_keys(file, "",
               {"format", "version", "input", "architecture", "normalization", "outputs", "robot", "end_effector",
                "training", "weights"});
  if (file["format"] != kWeightsFormat) {
    refuse_json("format", '"' + std::string(kWeightsFormat) + '"', describe(file["format"]));
  }
  require_integer(file, "", "version", kWeightsVersion);

  MismatchModel<Scalar, Architecture> model;
  const nlohmann::json& input = file["input"];
  require_keys(input, "input", {"samples", "channels", "frame"});
  require_integer(input, "input", "samples", A::kSamples);
  require_integer(input, "input", "channels", A::kChannels);
  if (input["frame"] == "world") {
    model.weights.frame = InputFrame::World;
  } else if (input["frame"] == "end_effector") {
    model.weights.frame = InputFrame::EndEffector;
  } else {
    refuse_json("input.frame", R"("world" or "end_effector")", describe(input["frame"]));
  }

  const nlohmann::json& architecture = file["architecture"];
  require_keys(architecture, "architecture",
               {"conv_channels", "conv_kernel", "heads", "mlp_hidden", "mlp_repeats", "outputs"});
  require_integer(architecture, "architecture", "conv_channels", A::kConvChannels);
  require_integer(architecture, "architecture", "conv_kernel", A::kConvKernel);
  require_integer(architecture, "architecture", "heads", A::kHeads);
  require_integer(architecture, "architecture", "mlp_hidden", A::kMlpHidden);
  require_integer(architecture, "architecture", "mlp_repeats", A::kMlpRepeats);
  require_integer(architecture, "architecture", "outputs", A::kOutputs);
  const nlohmann::json output_names = A::kOutputNames;
  if (file["outputs"] != output_names) refuse_json("outputs", output_names.dump(), describe(file["outputs"]));

  const nlohmann::json& normalization = file["normalization"];
  require_keys(normalization, "normalization", {"mean", "std"});
  Scalar* mean = model.weights.normalization_mean.data();
  read_numbers(normalization["mean"], "normalization.mean", std::array{A::kChannels}, mean);
  Scalar* std = model.weights.normalization_std.data();
  read_numbers(normalization["std"], "normalization.std", std::array{A::kChannels}, std);
  for (std::size_t i = 0; i < model.weights.normalization_std.size(); ++i) {
    if (!(model.weights.normalization_std[i] > 0)) {
      refuse_json("normalization.std[" + std::to_string(i) + "]", "a number > 0", describe(normalization["std"][i]));
    }
  }

  model.robot = read_string(file, "robot");
  model.end_effector = read_string(file, "end_effector");
  const nlohmann::json& training = file["training"];
  if (!training.is_object()) refuse_json("training", "an object", describe(training));
  require_depth(training, "training", kDeepestTraining);
  model.training = training;

  const nlohmann::json& weights = file["weights"];
  require_keys(weights, "weights",
               {"convolution.weight", "convolution.bias", "positional_embedding", "attention.in_proj_weight",
                "attention.in_proj_bias", "attention.out_proj.weight", "attention.out_proj.bias", "mlp.0.weight",
                "mlp.0.bias", "mlp.2.weight", "mlp.2.bias", "head.weight", "head.bias"});
  for_each_tensor(model.weights, [&](const char* name, const auto& shape, auto& array) {
    Scalar* numbers = array.data();
    read_numbers(weights.at(name), join("weights", name), shape, numbers);
  });
  return model;
}

template <typename Scalar, typename Architecture>
nlohmann::json model_to_json(const MismatchModel<Scalar, Architecture>& model) {
  using A = Architecture;
  detail::require_usable(model.weights);
  const auto plain = [](const auto& array) { return nlohmann::json(array); };
  nlohmann::json weights = nlohmann::json::object();
  for_each_tensor(model.weights, [&](const char* name, const auto& shape, const auto& array) {
    const Scalar* numbers = array.data();
    weights[name] = detail::write_numbers(shape, numbers);
  });
  return {{"format", detail::kWeightsFormat},
          {"version", detail::kWeightsVersion},
          {"input",
           {{"samples", A::kSamples},
            {"channels", A::kChannels},
            {"frame", model.weights.frame == InputFrame::World ? "world" : "end_effector"}}},
          {"architecture",
           {{"conv_channels", A::kConvChannels},
            {"conv_kernel", A::kConvKernel},
            {"heads", A::kHeads},
            {"mlp_hidden", A::kMlpHidden},
            {"mlp_repeats", A::kMlpRepeats},
            {"outputs", A::kOutputs}}},
          {"normalization",
           {{"mean", plain(model.weights.normalization_mean)}, {"std", plain(model.weights.normalization_std)}}},
          {"outputs", A::kOutputNames},
          {"robot", model.robot},
          {"end_effector", model.end_effector},
          {"training", model.training},
          {"weights", std::move(weights)}};
}

}  // namespace rme
