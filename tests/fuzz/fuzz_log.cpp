// Any bytes as a log: refused with the file's name and line, or a recording whose numbers are all there and finite.
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/check.hpp"
#include "io/log_reader.hpp"

namespace {

using fuzzing::check;

template <typename Vector>
void check_column(const std::vector<Vector>& column, std::size_t rows) {
  check(column.empty() || column.size() == rows);
  for (const Vector& v : column) check(v.allFinite());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto log = rme::examples::parse_log<2>({reinterpret_cast<const char*>(data), size}, "log.csv");
    check(log.size() > 0 && log.q.size() == log.size());
    for (std::size_t i = 0; i < log.size(); ++i) check(std::isfinite(log.t[i]) && (i == 0 || log.t[i] > log.t[i - 1]));
    check_column(log.q, log.size());
    check_column(log.dq, log.size());
    check_column(log.tau_ext, log.size());
    check_column(log.tau, log.size());
    check_column(log.truth, log.size());
    const auto part = rme::examples::cropped(log, log.t.front(), log.t.back());
    check(part.size() + 1 == log.size());
  } catch (const rme::examples::LogError& error) {
    check(std::string(error.what()).rfind("log.csv:", 0) == 0);
  }
  return 0;
}
