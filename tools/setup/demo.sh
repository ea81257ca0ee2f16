#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The main job from a bare machine: installs, builds, and turns points of a torus into a distance matrix with its
# report. Builds the standard plugins and those that cost little; test.sh builds everything.
set -euo pipefail
cd "$(dirname "$0")/../.."

plugins=(
  tangent_jet control_lipschitz decimator_greedy reconstructor_delaunay_cut solver_chen_han
  tangent_pca control_constant decimator_none solver_cgal solver_edge_dijkstra
)
tools/setup/dependencies.sh main
cmake --preset release -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DGEODROME_PLUGINS="$(IFS=';'; echo "${plugins[*]}")" \
  -DGEODROME_BUILD_TESTS=OFF -DGEODROME_BUILD_BENCH=OFF -DGEODROME_BUILD_CONFORMANCE=OFF -DGEODROME_BUILD_PAGE=OFF
cmake --build --preset release

mkdir -p build/demo
geodrome=build/release/bin/geodrome
"$geodrome" shape torus --points 1000 -o build/demo/torus.xyz
"$geodrome" distances build/demo/torus.xyz -o build/demo/torus.npy \
  --surface build/demo/torus.ply --report build/demo/torus.json
cat build/demo/torus.json
