#pragma once
/// What the mains of the example programs have in common.
#include <string_view>

#include "io/arguments.hpp"

namespace rme::examples {

/// Runs a program: answers --help with its usage, and prints what it throws, with the usage if the command line is
/// wrong.
/// @return its exit code: 0, or 1 if what it found is not what it should have found; 2 for an ArgumentError; 3 for any
///         other exception, such as a file that cannot be read
int run_program(const char* name, std::string_view usage, int argc, char** argv, int (*run)(Arguments&));

}  // namespace rme::examples
