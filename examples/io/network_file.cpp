#include "io/network_file.hpp"

#include <rme/network/json.hpp>

#include "io/json_file.hpp"

namespace rme::examples {

NetworkFile read_network_file(const std::string& path) {
  const auto model = model_from_json<float>(read_json_file(path));
  NetworkFile file;
  file.network = std::make_shared<const MismatchNetwork<float>>(model.weights);
  const auto damping = model.training.find("damping");
  if (damping != model.training.end() && damping->is_number()) file.damping = damping->get<double>();
  return file;
}

}  // namespace rme::examples
