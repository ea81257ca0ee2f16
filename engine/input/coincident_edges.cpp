// SPDX-License-Identifier: MIT
#include "engine/input/coincident_edges.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "engine/formats/number_text.hpp"
#include "engine/formats/remedies.hpp"
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

/// Open edges that lie on each other.
struct Coincidence {
  Finding edges;                    ///< elements: a vertex of each
  double gap = 0;                   ///< the largest distance between ends that belong together
  std::size_t components_gone = 0;  ///< how many components fewer there were if they were joined
};

class Matcher {
 public:
  Matcher(OpenEdges edges, const Input& input)
      : edges_(edges), input_(input), place_of_(input.positions.size(), no_index) {
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

  Coincidence run() {
    DisjointSets sets = join(reaches());
    struct Key {
      Index low, high, edge;
      auto operator<=>(const Key&) const = default;
    };
    std::vector<Key> keys;
    for (Index e = 0; e < edges_.size(); ++e) {
      const auto [low, high] = std::minmax({sets.find(place_of_[edges_[e][0]]), sets.find(place_of_[edges_[e][1]])});
      if (low != high) keys.push_back({low, high, e});
    }
    std::ranges::sort(keys);
    const auto same = [](const Key& a, const Key& b) { return a.low == b.low && a.high == b.high; };
    for (auto first = keys.begin(); first != keys.end();) {
      const auto end = std::find_if_not(first, keys.end(), [&](const Key& key) { return same(key, *first); });
      if (end - first > 1)
        for (auto key = first; key != end; ++key) add(edges_[first->edge], edges_[key->edge]);
      first = end;
    }
    if (!pairs_.empty()) count_components();
    return std::move(found_);
  }

 private:
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

  DisjointSets join(const std::vector<double>& reaches) const {
    const PointTree tree = tree_of(places_);
    DisjointSets sets(places_.size());
    for (Index place = 0; place < places_.size(); ++place)
      for (const Index near : places_near(tree, places_[place], reaches[place]))
        if (distance(places_[place], places_[near]) <= reaches[near]) sets.unite(place, near);
    return sets;
  }

  void add(const std::array<Index, 2>& first, const std::array<Index, 2>& edge) {
    add_element(found_.edges, edge[0]);
    const auto gap = [&](Index a, Index b) { return distance(input_.positions[a], input_.positions[b]); };
    const double along = std::max(gap(first[0], edge[0]), gap(first[1], edge[1])),
                 against = std::max(gap(first[0], edge[1]), gap(first[1], edge[0]));
    found_.gap = std::max(found_.gap, std::min(along, against));
    pairs_.push_back({first[0], edge[0]});  // any vertex of an edge stands for its component
  }

  void count_components() {
    DisjointSets sets(input_.positions.size());
    for (const Triangle& triangle : input_.triangles)
      sets.unite(triangle[0], triangle[1]), sets.unite(triangle[0], triangle[2]);
    for (const auto& [a, b] : pairs_) {
      found_.components_gone += sets.find(a) != sets.find(b);
      sets.unite(a, b);
    }
  }

  OpenEdges edges_;
  const Input& input_;
  std::vector<Index> place_of_;  // per vertex: its place among those of open edges; no_index: none
  std::vector<Vec3> places_;
  std::vector<std::array<Index, 2>> pairs_;  // vertices of edges that lie on each other
  Coincidence found_;
};

/// A power of ten that is at least twice the gap.
double tolerance_above(double gap) { return std::pow(10, std::ceil(std::log10(2 * gap))); }

/// Welding with a tolerance that joins the edges; none where welding would refuse it. Precondition: gap > 0.
Remedy remedy_for(double gap, const Input& input) {
  const double tolerance = tolerance_above(gap);
  if (merge_points_within(input.positions, tolerance).chained != no_index) return {};
  return remedies::weld_within(number_text(tolerance));
}

}  // namespace

void tell_coincident_edges(OpenEdges open_edges, Input& input) {
  if (open_edges.empty()) return;
  Coincidence found = Matcher(open_edges, input).run();
  if (found.gap == 0 && found.components_gone == 0) return;
  const std::size_t count = found.edges.count;
  std::ostringstream text;
  text.precision(3);
  text << counted(count, "open edge lies", "open edges lie") << " on another one, ";
  if (found.gap > 0)
    text << "at most " << found.gap << " apart";
  else
    text << "at exactly the same place";
  text << " (the vertices named are on them); no path leads across";
  if (found.components_gone > 0)
    text << ", and " << input.facts.components << " components stay apart that would be "
         << input.facts.components - found.components_gone;
  found.edges.remedy = found.gap > 0 ? remedy_for(found.gap, input) : remedies::weld();
  report(input.findings, std::move(found.edges), Finding::Severity::warning, "coincident_edges", text.str() + ".");
}

}  // namespace geodrome::input
