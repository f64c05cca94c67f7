#pragma once
/// Times single calls and prints their percentiles: a control loop cares about the slow calls as well, which an average
/// hides. Other programs on the machine show in the high ones.
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

namespace rme::benchmarks {

/// Makes the compiler believe that the value is used, whatever it is.
template <typename T>
void keep(const T& value) noexcept {
  asm volatile("" : : "r"(&value) : "memory");
}

/// Whether the command line asks for a run that only shows that the program works.
inline bool quick(int argc, char** argv) {
  return argc > 1 && std::strcmp(argv[1], "--quick") == 0;
}

/// What the clock takes by itself [us]: the median of many empty measurements.
inline double clock_cost() {
  using Clock = std::chrono::steady_clock;
  static const double cost = [] {
    std::vector<double> times(100001);
    for (double& t : times) {
      const auto start = Clock::now();
      t = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
    }
    std::nth_element(times.begin(), times.begin() + 50000, times.end());
    return times[50000];
  }();
  return cost;
}

/// How long one call takes [us], without the clock.
template <typename Call>
double time_of(const Call& call) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  call();
  return std::chrono::duration<double, std::micro>(Clock::now() - start).count() - clock_cost();
}

/// To be called between measurements, every few milliseconds: Linux stops a program of real-time priority for 50 ms
/// once it has been busy for 95 % of a second.
inline void rest() {
  using Clock = std::chrono::steady_clock;
  static Clock::time_point last = Clock::now();
  std::this_thread::sleep_for((Clock::now() - last) / 10);
  last = Clock::now();
}

/// The value that this share of the times stays below.
inline double percentile(std::vector<double> times, double share) {
  if (times.empty()) return 0;
  const auto at = times.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(times.size() - 1));
  std::nth_element(times.begin(), at, times.end());
  return *at;
}

inline void print_head(const char* title) {
  std::printf("\n### %s\n\n| %-58s | median us |   99 %% us | 99.9 %% us |   calls |\n", title, "");
  std::printf("|%s|----------:|----------:|----------:|--------:|\n", std::string(60, '-').c_str());
}

inline void print_row(const std::string& what, const std::vector<double>& times) {
  std::printf("| %-58s | %9.3f | %9.3f | %9.3f | %7zu |\n", what.c_str(), percentile(times, 0.5),
              percentile(times, 0.99), percentile(times, 0.999), times.size());
}

/// Times call(i), `batch` calls at a time where a single one would drown in the clock's own time; prints the row.
/// @return the median [us]
template <typename Call>
double measure(const std::string& what, std::size_t runs, std::size_t batch, const Call& call) {
  std::vector<double> times;
  times.reserve(runs);
  const std::size_t warm_up = runs / 10;
  for (std::size_t run = 0; run < warm_up + runs; ++run) {
    const double time = time_of([&] {
      for (std::size_t i = 0; i < batch; ++i) call(run * batch + i);
    });
    if (run >= warm_up) times.push_back(time / static_cast<double>(batch));
    if (run % 100 == 99) rest();
  }
  print_row(what, times);
  return percentile(times, 0.5);
}

}  // namespace rme::benchmarks
