// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/open_sheets.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "plugins/common/points/boundary_points.hpp"
#include "plugins/common/points/live_points.hpp"
#include "plugins/common/surfaces/manifold_faces.hpp"

namespace geodrome {
namespace {

/// Points of a rim may be on no face; more are a sign that stars disagree too much for a sheet.
constexpr double most_unused = 0.02;

}  // namespace

OpenSheets::OpenSheets(const PointSample& sample, const Control& control, const KeptPoints& kept, RunContext& context)
    : all_(live_points(sample, control.state).points), sample_{kept, {}, all_} {
  const std::vector<double> spacing = boundary_spacing(sample, control, context, {0, 0});
  for (const Index i : kept.sample) sample_.spacing.push_back(spacing[i]), any_ = any_ || spacing[i] > 0;
}

bool OpenSheets::shown_by(std::span<const Index> members) const {
  return std::ranges::any_of(members, [&](Index p) { return sample_.spacing[p] > 0; });
}

std::vector<Index> OpenSheets::closed_rim(std::span<const Index> members, std::span<const Triangle> faces) const {
  std::map<std::pair<Index, Index>, int> edges;
  for (const Triangle& t : faces)
    for (int i = 0; i < 3; ++i) ++edges[std::minmax(t[i], t[(i + 1) % 3])];
  std::set<Index> used, border;
  for (const auto& [edge, count] : edges) {
    used.insert({edge.first, edge.second});
    if (count == 1) border.insert({edge.first, edge.second});
  }
  std::vector<Index> shown, closed;
  for (const Index p : members) {
    if (!(sample_.spacing[p] > 0)) continue;
    shown.push_back(p);
    if (used.contains(p) && !border.contains(p)) closed.push_back(p);
  }
  return 2 * closed.size() > shown.size() ? closed : std::vector<Index>();
}

bool is_whole(const SheetSurface& sheet, std::size_t points) {
  std::set<Index> used;
  for (const Triangle& t : sheet.faces) used.insert(t.begin(), t.end());
  return sheet.pockets == 0 &&
         static_cast<double>(points - used.size()) <= most_unused * static_cast<double>(points) + 1;
}

void orient_sheet(SheetSurface& sheet, const KeptPoints& kept, Reconstruction& result) {
  const detail::Connectivity connectivity = detail::connect(sheet.faces, kept.points.size());
  const std::vector<Index> impossible = orient_alike(sheet.faces, connectivity.twins);
  if (impossible.empty()) return orient_outwards(sheet.faces, kept.points);
  std::vector<Index> places;
  for (const Index h : impossible) places.push_back(kept.sample[sheet.faces[h / 3][h % 3]]);
  result.findings.push_back(finding(Finding::Severity::refusal, "one_sided",
                                    "the sheet is one-sided, as a Moebius strip is: a way around it comes back on the "
                                    "other side, past the points named for one.",
                                    places.size(), places));
  throw SampleError(
      "the sheet that the points show is one-sided, as a Moebius strip is, and a surface of a sample "
      "must have two sides",
      "more points will not help: give the strip as a mesh, or leave out a row of points across it, so that it is "
      "cut open",
      std::move(result.findings));
}

}  // namespace geodrome
