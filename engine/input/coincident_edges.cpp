// SPDX-License-Identifier: MIT
#include "engine/input/coincident_edges.hpp"

#include <algorithm>
#include <cmath>

#include "engine/formats/number_text.hpp"
#include "engine/formats/remedies.hpp"
#include "engine/formats/text_stream.hpp"
#include "engine/input/findings.hpp"
#include "engine/input/float32_steps.hpp"
#include "engine/input/merge.hpp"
#include "engine/input/point_tree.hpp"
#include "geodrome/detail/connectivity.hpp"

namespace geodrome::input {
namespace {

using detail::DisjointSets;
using OpenEdges = std::span<const std::array<Index, 2>>;

// Six printed digits leave so much of the diagonal, but a gap that shows at the scale of its edges is one.
constexpr double printed_share = 1e-6, printed_share_of_edge = 0.01;
// Two roundings to float32 leave two steps along each axis; far from the origin that is a lot.
constexpr double float32_steps = 4, float32_share_of_edge = 0.25;
// Shorter edges are no measure: their ends are one place, as at the poles of a globe.
constexpr double no_edge = 1e-12;

/// Open edges that lie on others.
struct Coincidence {
  Finding edges;                            ///< elements: a vertex of each
  double gap = 0;                           ///< the largest distance between what belongs together
  std::size_t components_gone = 0;          ///< how many components fewer there were if they were joined
  std::vector<std::array<Index, 2>> pairs;  ///< a vertex of each, and one of the edge that it lies on
};

double distance_from_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const double along = dot(p - a, b - a) / squared_norm(b - a);
  return distance(p, a + std::clamp(along, 0.0, 1.0) * (b - a));
}

class Matcher {
 public:
  Matcher(OpenEdges edges, const Input& input)
      : edges_(edges), input_(input), place_of_(input.positions.size(), no_index), settled_(edges.size()) {
    std::vector<Vec3> ends;
    for (const auto& edge : edges)
      for (const Index v : edge)
        if (place_of_[v] == no_index)
          place_of_[v] = static_cast<Index>(ends.size()), ends.push_back(input.positions[v]);
    const MergedPoints merged = merge_equal_points(ends);
    for (Index& place : place_of_)
      if (place != no_index) place = merged.element_of_row[place];
    places_ = merged.positions;
  }

  void run() {
    reaches_ = reaches();
    match(join());
    find_along();
    count_components(equal_), count_components(along_);
  }

  Coincidence take_equal() { return std::move(equal_); }
  Coincidence take_along() { return std::move(along_); }

 private:
  /// Finds edges with the same ends. `first_of`: per place the first of those that are the same.
  void match(const std::vector<Index>& first_of) {
    struct Key {
      Index low, high, edge;
      auto operator<=>(const Key&) const = default;
    };
    std::vector<Key> keys;
    for (Index e = 0; e < edges_.size(); ++e) {
      const auto [low, high] = std::minmax({first_of[place_of_[edges_[e][0]]], first_of[place_of_[edges_[e][1]]]});
      if (low != high)
        keys.push_back({low, high, e});
      else
        settled_[e] = true;  // a point
    }
    std::ranges::sort(keys);
    const auto same = [](const Key& a, const Key& b) { return a.low == b.low && a.high == b.high; };
    for (auto first = keys.begin(); first != keys.end();) {
      const auto end = std::find_if_not(first, keys.end(), [&](const Key& key) { return same(key, *first); });
      if (end - first > 1)
        for (auto key = first; key != end; ++key) add_equal(first->edge, key->edge);
      first = end;
    }
  }

  /// How far from a place another one may lie to be the same, by the shortest open edge there.
  std::vector<double> reaches() const {
    const double diagonal = input_.facts.bounding_box_diagonal, step = float32_step(input_.positions);
    std::vector<double> shortest(places_.size(), infinity);
    for (const auto& [a, b] : edges_) {
      const double length = distance(input_.positions[a], input_.positions[b]);
      if (length <= no_edge * diagonal) continue;
      for (const Index v : {a, b}) shortest[place_of_[v]] = std::min(shortest[place_of_[v]], length);
    }
    for (double& reach : shortest)
      reach = std::max(std::min(printed_share * diagonal, printed_share_of_edge * reach),
                       std::min(float32_steps * step, float32_share_of_edge * reach));
    return shortest;
  }

  /// Per place: the first of those that are the same.
  std::vector<Index> join() const {
    PointTree tree = tree_of(places_);
    std::vector<bool> taken(places_.size());
    std::vector<Index> first(places_.size());
    for (Index place = 0; place < places_.size(); ++place) {
      if (taken[place]) continue;
      first[place] = place;
      take_joined(
          tree, places_, place, taken, [&](Index at) { return reaches_[at]; },
          [&](Index at, Index near) { return distance(places_[at], places_[near]) <= reaches_[near]; },
          [&](Index near) {
            first[near] = place;
            return true;
          });
    }
    return first;
  }

  void add_equal(Index first, Index edge) {
    settled_[first] = settled_[edge] = true;
    const auto gap = [&](int a, int b) { return distance(end(first, a), end(edge, b)); };
    const double along = std::max(gap(0, 0), gap(1, 1)), against = std::max(gap(0, 1), gap(1, 0));
    add(equal_, edge, first, std::min(along, against));
  }

  /// Finds edges that lie along a longer one, as where one side of a seam has more vertices than the other.
  void find_along() {
    using boost::geometry::index::intersects;
    using Box = boost::geometry::model::box<TreePoint>;
    std::vector<std::pair<Box, Index>> boxes;
    for (Index e = 0; e < edges_.size(); ++e)
      if (!settled_[e]) boxes.emplace_back(box_around(end(e, 0), end(e, 1)), e);
    const boost::geometry::index::rtree<std::pair<Box, Index>, boost::geometry::index::linear<16>> tree(boxes);
    for (const auto& [own, edge] : boxes) {
      // Both ends are asked for: edges that meet at a point all have it in their boxes.
      const auto near = intersects(box_around(end(edge, 0), end(edge, 0), reach(edge, 0))) &&
                        intersects(box_around(end(edge, 1), end(edge, 1), reach(edge, 1)));
      for (auto at = tree.qbegin(near); at != tree.qend(); ++at) {
        const double first = distance_from_segment(end(edge, 0), end(at->second, 0), end(at->second, 1)),
                     second = distance_from_segment(end(edge, 1), end(at->second, 0), end(at->second, 1));
        if (at->second == edge || first > reach(edge, 0) || second > reach(edge, 1)) continue;
        add(along_, edge, at->second, std::max(first, second));
        break;
      }
    }
  }

  void add(Coincidence& found, Index edge, Index on, double gap) const {
    add_element(found.edges, edges_[edge][0]);
    found.gap = std::max(found.gap, gap);
    found.pairs.push_back({edges_[edge][0], edges_[on][0]});
  }

  void count_components(Coincidence& found) const {
    if (found.pairs.empty()) return;
    DisjointSets sets(input_.positions.size());
    for (const Triangle& triangle : input_.triangles)
      sets.unite(triangle[0], triangle[1]), sets.unite(triangle[0], triangle[2]);
    for (const auto& [a, b] : found.pairs) {
      found.components_gone += sets.find(a) != sets.find(b);
      sets.unite(a, b);
    }
  }

  const Vec3& end(Index edge, int which) const { return input_.positions[edges_[edge][which]]; }
  double reach(Index edge, int which) const { return reaches_[place_of_[edges_[edge][which]]]; }

  OpenEdges edges_;
  const Input& input_;
  std::vector<Index> place_of_;  // per vertex: its place among those of open edges; no_index: none
  std::vector<Vec3> places_;
  std::vector<double> reaches_;  // per place
  std::vector<bool> settled_;    // per edge: matched, or no edge
  Coincidence equal_, along_;
};

/// A power of ten that is at least twice the gap.
double tolerance_above(double gap) { return std::pow(10, std::ceil(std::log10(2 * gap))); }

/// Welding with a tolerance that joins the edges; none where welding would refuse it. Precondition: gap > 0.
Remedy remedy_for(double gap, const Input& input) {
  const double tolerance = tolerance_above(gap);
  if (merge_points_within(input.positions, tolerance).chained != no_index) return {};
  return remedies::weld_within(number_text(tolerance));
}

std::string rest_of_message(const Coincidence& found, const Input& input) {
  TextOutput text;
  text.precision(3);
  if (found.gap > 0)
    text << "at most " << found.gap << " apart";
  else
    text << "at exactly the same place";
  text << " (the vertices named are on them); no path leads across";
  if (found.components_gone > 0)
    text << ", and " << input.facts.components << " components stay apart that would be "
         << input.facts.components - found.components_gone;
  return text.str() + ".";
}

}  // namespace

void tell_coincident_edges(OpenEdges open_edges, Input& input) {
  if (open_edges.empty()) return;
  Matcher matcher(open_edges, input);
  matcher.run();
  Coincidence equal = matcher.take_equal(), along = matcher.take_along();
  if (equal.gap > 0 || equal.components_gone > 0) {
    std::string text = counted(equal.edges.count, "open edge lies", "open edges lie") + " on another one, " +
                       rest_of_message(equal, input);
    equal.edges.remedy = equal.gap > 0 ? remedy_for(equal.gap, input) : remedies::weld();
    report(input.findings, std::move(equal.edges), Finding::Severity::warning, "coincident_edges", std::move(text));
  }
  std::string text = counted(along.edges.count, "open edge lies", "open edges lie") + " along a longer one, " +
                     rest_of_message(along, input);
  along.edges.remedy = "split the longer edges where the vertices of the shorter ones lie";
  report(input.findings, std::move(along.edges), Finding::Severity::warning, "edges_along_edges", std::move(text));
}

}  // namespace geodrome::input
