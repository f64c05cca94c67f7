#include <rme/inference/mean_field.hpp>

#include "headers/float_core/float_core.hpp"
#include "headers/float_core/inference.hpp"

namespace float_core {
namespace {

bool mean_field_finds_the_payload() {
  return finds_the_payload([](const auto& likelihood, const auto& prior, auto& result) {
    return rme::infer_payload(likelihood, prior, result, rme::MeanFieldConfig());
  });
}

}  // namespace

const std::vector<Case> kMeanField = {{"infer_payload: mean field finds the payload", mean_field_finds_the_payload}};

}  // namespace float_core
