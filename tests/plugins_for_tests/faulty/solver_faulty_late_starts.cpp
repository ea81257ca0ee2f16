// SPDX-License-Identifier: MIT
// Of several sources all but the first start later than they should, if they start late.
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

namespace {
using namespace geodrome;
struct Fault : faulty::NoFault {
  static void sources(std::vector<Source>& all) {
    for (std::size_t i = 1; i < all.size(); ++i) all[i].start *= 1.01;
  }
};
}  // namespace

GEODROME_FAULTY_SOLVER(Fault, "faulty_late_starts")
