// 00_hello: the hand of a resting arm is given 1.1 kg. Which mass and centre of mass does rme estimate, and how certain
// are they? A simulated Panda stands in for your robot; the block in the middle belongs in your control loop.
#include <cstdio>
#include <rme/estimator.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

int main() {
  using namespace rme::examples;
  SyntheticArmConfig<7> faults = with_typical_faults(panda(), 1);  // noise and offsets of torque sensors
  faults.friction = {};                                            // that sit behind the gears
  SyntheticArm<7> arm(panda(), faults, panda().ready);
  const PoseImpedance<7> controller(panda(), panda().ready);  // its model has no payload
  rme::Estimator<double, 7> estimator(0.001);                 // period [s]

  std::printf("time [s]     mass [kg]     centre of mass x, y, z [mm]\n");
  for (int tick = 0; tick <= 3000; ++tick) {
    if (tick == 1000) arm.attach(box(1.1, {0.05, 0.02, 0.13}, {0.06, 0.06, 0.1}));

    const auto& [position, rotation, jacobian] = arm.kinematics();
    const rme::Status status = estimator.update({arm.tau_ext(), jacobian, rotation, arm.dq()});
    if (status != rme::Status::Ok) return 1;
    const auto nominal = controller.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics());
    arm.step(nominal + estimator.compensation(jacobian, rotation));

    if (tick % 500 != 0) continue;
    const auto mean = estimator.state().payload.mean, std = estimator.state().payload.standard_deviation();
    std::printf("%8.1f %6.3f +- %.3f", tick * 1e-3, mean[0], std[0]);
    for (int i = 1; i < 4; ++i) std::printf("   %5.1f +- %4.1f", 1e3 * mean[i], 1e3 * std[i]);
    std::printf("\n");
  }
}
