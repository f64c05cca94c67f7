// fuzz_json [CASES [SEED]]: spoils a weights file, as text and as a JSON value, and asks the loader about each.
//
// The oracle is independent of the loader: a file is good if, and only if, it has the structure of the original, with
// numbers where that has numbers and the same values wherever the value matters. The loader must accept the good ones,
// give a network that answers, and refuse the rest with std::invalid_argument. Build it with
// -fsanitize=address,undefined to see what else goes wrong. Exit code 1 at the first disagreement, which is printed.
// tests/fuzz/fuzz_weights.cpp looks for what crashes the loader, guided by coverage, and needs clang; this program
// knows what is right, and needs nothing.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <rme/network/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>

#include "io/json_file.hpp"
#include "network/golden.hpp"

namespace {

using nlohmann::json;

using golden::SmallArchitecture;  // so that a million cases take minutes
using Model = rme::MismatchModel<float, SmallArchitecture>;
using Network = rme::MismatchNetwork<float, SmallArchitecture>;

using Random = std::mt19937;

std::size_t below(Random& random, std::size_t end) {
  return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
}

template <typename Container>
auto& any_of(Random& random, Container& values) {
  return values[below(random, values.size())];
}

json original() {
  Model model;
  model.robot = "an arm";
  model.end_effector = "its flange";
  model.training = {{"seed", 7}, {"notes", {1, "two", nullptr}}};
  model.weights = *golden::random_weights<float, SmallArchitecture>();
  json file = rme::model_to_json(model);
  // Short numbers: more of the text is structure.
  for (auto& tensor : file["weights"]) {
    const json flat = tensor.flatten();
    for (const auto& pointer : flat.items()) {
      json& number = tensor[json::json_pointer(pointer.key())];
      number = std::round(number.get<double>() * 100) / 100;
    }
  }
  return file;
}

int depth(const json& value) {
  if (!value.is_structured()) return 0;
  int deepest = 0;
  for (const auto& child : value) deepest = std::max(deepest, depth(child));
  return 1 + deepest;
}

/// The oracle, by comparison with the original at the same place.
bool good(const json& value, const json& model, const std::string& path) {
  if (path == "/training") return value.is_object() && depth(value) <= 32;
  if (path == "/robot" || path == "/end_effector") return value.is_string();
  if (path == "/input/frame") return value == "world" || value == "end_effector";
  if (path.rfind("/weights/", 0) == 0 || path.rfind("/normalization/", 0) == 0) {
    if (model.is_number()) {
      if (!value.is_number() || !(std::abs(value.get<double>()) <= 3.4028234663852886e38)) return false;
      return path.rfind("/normalization/std/", 0) != 0 || static_cast<float>(value.get<double>()) > 0;
    }
  } else if (!model.is_object()) {
    return value == model && value.is_number_float() == model.is_number_float();
  }
  if (value.type() != model.type() || value.size() != model.size()) return false;
  if (model.is_object()) {
    for (const auto& item : model.items()) {
      if (!value.contains(item.key()) || !good(value[item.key()], item.value(), path + "/" + item.key())) return false;
    }
  } else {
    for (std::size_t i = 0; i < model.size(); ++i) {
      if (!good(value[i], model[i], path + "/" + std::to_string(i))) return false;
    }
  }
  return true;
}

std::string spoil_text(std::string text, Random& random) {
  static const std::vector<std::string> tokens = {"null",
                                                  "true",
                                                  "NaN",
                                                  "-",
                                                  "1e999",
                                                  "1e39",
                                                  "-0.0",
                                                  "1e-60",
                                                  "0",
                                                  "[",
                                                  "]",
                                                  "{",
                                                  "}",
                                                  ",",
                                                  ":",
                                                  "\"",
                                                  "\\u0000",
                                                  "\xff",
                                                  "\n",
                                                  "[[[[[[",
                                                  "{\"a\":",
                                                  "\"world\"",
                                                  "\"version\":1,",
                                                  "."};
  for (std::size_t edits = 1 + below(random, 3); edits > 0 && !text.empty(); --edits) {
    const std::size_t at = below(random, text.size());
    const std::size_t length = 1 + below(random, std::size_t(1) << below(random, 8));
    switch (below(random, 6)) {
      case 0:
        text[at] = static_cast<char>(below(random, 256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, any_of(random, tokens));
        break;
      case 3:
        text.insert(below(random, text.size()), text.substr(at, length));
        break;
      case 4:
        text.resize(at);
        break;
      default:  // another digit, which often leaves a good file
        for (std::size_t i = at; i < text.size(); ++i) {
          if (text[i] >= '0' && text[i] <= '9') {
            text[i] = static_cast<char>('0' + below(random, 10));
            break;
          }
        }
    }
  }
  return text;
}

json junk(Random& random) {
  switch (below(random, 12)) {
    case 0:
      return nullptr;
    case 1:
      return below(random, 2) == 0;
    case 2:
      return static_cast<int>(below(random, 100)) - 50;
    case 3:
      return -std::numeric_limits<double>::infinity();
    case 4:
      return std::numeric_limits<double>::quiet_NaN();
    case 5:
      return std::pow(10.0, static_cast<double>(below(random, 600)) - 300);
    case 6:
      return "end_effector";
    case 7:
      return std::string(below(random, 200), '\xc3');  // not UTF-8
    case 8:
      return json::array();
    case 9:
      return json::object();
    case 10:
      return std::numeric_limits<std::uint64_t>::max();
    default: {
      json deep = 1;
      for (std::size_t levels = below(random, 60); levels > 0; --levels) deep = json::array({deep});
      return deep;
    }
  }
}

json spoil_value(json file, Random& random) {
  for (std::size_t edits = 1 + below(random, 2); edits > 0; --edits) {
    json* place = &file;
    while (place->is_structured() && !place->empty() && below(random, 8) != 0) {
      place = &*std::next(place->begin(), static_cast<std::ptrdiff_t>(below(random, place->size())));
    }
    const bool fill = place->is_structured() && below(random, 2) == 0;
    if (fill && place->is_array()) {
      place->push_back(junk(random));
    } else if (fill && below(random, 2) == 0) {
      (*place)[std::string(1, static_cast<char>('a' + below(random, 26)))] = junk(random);
    } else if (place->is_structured() && !place->empty() && below(random, 2) == 0) {
      place->erase(std::next(place->begin(), static_cast<std::ptrdiff_t>(below(random, place->size()))));
    } else {
      *place = junk(random);
    }
    if (!file.is_object()) break;
  }
  return file;
}

/// Throws std::logic_error if loader and oracle disagree; says whether the file was accepted.
bool agree(const json& file, const json& model) {
  const bool expected = good(file, model, "");
  bool accepted = true;
  try {
    const Network network(rme::model_from_json<float, SmallArchitecture>(file).weights);
    Network::Output out = Network::Output::Zero();
    // Weights near the largest float overflow on the way; that must be said, and nothing be written.
    if (network.forward(Network::Window::Ones(), out) != rme::Status::Ok) {
      if (!out.isZero(0)) throw std::logic_error("an output was written beside a refusal");
    } else if (!out.allFinite()) {
      throw std::logic_error("the output is not finite");
    }
  } catch (const std::invalid_argument& error) {
    accepted = false;
    if (std::string(error.what()).find("expected") == std::string::npos) {
      throw std::logic_error(std::string("says too little: ") + error.what());
    }
  }
  if (accepted != expected) throw std::logic_error(accepted ? "accepted a bad file" : "refused a good file");
  return accepted;
}

int fuzz(long cases, unsigned seed) {
  const std::string text = original().dump();
  const json model = json::parse(text);
  Random random(seed);
  long accepted = 0, unparsed = 0;
  for (long k = 0; k < cases; ++k) {
    json file;
    if (below(random, 2) == 0) {
      std::istringstream stream(spoil_text(text, random));
      try {
        file = rme::examples::parse_strictly(stream);
      } catch (const std::exception&) {
        ++unparsed;
        continue;
      }
    } else {
      file = spoil_value(model, random);
    }
    try {
      accepted += agree(file, model);
    } catch (const std::logic_error& error) {
      std::printf("seed %u, case %ld: %s\n%s\n", seed, k, error.what(),
                  json::diff(model, file).dump(1, ' ', false, json::error_handler_t::replace).c_str());
      return 1;
    }
  }
  std::printf("seed %u: %ld cases, %ld of them good, %ld no JSON, the others refused\n", seed, cases, accepted,
              unparsed);
  return accepted > 0 && unparsed > 0 && accepted + unparsed < cases ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return fuzz(argc > 1 ? std::atol(argv[1]) : 20000, static_cast<unsigned>(argc > 2 ? std::atol(argv[2]) : 1));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fuzz_json: %s\n", error.what());
    return 1;
  }
}
