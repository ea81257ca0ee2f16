// SPDX-License-Identifier: MIT
#include "engine/report/smooth_text.hpp"

#include <ostream>

namespace geodrome {

Json to_json(const SmoothFigures& smooth) {
  return {{"paths", smooth.paths},
          {"left_above_flat_paths", smooth.left},
          {"share_of_length", to_json(smooth.share())},
          {"mean_correction", to_json(smooth.mean_correction())},
          {"largest_correction", to_json(smooth.largest_correction)},
          {"mean_estimated_error", to_json(smooth.mean_error())},
          {"largest_estimated_error", to_json(smooth.largest_error)},
          {"largest_change", to_json(smooth.largest_change)}};
}

void summarize_smooth(const SmoothFigures& smooth, const FittedSurface& fitted, const char* of, std::ostream& out) {
  out << "smooth     " << of << 100 * smooth.share() << " % of the length, by " << fitted.record.plugin.full_name()
      << "; changed by " << smooth.mean_correction() << " in the mean, " << smooth.largest_correction
      << " at most; estimated error " << smooth.mean_error() << " in the mean, " << smooth.largest_error
      << " at most\n";
}

}  // namespace geodrome
