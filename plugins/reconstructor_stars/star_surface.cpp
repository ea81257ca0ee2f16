// SPDX-License-Identifier: MIT
#include "plugins/reconstructor_stars/star_surface.hpp"

#include <utility>

#include "plugins/common/points/cell_radius.hpp"
#include "plugins/common/points/planar_stars.hpp"
#include "plugins/common/surfaces/face_bounds.hpp"
#include "plugins/reconstructor_stars/star_union.hpp"
#include "plugins/reconstructor_stars/union_faults.hpp"

namespace geodrome {
namespace {

Finding finding_of(Finding::Severity severity, const Fault& fault, const KeptPoints& kept) {
  std::vector<Index> places;
  for (const Index p : fault.places) places.push_back(kept.sample[p]);
  return finding(severity, fault.code, fault.message, fault.count, std::move(places));
}

Fault disputed_triangles(const StarUnion& all) {
  std::vector<Index> places;
  for (const Index f : all.disputed) places.insert(places.end(), all.faces[f].begin(), all.faces[f].end());
  return {"disputed_triangles",
          std::to_string(all.disputed.size()) + " of " + counted(all.faces.size(), "triangle", "triangles") +
              " are not in the stars of all three corners.",
          all.disputed.size(), worst_first(std::move(places))};
}

[[noreturn]] void refuse(const Fault& fault, const Fault& disputed, const KeptPoints& kept, Reconstruction& result) {
  result.findings.push_back(finding_of(Finding::Severity::refusal, fault, kept));
  if (disputed.count > 0) result.findings.push_back(finding_of(Finding::Severity::refusal, disputed, kept));
  throw SampleError(
      "the union of the planar stars is no surface: " + fault.message.substr(0, fault.message.size() - 1) +
          ", the worst at point " + std::to_string(kept.sample[fault.places.front()]),
      "choose a reconstructor that settles what stars dispute, or sample more densely there, without lattices",
      std::move(result.findings));
}

}  // namespace

Reconstruction StarSurface::reconstruct(const PointSample& sample, const Tangents& tangents, const Control& control,
                                        std::span<const Index> kept_indices, RunContext& context) const {
  context.throw_if_cancelled();
  const KeptPoints kept = kept_points(sample, tangents, control, kept_indices);
  const Neighbours neighbours(kept.points);
  const PlanarStars stars(neighbours, kept.normals, sample_reach(kept.points), context, {0, 0.6});
  std::vector<double> farthest;
  for (const double psi : kept.psi) farthest.push_back(face_radius_bound * psi);

  Reconstruction result;
  const StarAgreement agreed = agreement(stars, kept.points, farthest);
  context.measure("inconsistent_stars", agreed.inconsistent);
  context.measure("star_ties", agreed.ties);
  StarUnion all = union_of(stars, kept.points, farthest);
  context.progress(0.7);
  context.throw_if_cancelled();
  const Fault disputed = disputed_triangles(all);
  if (const auto fault = orient_or_fault(all.faces, kept.points, settings_.boundary))
    refuse(*fault, disputed, kept, result);
  if (disputed.count > 0) result.findings.push_back(finding_of(Finding::Severity::note, disputed, kept));
  finish(result, std::move(all.faces), kept, sample, settings_.boundary);
  context.progress(1);
  return result;
}

}  // namespace geodrome
