#!/usr/bin/env bash
# Builds the live page: docs/live, which any static host serves, and which a browser opens from the folder. Some minutes;
# needs emscripten, and npm for esbuild and three.js.
# shellcheck source=cmake/setup.sh
source "$(dirname "$0")/../../cmake/setup.sh"

packages=(cmake ninja-build libeigen3-dev nlohmann-json3-dev liburdfdom-headers-dev emscripten node-acorn)
command -v npm >/dev/null || packages+=(npm)
install_packages "${packages[@]}"
export NODE_PATH=/usr/share/nodejs  # in which emscripten looks for acorn
work=$build_folder/live
output=docs/live

say "compiling for WebAssembly"
emcmake cmake -S examples/live/wasm -B "$work/wasm" -G Ninja -DCMAKE_BUILD_TYPE=None >/dev/null
cmake --build "$work/wasm" --parallel "$jobs"

say "installing esbuild and three.js in $work"
cp examples/live/package.json examples/live/package-lock.json "$work"
npm ci --prefix "$work" --no-audit --no-fund --ignore-scripts --omit-lockfile-registry-resolved

say "bundling"
mkdir -p "$output"
node examples/live/bundle.mjs "$work/node_modules" "$work/wasm" "$output"
cmake -DROOT="$PWD" -DWRITE=ON -P examples/live/digest.cmake
say "the page is $PWD/$output/index.html; compressed, all of it: $(cat "$output"/*.{html,css,js} | gzip -9 | wc -c) bytes"
