// SPDX-License-Identifier: MIT
#include "engine/jobs/distances/nearest.hpp"

#include <cmath>

#include "engine/formats/number_text.hpp"
#include "engine/search/reach.hpp"

namespace geodrome {

NearestResult nearest_result(std::vector<Distance> distances, double seconds) {
  NearestResult result{.distances = std::move(distances), .seconds = seconds};
  for (const Distance& d : result.distances)
    ++(std::isnan(d.value)              ? result.dropped
       : d.reach == Reach::reached      ? result.reached
       : d.reach == Reach::beyond_limit ? result.beyond_limit
                                        : result.unreachable);
  return result;
}

std::string as_csv(const NearestResult& nearest, std::span<const NamedPoint> sources,
                   std::span<const NamedPoint> targets) {
  std::string text = "target,distance,source,reach\n";
  for (std::size_t j = 0; j < targets.size(); ++j) {
    const Distance& d = nearest.distances[j];
    text += targets[j].label + "," + number_text(d.value) + "," +
            (d.source == no_index ? "" : sources[d.source].label) + "," +
            reach_word(d.value, d.reach, targets[j].place) + "\n";
  }
  return text;
}

}  // namespace geodrome
