#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# All tests from a bare machine: installs, builds, runs.
set -euo pipefail
cd "$(dirname "$0")/../.."

tools/setup/dependencies.sh
cmake --preset release -DGEODROME_BUILD_TESTS=ON -DGEODROME_BUILD_BENCH=ON -DCMAKE_CXX_COMPILER_LAUNCHER=ccache
cmake --build --preset release
ctest --preset release
