#!/usr/bin/env bash
# Builds the tests with AddressSanitizer and UndefinedBehaviorSanitizer into build-asan-ubsan/ and runs them. Options are
# passed on to ctest. Left out are tests that would find nothing more:
#  - the checks of headers, package, format and documentation;
#  - the counting of allocations, and memcheck: a sanitizer brings a heap of its own;
#  - tests that compare numbers alone (NUMBERS in the CMakeLists.txt): what they call runs in the tests of bad input, of
#    hosts, of the active-set solver, and in the soak;
#  - single test cases of this kind that take long, below;
#  - the programs and their tests, but for those that read files: logs, URDFs, settings, weights;
#  - other libraries' physics and dynamics, which are not instrumented;
#  - most of the soak.
# Nothing is optimised but what most of the time is spent in (rme_hot() in the CMakeLists.txt): it compiles in half the time.
# shellcheck source=cmake/setup.sh
source "$(dirname "$0")/../cmake/setup.sh"

install_packages "${build_packages[@]}" catch2
# Instrumented code takes clang++ half the time of g++, which also suspects libstdc++ of uninitialised values then.
if command -v clang++ >/dev/null; then
  compiler=(-DCMAKE_CXX_COMPILER=clang++)
  flags=-fsanitize-ignorelist=$PWD/tests/sanitize_ignorelist.txt
else
  compiler=()
  flags=-Wno-maybe-uninitialized
fi
say "configuring in $PWD/build-asan-ubsan"
cmake -S . -B build-asan-ubsan -G Ninja "${compiler[@]}" -DCMAKE_BUILD_TYPE=None -DRME_SANITIZED=ON -DRME_CHECK_HEADERS=OFF \
  -DRME_INSTALL=OFF -DRME_BUILD_EXAMPLES=ON -DRME_BUILD_TESTS=ON \
  -DCMAKE_CXX_FLAGS="-O0 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer $flags"
say "building with $jobs jobs"
cmake --build build-asan-ubsan --parallel "$jobs"
say "testing"
export LSAN_OPTIONS=suppressions=$PWD/tests/leak_suppressions.txt:print_suppressions=0
numbers="to the last bit|at 50 Hz to 4 kHz|of 2000 random polytopes"
exec ctest --test-dir build-asan-ubsan --no-tests=error --output-on-failure -j "$jobs" -E "$numbers" "$@"
