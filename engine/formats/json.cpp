// SPDX-License-Identifier: MIT
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/formats/table.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinity: a path that is not there is as long as "inf".
Json number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : "inf";
}

std::string json_path(const PathResult& path) {
  Json json{{"distance", number(path.distance)}, {"length", number(path.length)}, {"points", Json::array()}};
  // An end on the surface is the usual one.
  if (path.from_off_surface > 0) json["from_off_surface"] = path.from_off_surface;
  if (path.to_off_surface > 0) json["to_off_surface"] = path.to_off_surface;
  for (std::size_t i = 0; i < path.positions.size(); ++i) {
    const Vec3& p = path.positions[i];
    json["points"].push_back(
        {{"position", {p.x, p.y, p.z}}, {"face", path.points[i].face}, {"barycentric", path.points[i].b}});
  }
  return json.dump(1) + "\n";
}

}  // namespace

Format json_format() {
  return {.name = "JSON",
          .endings = {".json"},
          .uses = {{.content = Content::path, .written = "with its lengths"},
                   {.content = Content::report, .written = ""},
                   {.content = Content::figures, .written = ""}},
          .write_path = json_path};
}

}  // namespace geodrome
