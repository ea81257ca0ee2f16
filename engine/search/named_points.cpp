// SPDX-License-Identifier: MIT
#include "engine/search/named_points.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <unordered_map>

#include "engine/formats/text_stream.hpp"
#include "engine/smooth/settling.hpp"
#include "engine/surface/off_surface.hpp"
#include "engine/surface/part_surface.hpp"
#include "engine/surface/place.hpp"

namespace geodrome {

namespace {

/// Coordinates are off by so much of their size after a few operations, which shows on small surfaces far from 0.
constexpr double rounding_of_numbers = 8 * std::numeric_limits<double>::epsilon();

void demand_index(std::size_t index, std::size_t count, const char* what) {
  if (index >= count)
    throw OptionError(std::string(what) + " " + std::to_string(index) + " does not exist",
                      "there are " + std::to_string(count) + ", counted from 0");
}

/// Finds the places of entries; what it needs to know of input and surface is looked up once.
class Resolver {
 public:
  Resolver(const Input& input, const PlacedSurface& surface)
      : input_(input), surface_(surface), locator_(surface.locator) {}

  NamedPoint row(std::size_t i) const { return {surface_.places[i], 0, static_cast<Index>(i), std::to_string(i)}; }

  /// Appends the points of an entry. `file`: where it stands; empty: in the text itself.
  void append(const PointEntry& entry, const std::string& file, std::vector<NamedPoint>& points) {
    try {
      if (entry.kind == PointEntry::Kind::row) demand_index(last_row(entry), surface_.places.size(), "row");
      for (std::uint64_t i = 0; i < entry.count; ++i) points.push_back(point(entry, i));
    } catch (const OptionError& error) {
      if (file.empty()) throw;
      throw InputError(InputFault::syntax, file + ": line " + std::to_string(entry.line) + ": " + error.message(),
                       error.coded_remedy());
    }
  }

  NamedPoint closest(const Vec3& position, const PointEntry& entry) {
    if (!locator_) locator_ = std::make_shared<const SurfaceLocator>(surface_.mesh);
    if (rounding_ < 0) rounding_ = share_of_rounding * surface_diagonal(*surface_.mesh);
    const auto [at, off] = locator_->closest(position);
    if (surface_.part && !within_reach(surface_, at, position))
      return {{Place::State::off_part, {}, no_index, position}, entry.start, no_index, entry.label};
    Place place = place_on(*surface_.mesh, at, position);
    if (place.vertex == no_index) place.at = settled(at, position);
    // On a mesh the surface itself was given, so the point meant is the one on it; a cloud's surface is an estimate.
    if (surface_.made_from == InputKind::mesh) place.position = surface_.mesh->position(place.at);
    return {place, entry.start, no_index, entry.label,
            off > std::max(rounding_, rounding_of_numbers * norm(position)) ? off : 0};
  }

 private:
  /// Where the smooth surface is closest to a position, as rows are placed; `at` without one.
  SurfacePoint settled(const SurfacePoint& at, const Vec3& position) {
    if (!surface_.smooth) return at;
    SettledPoint point{position, at};
    cross_boundary(surface_.smooth->record.plugin, [&] {
      if (!charts_) charts_.emplace(surface_.mesh, surface_.smooth->surface);
      settle(*charts_, {&point, 1});
    });
    return point.at;
  }

  static std::size_t last_row(const PointEntry& entry) { return entry.index + (entry.count - 1) * entry.step; }

  /// `i`: which of the rows that it names.
  NamedPoint point(const PointEntry& entry, std::uint64_t i) {
    const auto& [x, y, z] = entry.numbers;
    switch (entry.kind) {
      case PointEntry::Kind::row: {
        NamedPoint named = row(entry.index + i * entry.step);
        named.start = entry.start;
        return named;
      }
      case PointEntry::Kind::position:
        return closest({x, y, z}, entry);
      default:
        return {on_face(entry), entry.start, no_index, entry.label};
    }
  }

  Place on_face(const PointEntry& entry) {
    if (surface_.made_from == InputKind::points)
      throw OptionError("a cloud has no faces", "name a row or a point 'x y z'");
    demand_index(entry.index, input_.facts.faces_in_file, "face");
    const SurfacePoint at{triangle_of(static_cast<Index>(entry.index)), entry.numbers};
    return place_on(*surface_.mesh, at, surface_.mesh->position(at));
  }

  Index triangle_of(Index face) {
    if (triangles_of_face_.empty())
      for (Index t = 0; t < input_.face_of_triangle.size(); ++t)
        triangles_of_face_[input_.face_of_triangle[t]].push_back(t);
    const auto found = triangles_of_face_.find(face);
    if (found == triangles_of_face_.end())
      throw OptionError("face " + std::to_string(face) + " was dropped as degenerate", "name another face");
    if (found->second.size() > 1)
      throw OptionError("face " + std::to_string(face) + " is no triangle", "name the point as 'x y z'");
    return found->second.front();
  }

  const Input& input_;
  const PlacedSurface& surface_;
  std::shared_ptr<const SurfaceLocator> locator_;
  double rounding_ = -1;                // not known yet
  std::optional<SmoothCharts> charts_;  // nor made
  std::unordered_map<Index, std::vector<Index>> triangles_of_face_;
};

}  // namespace

std::vector<NamedPoint> resolve(const Selection& selection, const Input& input, const PlacedSurface& surface) {
  Resolver resolver(input, surface);
  std::vector<NamedPoint> points;
  if (selection.all)
    for (std::size_t i = 0; i < surface.places.size(); ++i) points.push_back(resolver.row(i));
  for (const PointEntry& entry : selection.entries) resolver.append(entry, selection.file, points);
  return points;
}

PairList resolve(const PairSelection& selection, const Input& input, const PlacedSurface& surface) {
  Resolver resolver(input, surface);
  PairList list{{}, selection.hash};
  list.pairs.reserve(selection.pairs.size());
  std::vector<NamedPoint> ends;
  for (const auto& [from, to] : selection.pairs) {
    ends.clear();
    resolver.append(from, selection.file, ends), resolver.append(to, selection.file, ends);
    list.pairs.push_back({std::move(ends[0]), std::move(ends[1])});
  }
  return list;
}

void demand_on_part(const Selection& selection, std::span<const NamedPoint> points, const PlacedSurface& surface) {
  for (std::size_t i = 0; i < points.size() && !selection.all; ++i)
    demand_on_part(points[i], surface, selection.file.empty() ? "" : selection.file + ": ");
}

void demand_on_part(const NamedPoint& point, const PlacedSurface& surface, const std::string& where) {
  if (point.place.state != Place::State::off_part) return;
  const Vec3& p = point.place.position;
  TextOutput text;
  text.precision(9);
  text << where << (point.row == no_index ? "the point " : "row ") << point.label << " at (" << p.x << ", " << p.y
       << ", " << p.z << ") is not on the part of the sample that makes a surface";
  throw InputError(InputFault::index, text.str(),
                   "name points on it, such as row " + std::to_string(surface.part->row));
}

std::vector<NamedPoint> select(const std::string& text, const Input& input, const PlacedSurface& surface) {
  return resolve(parse_selection(text), input, surface);
}

PairList select_pairs(const std::filesystem::path& file, const Input& input, const PlacedSurface& surface) {
  return resolve(parse_pairs(file), input, surface);
}

}  // namespace geodrome
