// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/steiner_graph.hpp"

#include <algorithm>
#include <map>

#include "tests/plugins/solver_aleksandrov/intrinsic_fixture.hpp"

namespace geodrome::aleksandrov::test {
namespace {

/// Nearer to an end of an edge than this share of its length, rounding may say that a way misses it.
constexpr double grazing = 1e-9;

struct Pair {
  double length;
  bool clear;  ///< not by rounding
};
/// By both ends: there may be several ways.
using Pairs = std::map<std::pair<Index, Index>, std::vector<Pair>>;

/// What the graph says: notes all that is joined to one node.
struct Listed {
  const SteinerGraph& graph;
  Index node;
  Pairs& pairs;

  void via(Index, Point2, Index) const {}
  void vertex(Index corner, double length) const { point(graph.corner(corner).vertex, length); }
  void strip(const SteinerGraph::Strip& s) const {
    for (Index to = s.first; to < s.last; ++to) point(to, SteinerGraph::length(s, graph.distances()[to]));
  }
  bool wants(Index, double) const { return true; }
  void point(Index to, double length) const { pairs[{node, to}].push_back({length, true}); }
};

/// What geometry says, by trying every pair of nodes of faces on an edge.
class BruteForce {
 public:
  BruteForce(const IntrinsicTriangulation& t, const SteinerGraph& graph) : t_(t), graph_(graph) {}

  void try_all() {
    for (Index h = 0; h < 3 * t_.face_count(); ++h) {
      within_face(h);
      for (Index g = t_.next_on_edge(h); g != h; g = t_.next_on_edge(g))
        for (const auto& [from, p] : nodes_on(h))
          for (const auto& [to, q] : nodes_on(g)) across(from, to, h, p, unfolded(h, g, q));
    }
  }
  Pairs pairs;

  /// The nodes of a face that look through its half-edge h: of the bisectors at its ends, and the corner opposite.
  std::vector<std::pair<Index, Point2>> nodes_on(Index h) const {
    const Index next = SurfaceMesh::next(h);
    std::vector<std::pair<Index, Point2>> nodes{{t_.from(SurfaceMesh::previous(h)), t_.apex(h)}};
    for (const Index corner : {h, next})
      for (Index n = graph_.corner(corner).first; n < graph_.corner(corner).last; ++n) nodes.emplace_back(n, at(h, n));
    return nodes;
  }
  Point2 unfolded(Index h, Index g, Point2 q) const { return {t_.same_way(g, h) ? q.x : t_.length(h) - q.x, -q.y}; }
  void across(Index from, Index to, Index h, Point2 p, Point2 q) {
    const double x = p.x + (q.x - p.x) * p.y / (p.y - q.y), margin = grazing * t_.length(h);
    if (x < -margin || x > t_.length(h) + margin) return;
    pairs[{from, to}].push_back({length(p - q), x > margin && x < t_.length(h) - margin});
  }

 private:
  /// By the angle, not by the graph's own change of frames.
  Point2 at(Index h, Index node) const {
    const Index corner = graph_.corner_of(node);
    const double t = graph_.distances()[node], half = angle(t_, corner) / 2;
    if (corner == h) return {t * std::cos(half), t * std::sin(half)};
    return {t_.length(h) - t * std::cos(half), t * std::sin(half)};
  }
  void within_face(Index h) {
    const Index a = t_.from(h), b = t_.from(SurfaceMesh::next(h)), c = t_.from(SurfaceMesh::previous(h));
    pairs[{a, b}].push_back({t_.length(h), true});
    pairs[{b, a}].push_back({t_.length(h), true});
    for (Index n = graph_.corner(h).first; n < graph_.corner(h).last; ++n) {
      const Point2 p = at(h, n), ends[] = {{0, 0}, {t_.length(h), 0}, t_.apex(h)};
      const Index corners[] = {a, b, c};
      for (int i = 0; i < 3; ++i)
        for (const auto& ordered : {std::pair(n, corners[i]), std::pair(corners[i], n)})
          pairs[ordered].push_back({length(p - ends[i]), true});
    }
  }

  const IntrinsicTriangulation& t_;
  const SteinerGraph& graph_;
};

/// Whether every pair that is clear in `a` is in `b`.
void expect_contained(const Pairs& a, const Pairs& b, const char* what) {
  for (const auto& [ends, ways] : a) {
    const auto found = b.find(ends);
    for (const Pair& way : ways) {
      if (!way.clear) continue;
      ASSERT_NE(found, b.end()) << what << ends.first << " - " << ends.second << ", " << way.length;
      const auto same = [&](const Pair& other) {
        return std::abs(other.length - way.length) <= 1e-12 * (1 + way.length);
      };
      ASSERT_TRUE(std::any_of(found->second.begin(), found->second.end(), same))
          << what << ends.first << " - " << ends.second << ", " << way.length;
    }
  }
}

/// Calls `check(triangulation, graph)` for each mesh, as it is and much changed.
template <class Check>
void for_each_graph(Check&& check) {
  Random random(1);
  for (const auto& [name, mesh] : fair_meshes(2))
    for (const int changes : {0, 30}) {
      SCOPED_TRACE(name + ", changes " + std::to_string(changes));
      const PackedMesh surface(mesh);
      IntrinsicTriangulation t(surface, tiny);
      change_often(t, changes, random);
      check(t, SteinerGraph(t, {t, Placement::thin, 1, 1}));
    }
}

TEST(SteinerGraph, JoinsNodesThatSeeEachOtherThroughAnEdgeAndNoOthers) {
  std::size_t edges = 0;
  for_each_graph([&](const IntrinsicTriangulation& t, const SteinerGraph& graph) {
    Pairs listed;
    for (Index node = 0; node < graph.node_count(); ++node) graph.for_each_edge(node, Listed{graph, node, listed});
    BruteForce all(t, graph);
    all.try_all();
    expect_contained(all.pairs, listed, "not joined: ");
    Pairs brute = all.pairs;
    for (auto& [ends, ways] : brute)
      for (Pair& way : ways) way.clear = true;
    expect_contained(listed, brute, "joined, and they do not see each other: ");
    edges += listed.size();
  });
  EXPECT_GT(edges, 100000u);
}

/// Up to rounding at the ends of edges.
TEST(SteinerGraph, HasEveryEdgeInBothDirections) {
  for_each_graph([](const IntrinsicTriangulation& t, const SteinerGraph& graph) {
    Pairs listed, turned;
    for (Index node = 0; node < graph.node_count(); ++node) graph.for_each_edge(node, Listed{graph, node, listed});
    BruteForce all(t, graph);
    all.try_all();
    for (const auto& [ends, ways] : all.pairs)
      for (const Pair& way : ways) {
        // What only grazes an edge may be seen from one end.
        if (!way.clear) listed[ends].push_back(way);
      }
    for (const auto& [ends, ways] : listed)
      for (const Pair& way : ways) turned[{ends.second, ends.first}].push_back(way);
    expect_contained(turned, listed, "one way only: ");
  });
}

/// A place inside a face sees the corners of its face, and the rest through each of its three edges.
TEST(SteinerGraph, JoinsAnyPlaceToWhatItSees) {
  Random random(3);
  for_each_graph([&](const IntrinsicTriangulation& t, const SteinerGraph& graph) {
    const Index place = graph.node_count();  // its name here
    for (int n = 0; n < 50; ++n) {
      const SurfacePoint at{static_cast<Index>(random.index(t.face_count())), random_coordinates(random)};
      Pairs listed;
      graph.for_each_edge(at, Listed{graph, place, listed});
      BruteForce all(t, graph);
      for (Index h = 3 * at.face; h < 3 * at.face + 3; ++h) {
        const Point2 p = aleksandrov::place({Point2{0, 0}, Point2{t.length(h), 0}, t.apex(h)},
                                            {at.b[h % 3], at.b[(h + 1) % 3], at.b[(h + 2) % 3]});
        all.pairs[{place, t.from(h)}].push_back({length(p), true});
        for (Index g = t.next_on_edge(h); g != h; g = t.next_on_edge(g))
          for (const auto& [to, q] : all.nodes_on(g)) all.across(place, to, h, p, all.unfolded(h, g, q));
      }
      expect_contained(all.pairs, listed, "not joined: ");
      for (auto& [ends, ways] : all.pairs)
        for (Pair& way : ways) way.clear = true;
      expect_contained(listed, all.pairs, "joined, and they do not see each other: ");
    }
  });
}

}  // namespace
}  // namespace geodrome::aleksandrov::test
