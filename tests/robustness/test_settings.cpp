#include <cmath>
#include <functional>
#include <limits>
#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/mean_field.hpp>
#include <rme/inference/stochastic_vi.hpp>
#include <rme/rme.hpp>
#include <rme/sensing/mismatch_detector.hpp>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/held_arm.hpp"

namespace {

using rme::testing::HeldArm;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPeriod = HeldArm::kPeriod;

/// One number of a configuration.
struct Leaf {
  std::string field;  ///< its name in the struct
  std::function<void(double)> set;
};

/// All numbers of the estimator's settings; `observer_bandwidth` may be 0.
std::vector<Leaf> leaves_of(rme::EstimatorConfig<double, 7>& c) {
  if (!c.arm) c.arm = rme::ArmPrior<double, 7>::of(3);
  if (!c.payload) c.payload = rme::PayloadPrior<double>::of(3);
  auto& arm = *c.arm;
  auto& payload = *c.payload;
  const auto sign = [&c](double x) { c.torque_sign = static_cast<rme::TorqueSign>(std::abs(x) < 1e9 ? int(x) : 0); };
  return {{"EstimatorConfig::gravity", [&](double x) { c.gravity[1] = x; }},
          {"EstimatorConfig::torque_sign", sign},
          {"EstimatorConfig::rated_payload", [&](double x) { c.rated_payload = x; }},
          {"EstimatorConfig::observer_bandwidth", [&](double x) { c.observer_bandwidth = x; }},
          {"EstimatorConfig::contact_false_alarms", [&](double x) { c.contact_false_alarms = x; }},
          {"ArmPrior::noise", [&](double x) { arm.noise[1] = x; }},
          {"ArmPrior::offset", [&](double x) { arm.offset[6] = x; }},
          {"ArmPrior::residual", [&](double x) { arm.residual[1] = x; }},
          {"ArmPrior::coulomb", [&](double x) { arm.coulomb[0] = x; }},
          {"ArmPrior::viscous", [&](double x) { arm.viscous[1] = x; }},
          {"ArmPrior::friction_std", [&](double x) { arm.friction_std = x; }},
          {"PayloadPrior::mass_mean", [&](double x) { payload.mass_mean = x; }},
          {"PayloadPrior::mass_std", [&](double x) { payload.mass_std = x; }},
          {"PayloadPrior::com_mean", [&](double x) { payload.com_mean[1] = x; }},
          {"PayloadPrior::com_std", [&](double x) { payload.com_std[2] = x; }}};
}

TEST_CASE("EstimatorConfig: whatever a field may hold, it is refused by name or works", "[robustness]") {
  const double dt = 0.01;  // few ticks
  for (const double value : {kNan, kInfinity, -kInfinity, -1.0, 0.0, 1e-310, 1e-30, 1e-3, 1e5, 1e300}) {
    rme::EstimatorConfig<double, 7> config;
    const std::size_t count = leaves_of(config).size();
    for (std::size_t leaf = 0; leaf < count; ++leaf) {
      rme::EstimatorConfig<double, 7> changed;
      const auto leaves = leaves_of(changed);
      leaves[leaf].set(value);
      const std::string& field = leaves[leaf].field;
      CAPTURE(field, value);
      try {
        rme::Estimator<double, 7> estimator(dt, changed);
        CHECK(std::isfinite(value));
        HeldArm arm(41);
        for (int k = 0; k < 1000; ++k) {
          if (k == 500) arm.hold({1.1, {0.05, 0.02, 0.13}});
          const auto& tick = arm.tick();
          if (k % 10 != 0) continue;
          REQUIRE(estimator.update(tick) == rme::Status::Ok);
          REQUIRE(estimator.compensation(tick.jacobian, tick.rotation).allFinite());
          REQUIRE(estimator.state().payload.mean.allFinite());
          REQUIRE(estimator.state().payload.covariance.allFinite());
          REQUIRE(estimator.state().payload.mean[0] >= 0);
        }
      } catch (const std::invalid_argument& error) {
        // A rated payload below the mass that is said to be likely is refused by the other's name.
        const std::string message = error.what();
        const bool named = message.find(field) != std::string::npos ||
                           (leaf == 2 && message.find("PayloadPrior::mass_mean") != std::string::npos);
        CAPTURE(message);
        CHECK(named);
        CHECK_THAT(message, contains(": expected ") && contains(", got "));
      }
    }
  }
}

/// Refused by name for each of `values`, whatever the other fields.
template <typename Construct>
void check_refused(const char* field, std::initializer_list<double> values, const Construct& construct) {
  for (const double value : values) {
    CAPTURE(field, value);
    CHECK_THROWS_WITH(construct(value), contains(field) && contains(": expected ") && contains(", got "));
  }
}

TEST_CASE("Settings: what a loop is made of refuses numbers out of range by name", "[robustness]") {
  const auto not_positive = {0.0, -1.0, kNan, kInfinity, -kInfinity};
  const auto not_finite = {kNan, kInfinity, -kInfinity};
  using Vector7 = rme::JointVector<double, 7>;

  check_refused("MismatchDetector::dt", not_positive, [](double x) { rme::MismatchDetector<7>{x}; });
  check_refused("MomentumObserver::dt", not_positive, [](double x) { rme::MomentumObserver<double, 7>{x}; });
  check_refused("CompensationRamp::period", not_positive, [](double x) { rme::CompensationRamp<double, 7>{x}; });
  check_refused("EnergyTank::period", not_positive, [](double x) { rme::EnergyTank<double, 7>{x}; });
  check_refused("PassivityMonitor::period", not_positive, [](double x) { rme::PassivityMonitor<double>{x}; });
  check_refused("Estimator::dt", not_positive, [](double x) { rme::Estimator<double, 7>{x}; });

  check_refused("MomentumObserverConfig::gain", not_positive, [](double x) {
    rme::MomentumObserverConfig<double, 7> config;
    config.gain[6] = x;
    rme::MomentumObserver<double, 7>(kPeriod, config);
  });
  check_refused("CompensationRampConfig::torque_rate", {0.0, -1.0, kNan, 1e-322}, [](double x) {
    rme::CompensationRampConfig<double, 7> config;
    config.torque_rate[3] = x;
    rme::CompensationRamp<double, 7>(kPeriod, config);
  });
  check_refused("EnergyTankConfig::capacity", not_positive, [](double x) {
    rme::EnergyTank<double, 7>(kPeriod, {x, 0, 1e-9});
  });
  check_refused("EnergyTankConfig::initial", {-1.0, 13.0, kNan, kInfinity}, [](double x) {
    rme::EnergyTank<double, 7>(kPeriod, {12, x, 2});
  });
  check_refused("EnergyTankConfig::reserve", {0.0, -1.0, 13.0, kNan, kInfinity}, [](double x) {
    rme::EnergyTank<double, 7>(kPeriod, {12, 12, x});
  });

  check_refused("BarrierPoles::first", not_positive, [](double x) { rme::BarrierPoles<double>(x, 1); });
  check_refused("BarrierPoles::second", not_positive, [](double x) { rme::BarrierPoles<double>(1, x); });
  const rme::JointLimitsConfig<double, 7> limits{Vector7::Constant(-2), Vector7::Constant(2)};
  const auto with_limits = [&](auto change) {
    auto config = limits;
    change(config);
    rme::JointLimits<double, 7>{config};
  };
  check_refused("JointLimitsConfig::q_min", {2.0, 3.0, kNan, kInfinity},
                [&](double x) { with_limits([=](auto& c) { c.q_min[2] = x; }); });
  check_refused("JointLimitsConfig::q_min", {-2.0, -3.0, kNan, -kInfinity},
                [&](double x) { with_limits([=](auto& c) { c.q_max[2] = x; }); });
  check_refused("JointLimitsConfig::velocity_limit", {0.0, -1.0, kNan},
                [&](double x) { with_limits([=](auto& c) { c.velocity_limit[2] = x; }); });
  check_refused("JointLimitsConfig::velocity_pole", not_positive,
                [&](double x) { with_limits([=](auto& c) { c.velocity_pole = x; }); });
  check_refused("JointLimitsConfig::weight", {0.0, -1.0, kNan},
                [&](double x) { with_limits([=](auto& c) { c.weight = x; }); });

  const auto with_cpic = [](auto change) {
    rme::CpicConfig<double, 7> config;
    config.torque_limit.setConstant(87);
    change(config);
    rme::Cpic<double, 7>{config};
  };
  check_refused("CpicConfig::torque_limit", {0.0, -1.0, kNan},
                [&](double x) { with_cpic([=](auto& c) { c.torque_limit[5] = x; }); });
  check_refused("CpicConfig::null_space_weight", not_positive,
                [&](double x) { with_cpic([=](auto& c) { c.null_space_weight = x; }); });
  check_refused("CpicConfig::moment_arm", not_positive,
                [&](double x) { with_cpic([=](auto& c) { c.moment_arm = x; }); });
  check_refused("NullSpaceConfig::clearance", not_positive,
                [&](double x) { with_cpic([=](auto& c) { c.null_space.clearance = x; }); });
  check_refused("NullSpaceConfig::damping", not_positive,
                [&](double x) { with_cpic([=](auto& c) { c.null_space.damping = x; }); });

  const auto with_damping = [](auto change) {
    rme::PassiveControllerConfig<double> config;
    change(config);
    rme::PassiveController<double>{config};
  };
  check_refused("DirectionalDamping::along", not_positive,
                [&](double x) { with_damping([=](auto& c) { c.linear.along = x; }); });
  check_refused("DirectionalDamping::across", not_positive,
                [&](double x) { with_damping([=](auto& c) { c.angular.across = x; }); });
  check_refused("DirectionalDamping::blend", not_positive,
                [&](double x) { with_damping([=](auto& c) { c.angular.blend = x; }); });

  check_refused("LinearAttractorConfig::target", not_finite, [](double x) {
    rme::LinearAttractor<double>({{0, x, 0}, 1, 0.5});
  });
  check_refused("LinearAttractorConfig::gain", not_positive, [](double x) {
    rme::LinearAttractor<double>({{0, 0, 0}, x, 0.5});
  });
  check_refused("LinearAttractorConfig::max_speed", {0.0, -1.0, kNan}, [](double x) {
    rme::LinearAttractor<double>({{0, 0, 0}, 1, x});
  });
  const auto with_cycle = [](auto change) {
    rme::LimitCycleConfig<double> config;
    change(config);
    rme::LimitCycle<double>{config};
  };
  check_refused("LimitCycleConfig::center", not_finite,
                [&](double x) { with_cycle([=](auto& c) { c.center[1] = x; }); });
  check_refused("LimitCycleConfig::normal", {0.0, kNan, kInfinity},
                [&](double x) { with_cycle([=](auto& c) { c.normal = x * Eigen::Vector3d::Ones(); }); });
  check_refused("LimitCycleConfig::radius", not_positive,
                [&](double x) { with_cycle([=](auto& c) { c.radius = x; }); });
  check_refused("LimitCycleConfig::angular_speed", not_finite,
                [&](double x) { with_cycle([=](auto& c) { c.angular_speed = x; }); });
  check_refused("LimitCycleConfig::gain", not_positive, [&](double x) { with_cycle([=](auto& c) { c.gain = x; }); });
  check_refused("OrientationAttractorConfig::gain", not_positive, [](double x) {
    rme::OrientationAttractor<double>({Eigen::Quaterniond::Identity(), x});
  });
  check_refused("OrientationAttractorConfig::target", {0.0, 1.1, kNan, kInfinity}, [](double x) {
    rme::OrientationAttractor<double>({Eigen::Quaterniond(x, 0, 0, 0), 2});
  });

  const auto with_posture = [](auto change) {
    rme::PostureConfig<double, 7> config;
    change(config);
    rme::Posture<double, 7>{config};
  };
  check_refused("PostureConfig::rest", not_finite, [&](double x) { with_posture([=](auto& c) { c.rest[4] = x; }); });
  check_refused("PostureConfig::stiffness", {-1.0, kNan, kInfinity},
                [&](double x) { with_posture([=](auto& c) { c.stiffness = x; }); });
  check_refused("PostureConfig::damping", {-1.0, kNan, kInfinity},
                [&](double x) { with_posture([=](auto& c) { c.damping = x; }); });
}

}  // namespace
