#!/usr/bin/env bash
# Builds everything and runs the whole test suite. Last comes what was left out for want of packages, if anything was, and
# ctest's summary.
# Options are passed on to ctest: bash tests/run.sh -R log_reader
# shellcheck source=cmake/setup.sh
source "$(dirname "$0")/../cmake/setup.sh"

install_packages "${build_packages[@]}" catch2 libglpk-dev pybind11-dev python3-dev python3-numpy python3-matplotlib
configure -DRME_BUILD_EXAMPLES=ON -DRME_BUILD_TESTS=ON
build all
say "testing"
failed=0
ctest --test-dir build --no-tests=error --output-on-failure -j "$jobs" "$@" | tee build/ctest.txt || failed=$?
# What is skipped says "skipped: needs PACKAGE...", for ctest's log.
missing=$({ sed -n 's/^skipped: needs //p' build/Testing/Temporary/LastTest.log || true; } | tr ' ' '\n' | sort -u | paste -sd ' ')
if [[ -n $missing ]]; then
  say "tests were skipped for want of these packages: $missing"
  grep -E 'tests passed, |^Total Test time' build/ctest.txt || true
fi
exit "$failed"
