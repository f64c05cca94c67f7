#!/usr/bin/env bash
# Builds the benchmarks into build-benchmarks/, runs them and writes docs/performance.md. Measuring takes a few minutes;
# leave the machine alone meanwhile.
# shellcheck source=cmake/setup.sh
source "$(dirname "$0")/../../cmake/setup.sh"

install_packages "${build_packages[@]}" catch2 liborocos-kdl-dev libnlopt-dev r-cran-quadprog libtorch-dev libopenblas0 \
  python3-torch python3-matplotlib
build_folder=build-benchmarks
CXX=g++ configure -DRME_BUILD_BENCHMARKS=ON -DRME_BUILD_TESTS=OFF
build benchmarks
say "measuring"
# The python that apt installs torch and matplotlib for, whatever else is on the PATH.
exec /usr/bin/python3 tests/benchmarks/report.py "$build_folder"
