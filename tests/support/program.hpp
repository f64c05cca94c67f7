#pragma once
/// Programs as their users run them.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "support/catch.hpp"

namespace rme::testing {

/// A file in the current folder for as long as the test runs.
struct TemporaryFile {
  // The process's number keeps tests apart that ctest runs at the same time.
  TemporaryFile(const std::string& file_name, const std::string& content)
      : name(std::to_string(::getpid()) + "_" + file_name) {
    std::ofstream(name, std::ios::binary) << content;
  }
  ~TemporaryFile() { std::remove(name.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string name;
};

enum class Stream { Output, Errors };

struct Result {
  int exit_code;
  std::string text;  ///< of the one stream asked for
};

inline Result run(const std::string& program, const std::string& arguments, Stream kept) {
  const std::string command =
      "\"" + program + "\" " + arguments + (kept == Stream::Output ? " 2>/dev/null" : " 2>&1 >/dev/null");
  FILE* pipe = popen(command.c_str(), "r");
  REQUIRE(pipe != nullptr);
  Result result{};
  char buffer[4096];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;) result.text.append(buffer, n);
  const int status = pclose(pipe);
  REQUIRE(WIFEXITED(status));
  result.exit_code = WEXITSTATUS(status);
  return result;
}

}  // namespace rme::testing
