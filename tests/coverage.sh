#!/usr/bin/env bash
# Prints which share of the lines of include/ the unit tests run. build-coverage/lines.txt then shows every line with how
# often it ran. Programs to build and run may be named; all unit tests of the library otherwise.
# shellcheck source=cmake/setup.sh
source "$(dirname "$0")/../cmake/setup.sh"

install_packages "${build_packages[@]}" catch2 clang llvm
# -O0: templates compile in a third of the time. What comes from a precompiled header is not counted.
say "configuring in $PWD/build-coverage"
cmake -S . -B build-coverage -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=None -DRME_SANITIZED=ON \
  -DRME_CHECK_HEADERS=OFF -DRME_INSTALL=OFF -DRME_BUILD_EXAMPLES=ON -DRME_BUILD_TESTS=ON \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON \
  -DCMAKE_CXX_FLAGS="-O0 -fprofile-instr-generate -fcoverage-mapping"
folders=(core sensing inference network control estimator robustness)
programs=("$@")
[[ $# -gt 0 ]] || programs=("${folders[@]/#/tests_}")
say "building with $jobs jobs"
cmake --build build-coverage --parallel "$jobs" --target "${programs[@]}"

cd build-coverage
rm -f profiles/*
mapfile -t built < <(find tests -type f -perm -u+x -name '*_test_*')
say "testing"
printf '%s\0' "${built[@]}" | LLVM_PROFILE_FILE=$PWD/profiles/%p.profraw xargs -0 -n 1 -P "$jobs" sh -c '"$0" > "$0.log" || echo "failed: $0"'
llvm-profdata merge -o all.profdata profiles/*.profraw
objects=("${built[@]/#/-object=}")
objects[0]=${built[0]}  # llvm-cov wants one without the option
say "coverage of include/"
llvm-cov show "${objects[@]}" -instr-profile=all.profdata ../include > lines.txt
llvm-cov report "${objects[@]}" -instr-profile=all.profdata -show-region-summary=false -show-branch-summary=false ../include
