#include <filesystem>
#include <fstream>
#include <replay_log/settings_model.hpp>
#include <string>

#include "support/catch.hpp"

namespace {

using namespace rme::examples;

const std::string kFolder = RME_TEST_DATA "/urdf";
const std::string kSettings = kFolder + "/settings.json";  // is not read: says where the URDF is

nlohmann::json model() {
  return model_to_json(read_urdf(kFolder + "/six_joints_5kg.urdf", "base_link", "tool0"), "six_joints_5kg.urdf",
                       {1, 2, 3, 4, 5, 6}, {0, 0.1, 0.2, 0, 0, 0});
}
ArmRequest six_joints() {
  ArmRequest request;
  request.chain = read_urdf(kFolder + "/six_joints_10kg.urdf", "world", "tool0");
  request.chain->base = "base_link";
  return request;
}

TEST_CASE("use_model: the arm is that of the settings, with what else the command line said", "[settings_model]") {
  ArmRequest request = six_joints();
  request.rated_payload = 7;
  CHECK_THAT(use_model(model(), kSettings, request), contains("six_joints_5kg.urdf"));
  REQUIRE(request.chain);
  CHECK(request.chain->links[1].body.mass ==
        read_urdf(kFolder + "/six_joints_5kg.urdf", "base_link", "tool0").links[1].body.mass);
  CHECK(request.rotor_inertia == std::vector<double>{1, 2, 3, 4, 5, 6});
  CHECK(request.load_friction == std::vector<double>{0, 0.1, 0.2, 0, 0, 0});
  CHECK(request.rated_payload == 7.0);
  ArmRequest other = six_joints();
  other.rotor_inertia = {9, 9, 9, 9, 9, 9};  // --rotor-inertia
  use_model(model(), kSettings, other);
  CHECK(other.rotor_inertia == std::vector<double>{9, 9, 9, 9, 9, 9});
}

TEST_CASE("use_model: what is no model, or another arm's, is refused by name", "[settings_model]") {
  const auto refused = [](const nlohmann::json& json, ArmRequest request, const std::string& why) {
    CAPTURE(why);
    try {
      use_model(json, kSettings, request);
      FAIL("was taken");
    } catch (const ArgumentError& error) {
      CHECK_THAT(error.what(), contains(kSettings + ": model" + why));
    }
  };
  const auto with = [](const char* key, const nlohmann::json& value) {
    nlohmann::json json = model();
    json[key] = value;
    return json;
  };
  nlohmann::json without = model();
  without.erase("urdf");
  refused(3, six_joints(), ": expected an object, got");
  refused(without, six_joints(), ".urdf: missing");
  refused(with("tip", 1), six_joints(), ".tip: expected a string, got");
  refused(with("links", 1), six_joints(), ".links: unknown field");
  refused(with("rotor_inertia", {1, 2, 3}), six_joints(), ".rotor_inertia: expected an array of 6 numbers >= 0");
  refused(with("load_friction", {0, 0, -1, 0, 0, 0}), six_joints(), ".load_friction: expected an array of 6");
  refused(model(), ArmRequest(), ": has 6 joints, the arm has 7");
  refused(with("tip", "flange"), six_joints(),
          ": is from base_link to flange, the command line's arm from base_link to tool0");
  ArmRequest request = six_joints();
  CHECK_THROWS_AS(use_model(with("urdf", "none.urdf"), kSettings, request), UrdfError);
}

}  // namespace
