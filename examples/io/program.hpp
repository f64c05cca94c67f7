#pragma once
/// What the mains of the example programs have in common.
#include "io/arguments.hpp"

namespace rme::examples {

/// Runs a program: answers --help with its usage, and prints what it throws, with the usage if the command line is
/// wrong.
/// @return its exit code; 2 for an ArgumentError, 1 for every other exception
int run_program(const char* name, const char* usage, int argc, char** argv, int (*run)(Arguments&));

}  // namespace rme::examples
