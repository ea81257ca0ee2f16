// SPDX-License-Identifier: MIT
#pragma once

#include "engine/jobs/start.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

/// Reports what the input holds and, if stages 1 to 4 ran, what came of the sample; remedies are in the words of the
/// observer.
CheckReport check_report(const JobStart& start, const Observer& observer);

}  // namespace geodrome
