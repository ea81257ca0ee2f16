// SPDX-License-Identifier: MIT
// A shared library like any other.
extern "C" __attribute__((visibility("default"))) int somebody_elses_function() { return 42; }
