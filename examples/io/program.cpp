#include "io/program.hpp"

#include <cstdio>
#include <exception>

namespace rme::examples {

int run_program(const char* name, std::string_view usage, int argc, char** argv, int (*run)(Arguments&)) {
  for (int i = 1; i < argc; ++i) {
    if (const std::string word = argv[i]; word == "--help" || word == "-h") {
      std::printf("%.*s", static_cast<int>(usage.size()), usage.data());
      return 0;
    }
  }
  try {
    Arguments arguments(argc, argv);
    return run(arguments);
  } catch (const ArgumentError& error) {
    std::fprintf(stderr, "%s: %s\n\n%.*s", name, error.what(), static_cast<int>(usage.size()), usage.data());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 3;
  }
}

}  // namespace rme::examples
