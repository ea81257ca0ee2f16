// SPDX-License-Identifier: MIT
#include "engine/checks/distance_audit.hpp"
#include "engine/checks/lipschitz.hpp"
#include "engine/checks/rounding_scale.hpp"
#include "engine/formats/number_text.hpp"
#include "engine/surface/face_weight.hpp"

namespace geodrome {

DistanceAudit audit_vertices(const SurfaceMesh& mesh, std::span<const double> vertices, double factor, double limit,
                             std::span<const Source> sources, const std::string& from) {
  DistanceAudit result;
  result.scale = RoundingScale(smallest_weight(mesh)).distances(vertices).points(mesh.positions()).value();
  const auto report = [&](const MisfitVertex& misfit, const char* how) {
    const double violation = result.scale > 0 ? misfit.excess / result.scale : misfit.excess;
    if (!(violation > result.worst)) return;
    const Vec3 place = mesh.positions()[misfit.vertex];
    result.worst = violation;
    result.where = "the search from " + from + " found vertex " + std::to_string(misfit.vertex) + " at distance " +
                   number_text(vertices[misfit.vertex]) + ", " + how + " for its neighbours on face " +
                   std::to_string(misfit.face) + " near (" + number_text(place.x) + ", " + number_text(place.y) + ", " +
                   number_text(place.z) + ")";
  };
  report(worst_too_far(mesh, vertices, factor, limit), "too far");
  report(worst_too_near(mesh, vertices, factor, limit, sources), "too near");
  return result;
}

void DistanceAudit::add(const DistanceAudit& other) {
  const AuditResult& one = other.search;
  const bool worse =
      std::max(one.worst_lipschitz, one.worst_path) > std::max(search.worst_lipschitz, search.worst_path);
  if (worse || search.where.empty()) search.where = one.where;
  search.faces += one.faces, search.pairs += one.pairs, search.paths += one.paths;
  search.scale = std::max(search.scale, one.scale);
  search.worst_lipschitz = std::max(search.worst_lipschitz, one.worst_lipschitz);
  search.worst_path = std::max(search.worst_path, one.worst_path);
  targets += other.targets, from_sources += other.from_sources, from_targets += other.from_targets;
  scale = std::max(scale, other.scale);
  if (other.worst > worst) worst = other.worst, where = other.where;
  if (not_audited.empty()) not_audited = other.not_audited;
  if (search_not_audited.empty()) search_not_audited = other.search_not_audited;
}

std::vector<std::string> broken_promises(const DistanceAudit& audit) {
  std::vector<std::string> broken;
  if (audit.missed > 0) broken.push_back(std::to_string(audit.missed) + " targets beside a source are not reached");
  if (audit.impossible > 0)
    broken.push_back(std::to_string(audit.impossible) + " targets are reached that no source can reach");
  if (std::max(audit.search.worst_lipschitz, audit.search.worst_path) > audit_tolerance)
    broken.push_back("the audit failed: " + audit.search.where);
  if (audit.worst > audit_tolerance) broken.push_back("the audit failed: " + audit.where);
  return broken;
}

}  // namespace geodrome
