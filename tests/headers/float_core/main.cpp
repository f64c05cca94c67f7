// Prints what fails; the exit code says how many did.
#include <cstdio>

#include "headers/float_core/float_core.hpp"

int main() {
  using namespace float_core;
  int failed = 0, count = 0;
  for (const auto* part : {&kSensing, &kInference, &kMeanField, &kEnclosure, &kControl, &kNetwork, &kTracker}) {
    for (const Case& c : *part) {
      ++count;
      if (c.passes()) continue;
      ++failed;
      std::printf("FAILED %s\n", c.name);
    }
  }
  std::printf("%d cases in float, %d failed\n", count, failed);
  return failed;
}
