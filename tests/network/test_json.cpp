#include <functional>
#include <limits>
#include <memory>
#include <rme/network/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "io/json_file.hpp"
#include "network/golden.hpp"
#include "support/catch.hpp"

namespace {

using nlohmann::json;

/// A small architecture, so that a case takes microseconds; the code is the same for every size.
struct SmallArchitecture {
  static constexpr int kSamples = 3, kChannels = 2, kConvChannels = 4, kConvKernel = 3, kHeads = 2, kMlpHidden = 5,
                       kMlpRepeats = 2, kOutputs = 2;
  static constexpr std::array<const char*, kOutputs> kOutputNames{"mass", "com_x"};
};

template <typename Scalar, typename Architecture = SmallArchitecture>
std::unique_ptr<rme::MismatchModel<Scalar, Architecture>> example() {
  auto model = std::make_unique<rme::MismatchModel<Scalar, Architecture>>();
  model->robot = "an arm";
  model->end_effector = "its flange";
  model->training = {{"seed", 7}, {"notes", {1, "two", nullptr}}};
  model->weights = *golden::random_weights<Scalar, Architecture>();
  model->weights.frame = rme::InputFrame::EndEffector;
  return model;
}

template <typename Scalar>
std::vector<Scalar> numbers_of(const rme::MismatchNetworkWeights<Scalar, SmallArchitecture>& weights) {
  std::vector<Scalar> numbers(weights.normalization_mean.begin(), weights.normalization_mean.end());
  numbers.insert(numbers.end(), weights.normalization_std.begin(), weights.normalization_std.end());
  rme::for_each_tensor(weights, [&](auto, auto, const auto& a) { numbers.insert(numbers.end(), a.begin(), a.end()); });
  return numbers;
}

TEMPLATE_TEST_CASE("JSON: a model written as text and read again is the same model", "[json]", float, double) {
  const auto model = example<TestType>();
  const std::string text = rme::model_to_json(*model).dump();
  const auto again = rme::model_from_json<TestType, SmallArchitecture>(json::parse(text));
  CHECK(again.robot == model->robot);
  CHECK(again.end_effector == model->end_effector);
  CHECK(again.training == model->training);
  CHECK(again.weights.frame == rme::InputFrame::EndEffector);
  CHECK(numbers_of(again.weights) == numbers_of(model->weights));
}

TEST_CASE("JSON: either frame of the input comes back", "[json]") {
  for (const auto frame : {rme::InputFrame::World, rme::InputFrame::EndEffector}) {
    const auto model = example<float>();
    model->weights.frame = frame;
    CHECK(rme::model_from_json<float, SmallArchitecture>(rme::model_to_json(*model)).weights.frame == frame);
  }
}

TEST_CASE("JSON: the published architecture has the format's names, sizes and shapes", "[json]") {
  const json file = rme::model_to_json(*example<float, rme::PublishedArchitecture>());
  CHECK(file["format"] == "rme.mismatch_network");
  CHECK(file["version"] == 1);
  CHECK(file["input"] == json::parse(R"({"samples": 20, "channels": 6, "frame": "end_effector"})"));
  CHECK(file["architecture"] == json::parse(R"({"conv_channels": 64, "conv_kernel": 5, "heads": 8, "mlp_hidden": 256,
                                                "mlp_repeats": 3, "outputs": 4})"));
  CHECK(file["outputs"] == json::parse(R"(["mass", "com_x", "com_y", "com_z"])"));
  const std::vector<std::pair<std::string, std::vector<std::size_t>>> shapes = {{"convolution.weight", {64, 6, 5}},
                                                                                {"convolution.bias", {64}},
                                                                                {"positional_embedding", {20, 64}},
                                                                                {"attention.in_proj_weight", {192, 64}},
                                                                                {"attention.in_proj_bias", {192}},
                                                                                {"attention.out_proj.weight", {64, 64}},
                                                                                {"attention.out_proj.bias", {64}},
                                                                                {"mlp.0.weight", {256, 64}},
                                                                                {"mlp.0.bias", {256}},
                                                                                {"mlp.2.weight", {64, 256}},
                                                                                {"mlp.2.bias", {64}},
                                                                                {"head.weight", {4, 64}},
                                                                                {"head.bias", {4}}};
  REQUIRE(file["weights"].size() == shapes.size());
  for (const auto& [name, shape] : shapes) {
    CAPTURE(name);
    const json* value = &file["weights"][name];
    for (const std::size_t size : shape) {
      REQUIRE(value->is_array());
      CHECK(value->size() == size);
      value = &value->front();
    }
    CHECK(value->is_number());
  }
}

TEST_CASE("JSON: nested arrays are row-major, the last index fastest", "[json]") {
  const auto model = example<double>();
  const json file = rme::model_to_json(*model);
  // convolution.weight [4][2][3]: element [3][1][2] is number (3 * 2 + 1) * 3 + 2.
  CHECK(file["weights"]["convolution.weight"][3][1][2] == model->weights.convolution_weight[23]);
  CHECK(file["weights"]["mlp.0.weight"][4][1] == model->weights.mlp_0_weight[4 * 4 + 1]);
}

struct BadFile {
  const char* what;
  std::function<void(json&)> spoil;
  const char* field;
  const char* expected;
  const char* got;
};

TEST_CASE("JSON: a bad file is refused with the field, what was expected and what came", "[json]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  json nested = 1;
  for (int k = 0; k < 100; ++k) nested = json::array({nested});
  const std::vector<BadFile> cases = {
      {"no object",
       [](json& f) {
         f = json::array({1, 2});
       },
       "weights file", "an object", "an array of 2"},
      {"other format", [](json& f) { f["format"] = "onnx"; }, "format", "rme.mismatch_network", "\"onnx\""},
      {"later version", [](json& f) { f["version"] = 2; }, "version", "1", "2"},
      {"version as text", [](json& f) { f["version"] = "1"; }, "version", "1", "\"1\""},
      {"no version", [](json& f) { f.erase("version"); }, "version", "a value", "none"},
      {"no training", [](json& f) { f.erase("training"); }, "training", "a value", "none"},
      {"surplus field", [](json& f) { f["comment"] = true; }, "comment", "no such field", "true"},
      {"surplus input field", [](json& f) { f["input"]["rate"] = 1000; }, "input.rate", "no such field", "1000"},
      {"input no object", [](json& f) { f["input"] = 20; }, "input", "an object", "20"},
      {"samples", [](json& f) { f["input"]["samples"] = 21; }, "input.samples", "3", "21"},
      {"channels", [](json& f) { f["input"]["channels"] = 7; }, "input.channels", "2", "7"},
      {"frame", [](json& f) { f["input"]["frame"] = "base"; }, "input.frame", "\"world\" or \"end_effector\"",
       "\"base\""},
      {"conv_channels", [](json& f) { f["architecture"]["conv_channels"] = 32; }, "architecture.conv_channels", "4",
       "32"},
      {"conv_kernel", [](json& f) { f["architecture"]["conv_kernel"] = 5; }, "architecture.conv_kernel", "3", "5"},
      {"heads", [](json& f) { f["architecture"]["heads"] = 4; }, "architecture.heads", "2", "4"},
      {"mlp_hidden", [](json& f) { f["architecture"]["mlp_hidden"] = 6; }, "architecture.mlp_hidden", "5", "6"},
      {"mlp_repeats", [](json& f) { f["architecture"]["mlp_repeats"] = 1; }, "architecture.mlp_repeats", "2", "1"},
      {"outputs", [](json& f) { f["architecture"]["outputs"] = 8; }, "architecture.outputs", "2", "8"},
      {"size as fraction", [](json& f) { f["architecture"]["heads"] = 2.5; }, "architecture.heads", "2", "2.5"},
      {"output order",
       [](json& f) {
         f["outputs"] = {"com_x", "mass"};
       },
       "outputs", "[\"mass\",\"com_x\"]", "an array of 2"},
      {"robot", [](json& f) { f["robot"] = nullptr; }, "robot", "a string", "null"},
      {"end effector", [](json& f) { f["end_effector"] = 3; }, "end_effector", "a string", "3"},
      {"training no object", [](json& f) { f["training"] = json::array(); }, "training", "an object", "an array of 0"},
      {"training deeper than a stack", [&](json& f) { f["training"]["deep"] = nested; }, "training", "32 levels",
       "more"},
      {"mean too short", [](json& f) { f["normalization"]["mean"] = {1}; }, "normalization.mean", "an array of 2",
       "an array of 1"},
      {"std zero", [](json& f) { f["normalization"]["std"][1] = 0; }, "normalization.std[1]", "> 0", "0"},
      {"std negative", [](json& f) { f["normalization"]["std"][0] = -1; }, "normalization.std[0]", "> 0", "-1"},
      {"std zero once it is a float", [](json& f) { f["normalization"]["std"][0] = 1e-60; }, "normalization.std[0]",
       "> 0", "1e-60"},
      {"surplus in normalization", [](json& f) { f["normalization"]["var"] = 1; }, "normalization.var", "no such field",
       "1"},
      {"weights no object", [](json& f) { f["weights"] = json::array(); }, "weights", "an object", "an array of 0"},
      {"tensor missing", [](json& f) { f["weights"].erase("mlp.2.bias"); }, "weights.mlp.2.bias", "a value", "none"},
      {"tensor surplus", [](json& f) { f["weights"]["mlp.4.bias"] = {0}; }, "weights.mlp.4.bias", "no such field",
       "an array of 1"},
      {"tensor misnamed",
       [](json& f) {
         f["weights"]["conv.bias"] = f["weights"]["convolution.bias"];
         f["weights"].erase("convolution.bias");
       },
       "weights.convolution.bias", "a value", "none"},
      {"outermost axis", [](json& f) { f["weights"]["convolution.weight"].push_back(0); },
       "weights.convolution.weight:", "an array of 4", "an array of 5"},
      {"middle axis", [](json& f) { f["weights"]["convolution.weight"][2].erase(0); },
       "weights.convolution.weight[2]:", "an array of 2", "an array of 1"},
      {"innermost axis", [](json& f) { f["weights"]["convolution.weight"][2][1].push_back(0); },
       "weights.convolution.weight[2][1]:", "an array of 3", "an array of 4"},
      {"flattened",
       [](json& f) {
         f["weights"]["head.weight"] = {1, 2};
       },
       "weights.head.weight[0]", "an array of 4", "1"},
      {"scalar for an array", [](json& f) { f["weights"]["head.bias"] = 1; }, "weights.head.bias", "an array of 2",
       "1"},
      {"array for a scalar", [](json& f) { f["weights"]["head.bias"][1] = {1}; }, "weights.head.bias[1]", "a number",
       "an array of 1"},
      {"text", [](json& f) { f["weights"]["head.bias"][1] = "0.5"; }, "weights.head.bias[1]", "a number", "\"0.5\""},
      {"true", [](json& f) { f["weights"]["head.bias"][0] = true; }, "weights.head.bias[0]", "a number", "true"},
      {"null", [](json& f) { f["weights"]["mlp.0.weight"][4][3] = nullptr; }, "weights.mlp.0.weight[4][3]", "a number",
       "null"},
      {"NaN", [=](json& f) { f["weights"]["mlp.2.weight"][0][2] = nan; }, "weights.mlp.2.weight[0][2]", "finite",
       "nan"},
      {"infinity", [=](json& f) { f["weights"]["mlp.0.bias"][3] = -infinity; }, "weights.mlp.0.bias[3]", "finite",
       "-inf"},
      {"infinite mean", [=](json& f) { f["normalization"]["mean"][1] = infinity; }, "normalization.mean[1]", "finite",
       "inf"},
      {"too large for a float", [](json& f) { f["weights"]["head.bias"][0] = 1e39; }, "weights.head.bias[0]", "3.40",
       "1e+39"},
  };
  const json good = rme::model_to_json(*example<float>());
  for (const BadFile& bad : cases) {
    CAPTURE(bad.what);
    json file = good;
    bad.spoil(file);
    std::string message = "accepted";
    try {
      (void)rme::model_from_json<float, SmallArchitecture>(file);
    } catch (const std::invalid_argument& error) {
      message = error.what();
    }
    CHECK_THAT(message, Catch::Matchers::StartsWith(bad.field));
    CHECK_THAT(message, contains(std::string("expected ")) && contains(bad.expected));
    CHECK_THAT(message, contains(std::string("got ") + bad.got));
  }
}

TEST_CASE("JSON: each field and each tensor is required", "[json]") {
  const json good = rme::model_to_json(*example<double>());
  for (const char* object : {"", "/input", "/architecture", "/normalization", "/weights"}) {
    for (const auto& item : good.at(json::json_pointer(object)).items()) {
      CAPTURE(object, item.key());
      json file = good;
      file.at(json::json_pointer(object)).erase(item.key());
      CHECK_THROWS_WITH((rme::model_from_json<double, SmallArchitecture>(file)), contains(item.key()));
    }
  }
}

TEST_CASE("JSON: a number too large for a float may be a double's", "[json]") {
  json file = rme::model_to_json(*example<double>());
  file["weights"]["head.bias"][0] = 1e39;
  CHECK(rme::model_from_json<double, SmallArchitecture>(file).weights.head_bias[0] == 1e39);
}

TEST_CASE("JSON: a model with a NaN is not written", "[json]") {
  const auto model = example<float>();
  model->weights.head_bias[1] = std::numeric_limits<float>::quiet_NaN();
  CHECK_THROWS_WITH(rme::model_to_json(*model), contains("head.bias"));
}

TEST_CASE("JSON: a file with a key twice, a number beyond every double, or a literal NaN is no JSON", "[json]") {
  const auto parse = [](const char* text) {
    std::istringstream stream(text);
    return rme::examples::parse_strictly(stream);
  };
  CHECK(parse(R"({"a": {"b": 1}, "c": {"b": 2}})").size() == 2);
  CHECK_THROWS_WITH(parse(R"({"a": {"b": 1, "b": 2}})"), contains("\"b\" stands twice"));
  CHECK_THROWS_WITH(parse("[1e999]"), contains("1e999"));
  CHECK_THROWS(parse("[NaN]"));
  CHECK_THROWS(parse("[1] [2]"));
  CHECK_THROWS(parse(""));
}

}  // namespace
