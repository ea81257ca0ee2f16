// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/sheet_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "geodrome/vertex_components.hpp"
#include "plugins/common/points/boundary_points.hpp"
#include "plugins/common/surfaces/manifold_faces.hpp"
#include "plugins/reconstructor_delaunay_cut/sheet_fans.hpp"

namespace geodrome {
namespace {

/// psi of a uniform sample, which gives the spacing away from boundaries.
constexpr double psi_spacings = 2;

struct Candidate {
  int holders;
  double radius;
  Triangle corners;
};

bool goes_before(const Candidate& a, const Candidate& b, const SheetRule& rule) {
  if (a.holders != b.holders) return a.holders > b.holders;
  if (a.radius != b.radius) return a.radius < b.radius;
  return rule.before(a.corners, b.corners);
}

std::vector<Candidate> candidates_of(const SheetRule& rule, const PlanarStars& stars, std::span<const Index> members) {
  std::vector<Triangle> triangles;
  for (const Index s : members) {
    const std::span<const StarCorner> star = stars(s);
    for (std::size_t i = 0; i < star.size(); ++i)
      if (star[i].real)
        triangles.push_back(rule.in_order({s, star[i == 0 ? star.size() - 1 : i - 1].site, star[i].site}));
  }
  std::ranges::sort(triangles);
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  std::vector<Candidate> found;
  for (const Triangle& t : triangles)
    if (rule.allows(t)) found.push_back({stars.holders(t), rule.radius(t), t});
  std::ranges::sort(found, [&](const Candidate& a, const Candidate& b) { return goes_before(a, b, rule); });
  return found;
}

using Edge = std::pair<Index, Index>;
Edge edge_of(Index a, Index b) { return std::minmax(a, b); }

/// The boundary loops, as the open edges of each.
class Loops {
 public:
  /// `steps` tells how many spacings an edge is long.
  template <class Steps>
  Loops(const SheetFans& fans, std::span<const Index> members, const Steps& steps) {
    std::vector<std::pair<Edge, Edge>> joined;
    for (const Index p : members)
      for (const auto& [from, to] : fans.gaps(p)) joined.emplace_back(edge_of(p, from), edge_of(p, to));
    for (const auto& [a, b] : joined) place_.try_emplace(a, 0), place_.try_emplace(b, 0);
    Index count = 0;
    for (auto& [edge, place] : place_) place = count++;
    detail::DisjointSets sets(count);
    for (const auto& [a, b] : joined) sets.unite(place_.at(a), place_.at(b));
    loop_.resize(count), around_.resize(count, 0);
    for (const auto& [edge, place] : place_) around_[loop_[place] = sets.find(place)] += steps(edge);
  }

  /// Tells whether the edge is in a loop that no boundary is as short as, or came later.
  bool small(const Edge& edge) const {
    const auto found = place_.find(edge);
    return found == place_.end() || around_[loop_[found->second]] < least_boundary;
  }
  std::size_t count_small() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(around_, [](double steps) { return steps > 0 && steps < least_boundary; }));
  }

 private:
  std::map<Edge, Index> place_;
  std::vector<Index> loop_;
  std::vector<double> around_;
};

class Sheet {
 public:
  Sheet(const SheetSample& sample, std::span<const Index> members)
      : sample_(sample), members_(members), rule_(sample), fans_(sample.kept.points, sample.kept.normals) {}

  SheetSurface make(const PlanarStars& stars, bool close_thin) {
    for (const Candidate& c : candidates_of(rule_, stars, members_))
      if (fans_.fits(c.corners)) fans_.add(c.corners);
    join_left_out(stars);
    close_corners([](Index, Index, Index) { return true; }, true);
    SheetSurface result;
    if (close_thin) {
      const Loops loops = this->loops();
      const std::size_t before = fans_.faces().size();
      close_corners(
          [&](Index at, Index a, Index b) { return loops.small(edge_of(at, a)) && loops.small(edge_of(at, b)); },
          false);
      tell_thin(before, result);
    }
    result.faces = fans_.faces();
    drop_minor_fans(result.faces, sample_.kept.points.size());
    result.pockets = loops().count_small();
    return result;
  }

 private:
  using Ear = std::tuple<double, Triangle>;

  Loops loops() const {
    const KeptPoints& kept = sample_.kept;
    const auto spacing = [&](Index p) {
      return sample_.spacing[p] > 0 ? sample_.spacing[p] : kept.psi[p] / psi_spacings;
    };
    return Loops(fans_, members_, [&](const Edge& e) {
      return distance(kept.points[e.first], kept.points[e.second]) / std::min(spacing(e.first), spacing(e.second));
    });
  }

  /// Joins points that have no face yet, as corners of lattices where stars split ties otherwise, by the smallest
  /// triangle with two of their neighbours.
  void join_left_out(const PlanarStars& stars) {
    for (const Index p : members_) {
      if (fans_.uses(p)) continue;
      std::vector<Candidate> around;
      for (const StarCorner& a : stars(p))
        for (const StarCorner& b : stars(p)) {
          const Triangle t = rule_.in_order({p, a.site, b.site});
          if (a.site < b.site && rule_.allows(t)) around.push_back({0, rule_.radius(t), t});
        }
      std::ranges::sort(around, [&](const Candidate& a, const Candidate& b) { return goes_before(a, b, rule_); });
      for (const Candidate& c : around)
        if (fans_.fits(c.corners)) fans_.add(c.corners);
    }
  }

  /// Closes corners of boundary loops by the triangle of their two edges, the smallest first.
  template <class Wanted>
  void close_corners(const Wanted& wanted, bool by_rule) {
    const auto before = [this](const Ear& a, const Ear& b) {
      if (std::get<0>(a) != std::get<0>(b)) return std::get<0>(a) < std::get<0>(b);
      return rule_.before(std::get<1>(a), std::get<1>(b));
    };
    std::set<Ear, decltype(before)> ears(before);
    const auto look_at = [&](Index at) {
      for (const auto& [a, b] : fans_.gaps(at)) {
        if (!wanted(at, a, b)) continue;
        const Triangle corners = rule_.in_order({at, a, b});
        const double radius = rule_.radius(corners);
        if (std::isfinite(radius) && (by_rule ? rule_.allows(corners) : rule_.lies_flat(corners)))
          ears.emplace(radius, corners);
      }
    };
    for (const Index p : members_) look_at(p);
    while (!ears.empty()) {
      const Triangle corners = std::get<1>(*ears.begin());
      ears.erase(ears.begin());
      if (!fans_.fits(corners)) continue;
      fans_.add(corners);
      for (const Index p : corners) look_at(p);
    }
  }

  /// Thin places are groups of faces that the rule does not allow.
  void tell_thin(std::size_t before, SheetSurface& result) const {
    std::vector<Triangle> thin;
    for (std::size_t f = before; f < fans_.faces().size(); ++f)
      if (!rule_.allows(fans_.faces()[f])) thin.push_back(fans_.faces()[f]);
    std::map<Index, Index> component;
    const std::vector<Index> of = vertex_components(thin, sample_.kept.points.size());
    for (const Triangle& t : thin)
      for (const Index p : t) component[p] = of[p];
    std::set<Index> places;
    for (const auto& [p, place] : component) result.thin.push_back(p), places.insert(place);
    result.thin_places = places.size();
  }

  const SheetSample& sample_;
  std::span<const Index> members_;
  SheetRule rule_;
  SheetFans fans_;
};

}  // namespace

SheetSurface sheet_surface(const SheetSample& sample, const PlanarStars& stars, std::span<const Index> members,
                           bool close_thin) {
  return Sheet(sample, members).make(stars, close_thin);
}

}  // namespace geodrome
