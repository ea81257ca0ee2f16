// SPDX-License-Identifier: MIT
#include "engine/jobs/pairs/searches.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <tuple>

#include "engine/checks/pair_audit.hpp"
#include "engine/formats/number_text.hpp"
#include "engine/search/distances.hpp"
#include "engine/search/parallel_rows.hpp"
#include "engine/search/rows.hpp"

namespace geodrome {

namespace {

/// Places with the same key are the same source.
auto key_of(const Place& place) {
  const Vec3& p = place.position;
  const bool inside = place.vertex == no_index;  // a vertex is one place on each of its faces
  return std::tuple(place.state, place.vertex, inside ? place.at.face : no_index,
                    inside ? place.at.b : std::array<double, 3>{}, p.x, p.y, p.z);
}

/// The pairs that begin at the same place, each group in the order of the pairs.
std::vector<std::vector<std::size_t>> by_source(std::span<const NamedPair> pairs) {
  std::vector<std::size_t> order(pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t i) { return key_of(pairs[i].from.place); };
  std::ranges::stable_sort(order, {}, key);
  std::vector<std::vector<std::size_t>> groups;
  for (const std::size_t i : order) {
    if (groups.empty() || key(groups.back().front()) != key(i)) groups.emplace_back();
    groups.back().push_back(i);
  }
  return groups;
}

/// Up to rounding: a search for other targets may add up a path in another order.
bool are_same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= float64_tolerance * std::abs(b);
}

/// The distances of the pairs of a group, whose source is the same, flat and smooth.
SmoothFigures search_group(const PlacedSurface& surface, const PreparedSolver& solver, Search& search,
                           std::span<const NamedPair> pairs, const std::vector<std::size_t>& group, RunContext& context,
                           SearchedPairs& result) {
  std::vector<NamedPoint> ends;
  for (const std::size_t i : group) ends.push_back(pairs[i].to);
  const TargetList targets(std::move(ends), surface);
  const NamedPoint& source = pairs[group.front()].from;
  std::vector<double> row(group.size());
  const ShortestPathMap* map = distance_row(solver, search, source, targets, infinity, context, row, Keep::map);
  for (std::size_t j = 0; j < group.size(); ++j) result.flat[group[j]] = row[j];
  SmoothFigures paths;
  if (map) paths = smooth_row(solver, *map, source, targets, infinity, row);
  for (std::size_t j = 0; j < group.size(); ++j) result.smooth[group[j]] = row[j];
  return paths;
}

}  // namespace

SearchedPairs search_pairs(const PlacedSurface& surface, const PreparedSolver& solver, std::span<const NamedPair> pairs,
                           const RunSettings& settings, Observer& observer) {
  for (const auto& [from, to] : pairs)
    check_provides(solver.plugin.info, ProjectionRule::project, {&from, 1}, {&to, 1}, infinity);
  const std::vector<std::vector<std::size_t>> groups = by_source(pairs);
  SearchedPairs result{.flat = std::vector<double>(pairs.size()), .smooth = std::vector<double>(pairs.size())};
  result.searches = groups.size();
  std::vector<SmoothFigures> paths(groups.size());
  const unsigned threads = thread_count(settings);
  WithoutProgress quiet(observer);
  StageContext context("queries", observer, threads, settings.seed), within("queries", quiet, 1, settings.seed);
  std::atomic<std::uint64_t> done = 0;
  const auto make_worker = [&]() -> RowWorker {
    return [&, search = std::shared_ptr(make_search(solver))](std::uint64_t number) {
      paths[number] = search_group(surface, solver, *search, pairs, groups[number], within, result);
      context.progress(static_cast<double>(++done) / static_cast<double>(groups.size()));
    };
  };
  run_rows(groups.size(), threads, make_worker, context);
  for (const SmoothFigures& of_group : paths) result.paths.add(of_group);
  return result;
}

std::vector<std::string> audit_searched(const PlacedSurface& surface, const PreparedSolver& solver,
                                        std::span<const NamedPair> pairs, std::span<const double> distances,
                                        const RunSettings& settings, Observer& observer) {
  if (pairs.empty()) return {};
  std::vector<std::size_t> some{0, pairs.size() / 2, pairs.size() - 1};
  some.erase(std::unique(some.begin(), some.end()), some.end());
  std::vector<NamedPair> chosen;
  for (const std::size_t i : some) chosen.push_back(pairs[i]);
  const SearchedPairs found = search_pairs(surface, solver, chosen, settings, observer);
  for (std::size_t k = 0; k < some.size(); ++k)
    if (!are_same(distances[some[k]], found.smooth[k]))
      return {"pair " + std::to_string(some[k]) + " is " + number_text(distances[some[k]]) + " apart, measured again " +
              number_text(found.smooth[k])};
  StageContext context("audit", observer, 1, settings.seed);
  const PairAudit audit = audit_pairs(*surface.mesh, solver, chosen, found.flat, context, true);
  return broken_promises(audit, some[audit.worst_pair]);
}

}  // namespace geodrome
