#include <io/json_file.hpp>
#include <memory>
#include <rme/network/json.hpp>

#include "panda_weights.hpp"  // made by weights_to_header from the same file
#include "support/catch.hpp"

namespace {

TEST_CASE("weights_to_header: the constant holds the same floats as the file", "[weights_to_header]") {
  const auto model = std::make_unique<rme::MismatchModel<float>>(
      rme::model_from_json<float>(rme::examples::read_json_file(RME_PANDA_MODEL)));
  CHECK(panda_weights.frame == model->weights.frame);
  CHECK(panda_weights.normalization_mean == model->weights.normalization_mean);
  CHECK(panda_weights.normalization_std == model->weights.normalization_std);
  std::vector<float> in_file, in_header;
  const auto append = [](std::vector<float>& all) {
    return [&all](auto, auto, const auto& array) { all.insert(all.end(), array.begin(), array.end()); };
  };
  rme::for_each_tensor(model->weights, append(in_file));
  rme::for_each_tensor(panda_weights, append(in_header));
  CHECK(in_header.size() == 53252);
  CHECK(in_header == in_file);
}

}  // namespace
