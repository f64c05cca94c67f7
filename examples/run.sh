#!/usr/bin/env bash
# Builds rme and runs its main job: an arm holds a pose, an unknown payload appears, is estimated and compensated.
# Options are passed on to the program; see examples/01_static_payload.
# shellcheck source=cmake/setup.sh
source "$(dirname "$0")/../cmake/setup.sh"

install_packages "${build_packages[@]}" pybind11-dev python3-dev python3-numpy python3-matplotlib
# Tests need Catch2, which this command does not install. A build folder that has them keeps them.
tests_off=()
[[ -f build/CMakeCache.txt ]] || tests_off=(-DRME_BUILD_TESTS=OFF)
configure -DRME_BUILD_EXAMPLES=ON "${tests_off[@]}"
build rme_01_static_payload

output=build/output/01_static_payload
mkdir -p "$output"
say "running 01_static_payload"
build/examples/01_static_payload/rme_01_static_payload --output "$output" "$@"
say "drawing"
# The python that apt installs matplotlib for, whatever else is on the PATH.
/usr/bin/python3 examples/01_static_payload/plot.py "$output"
say "the picture is $PWD/$output/static_payload.png"
