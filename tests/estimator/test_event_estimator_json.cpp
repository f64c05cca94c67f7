#include <rme/event_estimator_json.hpp>
#include <string>
#include <utility>

#include "support/catch.hpp"

namespace {

using Config = rme::EventEstimatorConfig<double, 7>;
using nlohmann::json;

Config read(const char* text) {
  return rme::event_estimator_config_from_json<double, 7>(json::parse(text));
}

TEST_CASE("estimator_config: what is written comes back the same", "[json]") {
  Config config;
  config.gravity = {9.81, 0, 0};
  config.torque_sign = rme::TorqueSign::Reaction;
  config.detector.check_age = {0.04, 0.1, 0.2};
  config.window.observer_bandwidth = 30;
  config.watch_norm = true;
  config.sensors.pop_back();
  config.sensors[0].noise << 1, 2, 3, 4, 5, 6, 7;
  config.inference.max_iterations = 17;
  const json written = rme::event_estimator_config_to_json(config);
  const Config back = rme::event_estimator_config_from_json<double, 7>(written);
  CHECK(back.gravity == config.gravity);
  CHECK(back.torque_sign == rme::TorqueSign::Reaction);
  CHECK(back.detector.check_age == config.detector.check_age);
  CHECK(back.window.observer_bandwidth == 30);
  CHECK(back.watch_norm);
  REQUIRE(back.sensors.size() == 1);
  CHECK(back.sensors[0].noise == config.sensors[0].noise);
  CHECK(back.inference.max_iterations == 17);
  CHECK(rme::event_estimator_config_to_json(back) == written);
}

TEST_CASE("estimator_config: a field that is not there keeps its default", "[json]") {
  const Config config = read(R"({"collection": 0.3, "window": {"duration": 2}, "sensors": ["joint_friction"]})");
  CHECK(config.collection == 0.3);
  CHECK(config.window.duration == 2);
  CHECK(config.window.observer_bandwidth == Config().window.observer_bandwidth);
  CHECK(config.baseline == Config().baseline);
  REQUIRE(config.sensors.size() == 1);
  CHECK(config.sensors[0].coulomb_mean == rme::SensorModel<double, 7>::joint_friction().coulomb_mean);
}

TEST_CASE("estimator_config: a sensor model may be a preset's name, and the torque's sign is a word", "[json]") {
  const Config config = read(R"({"sensors": ["link_side", "joint_friction"], "torque_sign": "external"})");
  REQUIRE(config.sensors.size() == 2);
  CHECK(config.sensors[0].coulomb_mean == rme::SensorModel<double, 7>::link_side().coulomb_mean);
  CHECK(config.sensors[1].coulomb_mean == rme::SensorModel<double, 7>::joint_friction().coulomb_mean);
  CHECK(config.torque_sign == rme::TorqueSign::External);
  CHECK(read(R"({"torque_sign": "reaction"})").torque_sign == rme::TorqueSign::Reaction);
}

TEST_CASE("estimator_config: a wrong field is refused by its path, with what was expected and what came", "[json]") {
  CHECK_THROWS_WITH(read(R"({"colection": 1})"), contains("colection") && contains("unknown"));
  CHECK_THROWS_WITH(read(R"({"window": {"duration": "x"}})"), contains("window.duration") && contains("a number"));
  CHECK_THROWS_WITH(read(R"({"window": {"durations": 1}})"), contains("window.durations"));
  CHECK_THROWS_WITH(read(R"({"gravity": [1, 2]})"),
                    contains("gravity") && contains("3 numbers") && contains("an array of 2"));
  CHECK_THROWS_WITH(read(R"({"gravity": [1, 2, null]})"), contains("gravity[2]") && contains("null"));
  CHECK_THROWS_WITH(read(R"({"torque_sign": "up"})"), contains("torque_sign") && contains("reaction"));
  CHECK_THROWS_WITH(read(R"({"watch_norm": 1})"), contains("watch_norm") && contains("true or false"));
  CHECK_THROWS_WITH(read(R"({"inference": {"max_iterations": 2.5}})"), contains("inference.max_iterations"));
  CHECK_THROWS_WITH(read(R"({"inference": {"max_iterations": 4294967297}})"), contains("inference.max_iterations"));
  CHECK_THROWS_WITH(read(R"({"sensors": []})"), contains("sensors"));
  CHECK_THROWS_WITH(read(R"({"sensors": ["link"]})"), contains("sensors[0]") && contains("\"link\""));
  CHECK_THROWS_WITH(read(R"({"sensors": [{"noise": [1, 1, 1, 1, 1, 1, 1]}]})"),
                    contains("sensors[0].noise_correlation_time") && contains("missing"));
  CHECK_THROWS_WITH(read("[1]"), contains("an object"));
  const std::string word(1000, 'x');
  CHECK_THROWS_WITH(read((R"({"torque_sign": ")" + word + R"("})").c_str()),
                    contains("got \"" + word.substr(0, 59) + "..."));
  const json too_large = json::parse(R"({"gravity": [0, 0, -1e39]})");
  CHECK_THROWS_WITH((rme::event_estimator_config_from_json<float, 7>(too_large)),
                    contains("gravity[2]") && contains("float"));
  // A hundred thousand brackets, which nothing may follow down.
  json deep = 1;
  for (int k = 0; k < 100000; ++k) deep = json::array({std::move(deep)});
  json holder;
  holder["odds"] = std::move(deep);
  CHECK_THROWS_WITH((rme::event_estimator_config_from_json<double, 7>(holder)), contains("an array of 1"));
}

TEST_CASE("estimator_config: what the file says is checked by the estimator, by name", "[json]") {
  const Config config = read(R"({"collection": -1})");
  CHECK_THROWS_WITH(config.validate(0.001), contains("EventEstimatorConfig::collection"));
}

}  // namespace
