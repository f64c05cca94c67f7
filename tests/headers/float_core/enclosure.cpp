#include <rme/inference/payload_enclosure.hpp>

#include "headers/float_core/float_core.hpp"
#include "support/random_events.hpp"

namespace float_core {
namespace {

bool no_truth_is_outside() {
  Random random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  rme::PayloadEnclosureConfig<float, 7> config;
  config.drift.setConstant(0.05F);
  config.mass_limit = 3;
  config.com_lower.setConstant(-0.3F);
  config.com_upper.setConstant(0.3F);
  rme::PayloadEnclosure<float, 7, 1> enclosure(config);
  for (int k = 0; k < 200; ++k) {
    const auto pose = rme::testing::random_pose(random);
    const auto exact = rme::payload_regressor<double, 7>(pose.jacobian, pose.rotation, rme::standard_gravity<double>());
    rme::Payload<double> truth;
    truth.mass = 1.1 + u(random);
    for (int i = 0; i < 3; ++i) truth.com[i] = 0.25 * u(random);
    rme::JointVector<double, 7> before, after = exact.torque(truth);
    for (int j = 0; j < 7; ++j) {
      before[j] = u(random);
      after[j] += before[j] + (u(random) > 0 ? 0.05 : -0.05);
    }
    enclosure.clear();
    const rme::PayloadRegressor<float, 7> regressor{exact.a.cast<float>(), exact.B.cast<float>()};
    rme::PayloadBox<float> box;
    if (enclosure.add_change(before.cast<float>(), after.cast<float>(), regressor) != Status::Ok) return false;
    if (enclosure.solve(box) != Status::Ok) return false;
    const auto in = [](double x, float lower, float upper) { return double(lower) <= x && x <= double(upper); };
    if (!in(truth.mass, box.mass_lower, box.mass_upper)) return false;
    for (int i = 0; i < 3; ++i)
      if (!in(truth.com[i], box.com_lower[i], box.com_upper[i])) return false;
  }
  return true;
}

bool a_violated_bound_is_reported() {
  rme::PayloadEnclosureConfig<float, 2> config;
  config.drift.setOnes();
  rme::PayloadEnclosure<float, 2, 1> enclosure(config);
  rme::PayloadRegressor<float, 2> regressor;
  regressor.a << 10, 20;
  using Torque = Eigen::Vector2f;
  rme::PayloadBox<float> box;
  // |10 - 10 m| <= s and |24 - 20 m| <= s meet at s = 4/3.
  return enclosure.add_change(Torque(0, 0), Torque(10, 24), regressor) == Status::Ok &&
         enclosure.solve(box) == Status::Infeasible && near(box.scale, 4.0F / 3, 1e-5);
}

}  // namespace

const std::vector<Case> kEnclosure = {
    {"PayloadEnclosure: no truth is outside", no_truth_is_outside},
    {"PayloadEnclosure: a violated bound is reported", a_violated_bound_is_reported},
};

}  // namespace float_core
