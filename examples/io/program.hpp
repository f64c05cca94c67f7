#pragma once
/// The part of main() that the example programs share.
#include <string_view>

#include "io/arguments.hpp"

namespace rme::examples {

/// Runs a program. For --help it prints the usage. If `run` throws, it prints the message, and for an ArgumentError the
/// usage as well.
/// @return exit code: what `run` returns (0, or 1 if a result misses its target); 2 for an ArgumentError; 3 for any
///         other exception, such as a file that cannot be read
int run_program(const char* name, std::string_view usage, int argc, char** argv, int (*run)(Arguments&));

}  // namespace rme::examples
