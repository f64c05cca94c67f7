// rme::json brings rme::rme and nlohmann-json with it.
#include <nlohmann/json.hpp>
#include <rme/rme.hpp>

int main() {
  const auto payload = nlohmann::json::parse(R"({"mass": 1.5})");
  return rme::Payload<double>{payload.at("mass"), {0.0, 0.0, 0.0}}.vector()[0] == 1.5 ? 0 : 1;
}
