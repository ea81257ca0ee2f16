// SPDX-License-Identifier: MIT
#include "engine/report/off_surface_text.hpp"

#include <cmath>

#include "engine/formats/text.hpp"
#include "engine/formats/text_stream.hpp"

namespace geodrome {

namespace {

/// "far.txt: line 1 by 0.5 (35.36 % of its diagonal)".
std::string farthest_text(const OffSurface& off) {
  const OffPlace& farthest = off.farthest.front();
  TextOutput text;
  text.precision(4);
  text << farthest.entry << " by " << farthest.distance;
  const double share = farthest.distance / off.diagonal;
  if (std::isfinite(share))
    text << " (" << (share < 10 ? 100 * share : share) << (share < 10 ? " % of" : " times") << " its diagonal)";
  return text.str();
}

Json to_json(const OffPlace& place) {
  return {{"entry", place.entry},
          {"point", {place.named.x, place.named.y, place.named.z}},
          {"distance", place.distance},
          {"could_be_rows", place.could_be_rows}};
}

}  // namespace

std::vector<Finding> findings_of(const OffSurface& off) {
  if (off.warned == 0) return {};
  std::string message = counted(off.warned, "point that is named lies", "points that are named lie") +
                        " off the surface, " + (off.warned == 1 ? "" : "at most ") + farthest_text(off) +
                        "; the closest surface " + (off.warned == 1 ? "point stands for it" : "points stand for them");
  std::string remedy = "check the units and the reference system of these coordinates";
  if (off.warned_as_rows > 0) {
    message +=
        "; " + counted(off.warned_as_rows, "of them is", "of them are") + " three whole numbers that could be rows";
    remedy = "if rows are meant, write one a line; else check the coordinates";
  }
  return {{Finding::Severity::warning, "places_off_surface", message, off.warned, {}, remedy}};
}

void add_off_surface(Json& json, const OffSurface& off) {
  if (off.off == 0) return;
  Json& places = json["places_off_surface"];
  places = {{"named_by_coordinates", off.named}, {"off_surface", off.off},     {"warned", off.warned},
            {"diagonal", off.diagonal},          {"tolerated", off.tolerated}, {"farthest", Json::array()}};
  for (const OffPlace& place : off.farthest) places["farthest"].push_back(to_json(place));
  places["findings"] = to_json(findings_of(off));
}

void summarize(const OffSurface& off, std::ostream& out) {
  if (off.off == 0) return;
  out << "places     " << off.off << " of " << off.named << " named by coordinates " << (off.off == 1 ? "is" : "are")
      << " off the surface: " << (off.off == 1 ? "" : "at most ") << farthest_text(off) << "\n";
}

}  // namespace geodrome
