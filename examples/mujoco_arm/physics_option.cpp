#include <mujoco_arm/physics_option.hpp>

#ifdef RME_HAS_MUJOCO
#include <mujoco_arm/mujoco_physics.hpp>
#endif

namespace rme::examples {

Engine independent_engine() noexcept {
#ifdef RME_HAS_MUJOCO
  return Engine::Mujoco;
#else
  return Engine::Synthetic;
#endif
}

Engine parse_engine(Arguments& arguments, Engine usual) {
  const Engine engine =
      arguments.choice<Engine>("--physics", {{"synthetic", Engine::Synthetic}, {"mujoco", Engine::Mujoco}})
          .value_or(usual);
  if (engine == Engine::Mujoco && independent_engine() != Engine::Mujoco)
    throw ArgumentError("--physics: MuJoCo was not found when this was built (Debian: libmujoco-dev)");
  return engine;
}

void use_engine([[maybe_unused]] Engine engine, [[maybe_unused]] SyntheticArmConfig<7>& arm) {
#ifdef RME_HAS_MUJOCO
  if (engine != Engine::Mujoco) return;
  arm.physics = MujocoPhysics<7>::make;
  arm.substeps = 4;
#endif
}

}  // namespace rme::examples
