// SPDX-License-Identifier: MIT
#include "geodrome/engine/audit.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "engine/checks/seeded_subset.hpp"
#include "engine/surface/common_face.hpp"
#include "geodrome/vertex_components.hpp"

namespace geodrome {
namespace {

/// A violation that is not a number is the worst one.
double worst_if_nan(double violation) { return std::isnan(violation) ? infinity : violation; }

std::string shown(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 4).ptr};
}

/// The share of all `count` faces, drawn from those that may be chosen; in their order.
std::vector<Index> chosen_faces(std::size_t count, const AuditOptions& options) {
  if (options.faces.empty()) return seeded_share(static_cast<Index>(count), options.share, options.seed);
  const auto allowed = static_cast<Index>(options.faces.size());
  std::vector<Index> chosen =
      seeded_subset(allowed, size_of_share(static_cast<Index>(count), options.share), options.seed);
  for (Index& face : chosen) face = options.faces[face];
  return chosen;
}

class Auditor {
 public:
  Auditor(const SurfaceMesh& mesh, std::span<const Source> sources, const ShortestPathMap& map, Provides provides,
          const AuditOptions& options)
      : mesh_(mesh),
        sources_(sources),
        map_(map),
        provides_(provides),
        options_(options),
        common_(mesh),
        component_(vertex_components(mesh)),
        has_source_(mesh.vertex_count(), false) {
    for (const Source& source : sources) has_source_[component_of(source.at.face)] = true;
  }

  AuditResult run() {
    for (const Source& source : sources_) audit_source(source);
    for (const Index face : chosen_faces(mesh_.face_count(), options_)) audit_face(face);
    const double scale = options_.scale > 0 ? options_.scale : result_.scale > 0 ? result_.scale : 1;
    result_.worst_lipschitz /= scale;
    result_.worst_path /= scale;
    describe();
    return result_;
  }

 private:
  struct Sample {
    SurfacePoint at;
    double value;
  };

  Index component_of(Index face) const { return component_[mesh_.triangles()[face][0]]; }

  void report_lipschitz(double violation, Index face) {
    violation = worst_if_nan(violation);
    if (violation <= result_.worst_lipschitz) return;
    result_.worst_lipschitz = violation;
    result_.worst_lipschitz_face = face;
  }
  void report_path(double violation, Index face) {
    violation = worst_if_nan(violation);
    if (violation <= result_.worst_path) return;
    result_.worst_path = violation;
    result_.worst_path_face = face;
  }

  /// D at a source is at most the source's start distance.
  void audit_source(const Source& source) {
    if (!std::isfinite(options_.factor)) return;
    report_lipschitz(map_.at(source.at).value / options_.factor - source.start, source.at.face);
  }

  void audit_face(Index face) {
    ++result_.faces;
    std::vector<Sample> samples;
    bool as_it_should_be = true;
    for (const SurfacePoint& point : points_of(face)) {
      const Distance distance = map_.at(point);
      as_it_should_be = as_it_should_be && (distance.reach == Reach::reached) == has_source_[component_of(face)] &&
                        (distance.reach == Reach::reached) == std::isfinite(distance.value);
      samples.push_back({point, distance.value});
    }
    if (!as_it_should_be) return report_lipschitz(infinity, face);
    if (!has_source_[component_of(face)]) return;
    for (const Sample& sample : samples) {
      result_.scale = std::max(result_.scale, sample.value);
      audit_one_value(sample);
    }
    for (std::size_t i = 0; i < samples.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) audit_pair(samples[i], samples[j], face);
    if (!has(provides_, Provides::paths)) return;
    audit_path(samples[face % 3], face);
    audit_path({centre(face), map_.at(centre(face)).value}, face);
  }

  /// A point on an edge or at a vertex has one distance, whichever face it is asked on and, at a vertex, in the list of
  /// all. A solver that loses a window while it crosses an edge has two, each of them Lipschitz on its own face.
  void audit_one_value(const Sample& sample) {
    const auto compare = [&](double other) {
      if (!std::isfinite(options_.factor)) return;
      ++result_.pairs;
      report_lipschitz(sample.value / options_.factor - other, sample.at.face);
      report_lipschitz(other / options_.factor - sample.value, sample.at.face);
    };
    if (const SurfacePoint next = common_.on_next_face(sample.at); next.face != sample.at.face)
      compare(map_.at(next).value);
    if (const Index vertex = mesh_.vertex_at(sample.at); vertex != no_index) compare(map_.vertices()[vertex]);
  }

  static SurfacePoint centre(Index face) {
    constexpr double third = 1.0 / 3;
    return {face, {third, third, 1 - third - third}};
  }

  std::vector<SurfacePoint> points_of(Index face) const {
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 3; ++i) {
      points.push_back({face, {}});
      points.back().b[i] = 1;
    }
    const double parts = static_cast<double>(options_.points_per_edge + 1);
    for (int i = 0; i < 3; ++i)
      for (std::size_t k = 1; k <= options_.points_per_edge; ++k) {
        SurfacePoint point{face, {}};
        point.b[i] = static_cast<double>(k) / parts;
        point.b[(i + 1) % 3] = 1 - point.b[i];
        points.push_back(point);
      }
    return points;
  }

  void audit_pair(const Sample& x, const Sample& y, Index face) {
    if (!std::isfinite(options_.factor)) return;
    ++result_.pairs;
    const auto straight = common_.straight(x.at, y.at);
    if (!straight) return report_lipschitz(infinity, face);
    report_lipschitz(x.value / options_.factor - y.value - *straight, face);
    report_lipschitz(y.value / options_.factor - x.value - *straight, face);
  }

  void audit_path(const Sample& from, Index face) {
    ++result_.paths;
    std::vector<SurfacePoint> path;
    map_.path(from.at, path);
    const Index source = map_.at(from.at).source;
    if (path.empty() || source >= sources_.size()) return report_path(infinity, face);
    double length = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const auto step = common_.straight(path[i], path[i + 1]);
      if (!step) return report_path(infinity, face);
      length += *step;
    }
    const auto miss_start = common_.straight(path.front(), from.at);
    const auto miss_end = common_.straight(path.back(), sources_[source].at);
    if (!miss_start || !miss_end) return report_path(infinity, face);
    if (has(provides_, Provides::path_is_distance))
      report_path(std::abs(length + sources_[source].start - from.value) + *miss_start + *miss_end, face);
    if (path.size() > 1) audit_pair(from, {path[1], map_.at(path[1]).value}, face);
  }

  void describe() {
    const auto line = [&](const char* what, double value, Index face) {
      if (face == no_index) return;
      const Vec3 at = mesh_.position(centre(face));
      if (!result_.where.empty()) result_.where += "; ";
      result_.where += std::string(what) + " " + shown(value) + " of the scale on face " + std::to_string(face) +
                       " near (" + shown(at.x) + ", " + shown(at.y) + ", " + shown(at.z) + ")";
    };
    line("Lipschitz bound exceeded by", result_.worst_lipschitz, result_.worst_lipschitz_face);
    line("path and distance differ by", result_.worst_path, result_.worst_path_face);
  }

  const SurfaceMesh& mesh_;
  std::span<const Source> sources_;
  const ShortestPathMap& map_;
  Provides provides_;
  AuditOptions options_;
  CommonFace common_;
  std::vector<Index> component_;
  std::vector<bool> has_source_;
  AuditResult result_;
};

}  // namespace

AuditResult audit(const SurfaceMesh& mesh, std::span<const Source> sources, const ShortestPathMap& map,
                  Provides provides, const AuditOptions& options) {
  if (!has(provides, Provides::any_point))
    throw CapabilityError("the audit asks at any point", "choose a solver that provides any_point");
  if (!(options.share > 0)) throw OptionError("the audit's share must be above 0");
  return Auditor(mesh, sources, map, provides, options).run();
}

}  // namespace geodrome
