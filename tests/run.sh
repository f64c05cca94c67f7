#!/usr/bin/env bash
# Builds everything and runs the whole test suite; ctest's summary comes last.
# Options are passed on to ctest: bash tests/run.sh -R log_reader
# shellcheck source=cmake/setup.sh
source "$(dirname "$0")/../cmake/setup.sh"

install_packages "${build_packages[@]}" catch2 python3-numpy python3-matplotlib
configure -DRME_BUILD_EXAMPLES=ON -DRME_BUILD_TESTS=ON
build all
say "testing"
exec ctest --test-dir build --no-tests=error --output-on-failure -j "$jobs" "$@"
