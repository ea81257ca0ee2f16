// SPDX-License-Identifier: MIT
// Compiles only with -DIMPLEMENTS_A_STAGE.
#include "geodrome/plugin.hpp"

using namespace geodrome;

#ifdef IMPLEMENTS_A_STAGE
struct Everything : Decimator {
  std::vector<Index> select(const PointSample&, const Control&, RunContext&) const override { return {}; }
};
#else
struct Everything {
  std::vector<Index> select(const PointSample&, const Control&, RunContext&) const { return {}; }
};
#endif

GEODROME_PLUGIN(Everything, .name = "everything", .summary = "for the compiler only", .licence = "MIT")
