#pragma once
/// --physics: which physics moves the Panda of a program.
#include <io/arguments.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

namespace rme::examples {

enum class Engine {
  Synthetic,  ///< examples/synthetic_arm
  Mujoco,     ///< where it was found when this was built
};

/// MuJoCo if it was found.
Engine independent_engine() noexcept;

/// Takes --physics.
/// @param usual  without the option
/// @throws ArgumentError if there is no such physics, or it was not found
Engine parse_engine(Arguments& arguments, Engine usual = Engine::Synthetic);

/// Has the arm moved by it, in steps that are short enough for it.
void use_engine(Engine engine, SyntheticArmConfig<7>& arm);

}  // namespace rme::examples
