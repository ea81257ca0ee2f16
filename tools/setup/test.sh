#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# All tests from a bare machine: installs, builds everything, runs.
set -euo pipefail
cd "$(dirname "$0")/../.."

tools/setup/dependencies.sh everything
cmake --preset release -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DGEODROME_PLUGINS=all \
  -DGEODROME_BUILD_TESTS=ON -DGEODROME_BUILD_BENCH=ON -DGEODROME_BUILD_CONFORMANCE=ON -DGEODROME_BUILD_PAGE=ON
cmake --build --preset release
ctest --preset release
