// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/orient_normals.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace geodrome {
namespace {

/// An undirected edge, the surest first, ties by index.
struct Adjacency {
  double agreement;  ///< in [-1, 1]: 1 if the normals certainly look to one side, -1 if certainly not
  Index a, b;
  bool operator<(const Adjacency& other) const {
    const double sure = std::abs(agreement), other_sure = std::abs(other.agreement);
    return sure != other_sure ? sure > other_sure : std::pair(a, b) < std::pair(other.a, other.b);
  }
};

/// The normal at the other end of an edge if the surface bends evenly between: reflected in the plane across the edge
/// (Koenig and Gumhold 2009). So an edge over a crease, or across a thin sheet, counts right as well.
double agreement(const Vec3& a, const Vec3& b, const Vec3& normal_a, const Vec3& normal_b) {
  const Vec3 edge = b - a;
  const Vec3 expected = normal_a - (2 * dot(normal_a, edge) / squared_norm(edge)) * edge;
  return dot(expected, normal_b);
}

/// Disjoint sets whose elements know if they are turned relative to their set's representative.
class TurnedSets {
 public:
  explicit TurnedSets(std::size_t count) : parent_(count), turned_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  Index find(Index element) {
    Index root = element;
    char turned = 0;
    while (parent_[root] != root) turned ^= turned_[root], root = parent_[root];
    while (parent_[element] != root && element != root) {  // compress: what is left of the way's turns goes along
      const Index next = parent_[element];
      const char own = turned_[element];
      parent_[element] = root, turned_[element] = turned;
      turned ^= own, element = next;
    }
    return root;
  }
  /// After `find(element)`.
  bool turned(Index element) const { return parent_[element] != element && turned_[element]; }

  void unite(Index a, Index b, bool opposite) {
    const Index root_a = find(a), root_b = find(b);
    if (root_a == root_b) return;
    const char turn = static_cast<char>(turned(a) ^ turned(b) ^ opposite);
    parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
    turned_[std::max(root_a, root_b)] = turn;
  }

 private:
  std::vector<Index> parent_;
  std::vector<char> turned_;
};

std::vector<Adjacency> adjacencies(const PlanarStars& stars, std::span<const Vec3> points,
                                   std::span<const Vec3> normals, std::span<const double> psi, double edge_bound) {
  std::vector<Adjacency> edges;
  for (Index s = 0; s < stars.size(); ++s)
    for (const StarCorner& corner : stars(s)) {
      const auto [low, high] = std::minmax(s, corner.site);
      if (distance(points[low], points[high]) > edge_bound * std::min(psi[low], psi[high])) continue;
      edges.push_back({agreement(points[low], points[high], normals[low], normals[high]), low, high});
    }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// At a piece's extreme point in a direction the surface lies on one side: its normal there looks along the direction.
bool looks_inwards(const std::vector<Index>& piece, std::span<const Vec3> points, const std::vector<Vec3>& normals) {
  double vote = 0;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z) {
        const Vec3 direction{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
        const Index extreme = *std::max_element(piece.begin(), piece.end(), [&](Index a, Index b) {
          return dot(points[a], direction) < dot(points[b], direction);
        });
        if (x != 0 || y != 0 || z != 0) vote += dot(normals[extreme], direction) / norm(direction);
      }
  return vote < 0;
}

}  // namespace

OrientedSample orient(const PlanarStars& stars, std::span<const Vec3> points, std::span<const Vec3> normals,
                      std::span<const double> psi, double edge_bound) {
  TurnedSets sets(points.size());
  for (const Adjacency& edge : adjacencies(stars, points, normals, psi, edge_bound))
    sets.unite(edge.a, edge.b, edge.agreement < 0);
  OrientedSample result{{normals.begin(), normals.end()}, {}};
  std::vector<Index> piece_of(points.size(), no_index);
  for (Index i = 0; i < points.size(); ++i) {
    const Index root = sets.find(i);
    if (sets.turned(i)) result.normals[i] = -normals[i];
    if (piece_of[root] == no_index) {
      piece_of[root] = static_cast<Index>(result.pieces.size());
      result.pieces.emplace_back();
    }
    result.pieces[piece_of[root]].push_back(i);
  }
  for (const std::vector<Index>& piece : result.pieces)
    if (looks_inwards(piece, points, result.normals))
      for (const Index i : piece) result.normals[i] = -result.normals[i];
  return result;
}

}  // namespace geodrome
