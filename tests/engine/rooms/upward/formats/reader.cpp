// SPDX-License-Identifier: MIT
// A fixture of the test: it is not compiled.
#include "engine/jobs/job.hpp"
