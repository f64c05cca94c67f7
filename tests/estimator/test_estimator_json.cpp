#include <rme/estimator.hpp>
#include <rme/estimator_json.hpp>
#include <string>

#include "support/catch.hpp"

namespace {

using Config = rme::EstimatorConfig<double, 7>;
using nlohmann::json;

Config read(const char* text) {
  return rme::estimator_config_from_json<double, 7>(json::parse(text));
}

TEST_CASE("EstimatorConfig: what is written comes back the same", "[json]") {
  Config config;
  config.gravity = {9.81, 0, 0};
  config.torque_sign = rme::TorqueSign::Reaction;
  config.rated_payload = 12.5;
  config.observer_bandwidth = 30;
  config.contact_false_alarms = 2;
  config.sensing = rme::Sensing::JointFriction;
  config.arm = rme::ArmPrior<double, 7>::of(10);
  config.arm->noise << 1, 2, 3, 4, 5, 6, 7;
  config.arm->viscous[3] = 0.7;
  config.arm->friction_std = 0.2;
  config.payload = rme::PayloadPrior<double>::of(10);
  config.payload->mass_std = 4;
  config.payload->com_mean = {0.01, 0.02, 0.3};
  const json written = rme::estimator_config_to_json(config);
  const Config back = rme::estimator_config_from_json<double, 7>(json::parse(written.dump()));
  CHECK(back.gravity == config.gravity);
  CHECK(back.torque_sign == config.torque_sign);
  CHECK(back.rated_payload == config.rated_payload);
  CHECK(back.observer_bandwidth == config.observer_bandwidth);
  CHECK(back.contact_false_alarms == config.contact_false_alarms);
  CHECK(back.sensing == config.sensing);
  REQUIRE(back.arm);
  CHECK(back.arm->noise == config.arm->noise);
  CHECK(back.arm->offset == config.arm->offset);
  CHECK(back.arm->residual == config.arm->residual);
  CHECK(back.arm->coulomb == config.arm->coulomb);
  CHECK(back.arm->viscous == config.arm->viscous);
  CHECK(back.arm->friction_std == 0.2);
  REQUIRE(back.payload);
  CHECK(back.payload->mass_mean == config.payload->mass_mean);
  CHECK(back.payload->mass_std == config.payload->mass_std);
  CHECK(back.payload->com_mean == config.payload->com_mean);
  CHECK(back.payload->com_std == config.payload->com_std);
  CHECK(rme::estimator_config_to_json(back) == written);
}

TEST_CASE("EstimatorConfig: of an arm whose joints are counted at run time, vectors come as long as they are",
          "[json]") {
  constexpr int kAny = Eigen::Dynamic;
  Config config;
  config.arm = rme::ArmPrior<double, 7>::of(10);
  const json written = rme::estimator_config_to_json(config);
  const auto back = rme::estimator_config_from_json<double, kAny>(written);
  REQUIRE(back.arm);
  CHECK(back.arm->noise == config.arm->noise);
  CHECK(back.arm->viscous == config.arm->viscous);
  CHECK(rme::estimator_config_to_json(back) == written);
  json bad = written;
  bad["arm"]["offset"] = 3;
  CHECK_THROWS_WITH((rme::estimator_config_from_json<double, kAny>(bad)),
                    contains("arm.offset: expected an array of numbers, got"));
}

TEST_CASE("EstimatorConfig: a field that is not there keeps its default, and is not written if it has none", "[json]") {
  const Config config = read(R"({"rated_payload": 5, "observer_bandwidth": 0})"), defaults;
  CHECK(config.rated_payload == 5);
  CHECK(config.observer_bandwidth == 0);
  CHECK(config.gravity == defaults.gravity);
  CHECK(config.torque_sign == defaults.torque_sign);
  CHECK(config.sensing == defaults.sensing);
  CHECK_FALSE(config.arm);
  CHECK_FALSE(config.payload);
  const json written = rme::estimator_config_to_json(defaults);
  CHECK_FALSE(written.contains("arm"));
  CHECK_FALSE(written.contains("payload"));
  CHECK(written.size() == 6);
  CHECK(rme::estimator_config_to_json(read("{}")) == written);
}

TEST_CASE(
    "EstimatorConfig: a field that is not there is that of the settings which the host has, others take its place",
    "[json]") {
  Config host;
  host.torque_sign = rme::TorqueSign::Reaction;
  host.rated_payload = 7;
  host.observer_bandwidth = 30;
  host.sensing = rme::Sensing::LinkSide;
  host.arm = rme::ArmPrior<double, 7>::of(2);
  const Config config = rme::estimator_config_from_json<double, 7>(
      json::parse(R"({"observer_bandwidth": 25, "sensing": "unknown"})"), host);
  CHECK(config.torque_sign == rme::TorqueSign::Reaction);
  CHECK(config.rated_payload == 7);
  CHECK(config.observer_bandwidth == 25);
  CHECK_FALSE(config.sensing);
  REQUIRE(config.arm);
  CHECK(config.arm->noise == host.arm->noise);
}

TEST_CASE("EstimatorConfig: enumerators are their names", "[json]") {
  CHECK(read(R"({"torque_sign": "external"})").torque_sign == rme::TorqueSign::External);
  CHECK(read(R"({"torque_sign": "reaction"})").torque_sign == rme::TorqueSign::Reaction);
  CHECK(read(R"({"sensing": "unknown"})").sensing == std::nullopt);
  CHECK(read(R"({"sensing": "link_side"})").sensing == rme::Sensing::LinkSide);
  CHECK(read(R"({"sensing": "joint_friction"})").sensing == rme::Sensing::JointFriction);
  CHECK(read(R"({"sensing": "rough_model"})").sensing == rme::Sensing::RoughModel);
  Config config;
  config.sensing = rme::Sensing::LinkSide;
  CHECK(rme::estimator_config_to_json(config)["sensing"] == "link_side");
  CHECK(rme::estimator_config_to_json(config)["torque_sign"] == "external");
  CHECK_THROWS_WITH(read(R"({"torque_sign": "up"})"),
                    contains("torque_sign") && contains("\"external\", \"reaction\"") && contains("\"up\""));
  CHECK_THROWS_WITH(read(R"({"sensing": "motor"})"), contains("sensing") && contains("\"joint_friction\""));
  CHECK_THROWS_WITH(read(R"({"sensing": 1})"), contains("sensing") && contains("got 1"));
}

TEST_CASE("EstimatorConfig: a wrong field is refused by its path, with what was expected and what came", "[json]") {
  CHECK_THROWS_WITH(read(R"({"rated_paylod": 1})"), contains("rated_paylod: unknown field"));
  CHECK_THROWS_WITH(read(R"({"rated_payload": "3"})"), contains("rated_payload: expected a number, got \"3\""));
  CHECK_THROWS_WITH(read(R"({"rated_payload": null})"), contains("rated_payload: expected a number"));
  CHECK_THROWS_WITH(read(R"({"gravity": [1, 2]})"), contains("gravity: expected an array of 3 numbers"));
  CHECK_THROWS_WITH(read(R"({"gravity": 9.81})"), contains("gravity: expected an array of 3 numbers, got 9.81"));
  CHECK_THROWS_WITH(read(R"({"gravity": [1, 2, "z"]})"), contains("gravity[2]: expected a number"));
  CHECK_THROWS_WITH(read(R"({"arm": 1})"), contains("arm: expected an object, got 1"));
  CHECK_THROWS_WITH(read(R"({"arm": {"nose": 1}})"), contains("arm.nose: unknown field"));
  CHECK_THROWS_WITH(read(R"({"payload": {"mass_mean": "x"}})"), contains("payload.mass_mean: expected a number"));
  CHECK_THROWS_WITH(read(R"({"payload": {"mass": 1}})"), contains("payload.mass: unknown field"));
  CHECK_THROWS_WITH(read("[1]"), contains("the settings: expected an object"));
  CHECK_THROWS_WITH(read("3"), contains("the settings: expected an object"));
  // What a float cannot hold.
  CHECK_THROWS_WITH((rme::estimator_config_from_json<float, 7>(json::parse(R"({"gravity": [0, 0, -1e39]})"))),
                    contains("gravity[2]"));
}

TEST_CASE("EstimatorConfig: of arm and payload every field but friction_std is needed, in full size", "[json]") {
  Config config;
  config.arm = rme::ArmPrior<double, 7>::of(3);
  config.payload = rme::PayloadPrior<double>::of(3);
  const json whole = rme::estimator_config_to_json(config);
  for (const std::string part : {"arm", "payload"}) {
    for (const auto& [key, value] : whole[part].items()) {
      CAPTURE(part, key);
      json without = whole;
      without[part].erase(key);
      if (key == "friction_std") {
        CHECK(rme::estimator_config_from_json<double, 7>(without).arm->friction_std == 0.5);
        without[part][key] = "half";
        CHECK_THROWS_WITH((rme::estimator_config_from_json<double, 7>(without)),
                          contains("arm.friction_std: expected a number"));
        continue;
      }
      CHECK_THROWS_WITH((rme::estimator_config_from_json<double, 7>(without)),
                        contains(part + "." + key + ": missing"));
      if (!value.is_array()) continue;
      json shorter = whole;
      shorter[part][key].erase(0);
      CHECK_THROWS_WITH((rme::estimator_config_from_json<double, 7>(shorter)),
                        contains(part + "." + key + ": expected an array of " + std::to_string(value.size())));
    }
  }
  // An arm of seven joints is not one of six.
  CHECK_THROWS_WITH((rme::estimator_config_from_json<double, 6>(whole)), contains("arm.noise"));
}

/// What the Estimator says to settings that can be read.
std::string refusal(const json& object) {
  try {
    const rme::Estimator<double, 7> estimator(1e-3, rme::estimator_config_from_json<double, 7>(object));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("EstimatorConfig: ranges are checked by the Estimator, by name", "[json]") {
  CHECK(refusal(json::object()).empty());
  for (const double bad : {0.0, -1.0, 1e5}) {
    CAPTURE(bad);
    CHECK_THAT(refusal({{"rated_payload", bad}}), contains("EstimatorConfig::rated_payload"));
  }
  for (const double bad : {-1.0, 0.5, 1e6}) {
    CAPTURE(bad);
    CHECK_THAT(refusal({{"observer_bandwidth", bad}}), contains("EstimatorConfig::observer_bandwidth"));
  }
  CHECK(refusal({{"observer_bandwidth", 0}}).empty());
  CHECK_THAT(refusal({{"gravity", {0, 0, 0}}}), contains("EstimatorConfig::gravity"));
  CHECK_THAT(refusal({{"gravity", {0, 0, 1e9}}}), contains("EstimatorConfig::gravity"));
  Config config;
  config.arm = rme::ArmPrior<double, 7>::of(3);
  config.payload = rme::PayloadPrior<double>::of(3);
  const json whole = rme::estimator_config_to_json(config);
  CHECK(refusal(whole).empty());
  for (const double bad : {0.0, -1.0}) {
    for (const auto& [key, value] : whole["arm"].items()) {
      CAPTURE(key, bad);
      json wrong = whole;
      (value.is_array() ? wrong["arm"][key][3] : wrong["arm"][key]) = bad;
      CHECK_THAT(refusal(wrong), contains("ArmPrior::" + key));
    }
    json wrong = whole;
    wrong["payload"]["mass_std"] = bad;
    CHECK_THAT(refusal(wrong), contains("PayloadPrior::mass_std"));
    wrong = whole;
    wrong["payload"]["com_std"][1] = bad;
    CHECK_THAT(refusal(wrong), contains("PayloadPrior::com_std"));
  }
  for (const double bad : {-0.1, 3.1}) {
    json wrong = whole;
    wrong["payload"]["mass_mean"] = bad;
    CHECK_THAT(refusal(wrong), contains("PayloadPrior::mass_mean"));
  }
  json wrong = whole;
  wrong["payload"]["com_mean"][2] = 1e9;
  CHECK_THAT(refusal(wrong), contains("PayloadPrior::com_mean"));
  for (const double bad : {0.0, -1e-3, 0.101}) {
    CAPTURE(bad);
    CHECK_THROWS_WITH((rme::Estimator<double, 7>(bad)), contains("Estimator::dt"));
  }
}

}  // namespace
