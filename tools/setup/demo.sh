#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The main job from a bare machine: installs, builds, and turns points of a torus into a distance matrix with its
# report.
set -euo pipefail
cd "$(dirname "$0")/../.."

tools/setup/dependencies.sh
cmake --preset release -DGEODROME_BUILD_TESTS=OFF -DGEODROME_BUILD_BENCH=OFF -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
cmake --build --preset release

mkdir -p build/demo
geodrome=build/release/bin/geodrome
"$geodrome" shape torus --points 1000 -o build/demo/torus.xyz
"$geodrome" distances build/demo/torus.xyz -o build/demo/torus.npy --surface build/demo/torus.ply \
  --report build/demo/torus.json
cat build/demo/torus.json
