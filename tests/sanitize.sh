#!/usr/bin/env bash
# Builds the tests of the library and of the log reader with AddressSanitizer and UndefinedBehaviorSanitizer into
# build-asan-ubsan/ and runs them. Options are passed on to ctest. Left out, so that it takes minutes:
#  - the example programs and what runs them: the library's part in them is tested here;
#  - the checks of headers, package and documentation, which run no code of their own;
#  - the counting of allocations, since a sanitizer brings a heap of its own, and Python's tests;
#  - most of the soak.
# shellcheck source=cmake/setup.sh
source "$(dirname "$0")/../cmake/setup.sh"

install_packages "${build_packages[@]}" catch2
# Instrumented code takes clang++ half the time of g++, which also suspects libstdc++ of uninitialised values then.
if command -v clang++ >/dev/null; then
  compiler=(-DCMAKE_CXX_COMPILER=clang++)
  flags=
else
  compiler=()
  flags=-Wno-maybe-uninitialized
fi
say "configuring in $PWD/build-asan-ubsan"
cmake -S . -B build-asan-ubsan -G Ninja "${compiler[@]}" -DCMAKE_BUILD_TYPE=None -DRME_SANITIZED=ON -DRME_CHECK_HEADERS=OFF \
  -DRME_INSTALL=OFF -DRME_BUILD_EXAMPLES=ON -DRME_BUILD_TESTS=ON \
  -DCMAKE_CXX_FLAGS="-O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer $flags"
say "building with $jobs jobs"
folders=(core sensing inference network control estimator robustness)
cmake --build build-asan-ubsan --parallel "$jobs" --target "${folders[@]/#/tests_}" rme_soak examples_test_log_reader \
  examples_test_arguments
say "testing"
labels="^($(IFS='|'; echo "${folders[*]}"))_|^rme_soak$|^examples_test_(log_reader|arguments)$"
exec ctest --test-dir build-asan-ubsan --no-tests=error --output-on-failure -j "$jobs" -L "$labels" "$@"
