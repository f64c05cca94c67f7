#!/usr/bin/env bash
# Builds the fuzzers of tests/fuzz into build-fuzz/, with AddressSanitizer and UndefinedBehaviorSanitizer, and lets each look
# for bad inputs for a minute, or for as many seconds as the first argument says.
# shellcheck source=cmake/setup.sh
source "$(dirname "$0")/../cmake/setup.sh"

install_packages "${build_packages[@]}" catch2 clang
say "configuring in $PWD/build-fuzz"
cmake -S . -B build-fuzz -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=None -DRME_BUILD_FUZZERS=ON \
  -DRME_FUZZ_SECONDS="${1:-60}" -DRME_BUILD_EXAMPLES=OFF -DRME_CHECK_HEADERS=OFF -DRME_INSTALL=OFF
say "building with $jobs jobs"
cmake --build build-fuzz --parallel "$jobs" --target fuzzers
say "looking for bad inputs"
exec ctest --test-dir build-fuzz --no-tests=error --output-on-failure -j "$jobs" -L fuzz
