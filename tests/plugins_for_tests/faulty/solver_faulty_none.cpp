// SPDX-License-Identifier: MIT
// No fault at all: what the kit finds in the others is not the wrapper's doing.
#include "tests/plugins_for_tests/faulty/faulty_solver.hpp"

GEODROME_FAULTY_SOLVER(geodrome::faulty::NoFault, "faulty_none")
