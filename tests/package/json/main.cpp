// rme::json brings rme::rme and nlohmann-json with it: a file that holds no network is refused.
#include <rme/network/json.hpp>
#include <rme/rme.hpp>
#include <stdexcept>

int main() {
  try {
    (void)rme::model_from_json<double>(nlohmann::json::object());
  } catch (const std::invalid_argument&) {
    return rme::Payload<double>().mass == 0.0 ? 0 : 1;
  }
  return 1;
}
