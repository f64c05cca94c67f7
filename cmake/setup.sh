# shellcheck shell=bash disable=SC2034
# Sourced by examples/run.sh and tests/run.sh: gets a Debian or Ubuntu machine ready and builds into $build_folder.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build_packages=(g++ cmake ninja-build libeigen3-dev nlohmann-json3-dev zlib1g-dev)
build_folder=build
jobs=$(nproc)

say() { printf '\n==> %s\n' "$*"; }
fail() {
  printf '\nerror: %s\n' "$*" >&2
  exit 1
}

# install_packages PACKAGE...: installs those that are missing, and touches nothing if none is.
install_packages() {
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    say "no apt on this machine; going on in the hope that these are there: $*"
    return
  fi
  local package missing=() sudo=()
  for package in "$@"; do
    # The status of a package that was never there is an error, that of a removed one is not "installed".
    [[ $(dpkg-query -W -f='${Status}' "$package" 2>/dev/null) == *' installed' ]] || missing+=("$package")
  done
  if [[ ${#missing[@]} -eq 0 ]]; then
    say "nothing to install: all packages are there"
    return
  fi
  if [[ $(id -u) -ne 0 ]]; then
    command -v sudo >/dev/null || fail "not root and no sudo here; ask an administrator for: apt-get install ${missing[*]}"
    sudo=(sudo)
  fi
  say "installing with apt: ${missing[*]}"
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -qq
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends \
    -o Dpkg::Use-Pty=0 "${missing[@]}"
}

# configure OPTION...: a Release build in $build_folder. At -O2, as the library is measured; -O3 takes longer to compile.
# CXX is the compiler of a new folder. Without it that is clang++ where there is one: it needs a third less time than g++.
configure() {
  say "configuring in $PWD/$build_folder"
  if [[ -z ${CXX:-} ]] && command -v clang++ >/dev/null; then export CXX=clang++; fi
  cmake -S . -B "$build_folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG" "$@"
}

# build TARGET...
build() {
  say "building with $jobs jobs"
  cmake --build "$build_folder" --parallel "$jobs" --target "$@"
}
