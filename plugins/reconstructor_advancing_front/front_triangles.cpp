// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_advancing_front/front_triangles.hpp"

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "plugins/common_gpl/guarded.hpp"

namespace geodrome {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The ranks of the border edges of one front, in the order in which CGAL first names them.
class BorderRanks {
 public:
  std::size_t of(const void* edge) { return ranks_.try_emplace(edge, ranks_.size()).first->second; }
  void reset() { ranks_.clear(); }

 private:
  std::unordered_map<const void*, std::size_t> ranks_;
};
thread_local BorderRanks border_ranks;

/// CGAL's vertex with another order of candidates. CGAL keeps them in a set of pairs of a radius and the address of a
/// border edge, so that equal radii, as a lattice has them, are settled by addresses, which differ from call to call.
/// An address stands for one edge slot while a front lives, so ranks keep the same edges apart; and the first edge gets
/// the first rank whatever its address, so that by induction CGAL takes the same steps in every call.
template <class Base = CGAL::Triangulation_vertex_base_3<Kernel>>
class RankedVertex : public CGAL::Advancing_front_surface_reconstruction_vertex_base_3<Kernel, Base> {
  using Vertex = CGAL::Advancing_front_surface_reconstruction_vertex_base_3<Kernel, Base>;

 public:
  using Vertex::Vertex;
  template <class Structure>
  struct Rebind_TDS {
    using Other = RankedVertex<typename Base::template Rebind_TDS<Structure>::Other>;
  };

  struct Radius_ptr_type {
    typename Vertex::criteria first;
    typename Vertex::IO_edge_type* second;
    std::size_t rank;

    Radius_ptr_type(typename Vertex::criteria radius, typename Vertex::IO_edge_type* edge)
        : first(radius), second(edge), rank(border_ranks.of(edge)) {}
    bool operator<(const Radius_ptr_type& other) const {
      return std::tie(first, rank) < std::tie(other.first, other.rank);
    }
  };
};

/// A vertex or a cell that CGAL compares by its age. Those without are compared by address, and a facet is visited as
/// that of the lesser one of its two cells, which decides how a front begins.
template <class Base>
class Aged : public Base {
 public:
  using Base::Base;
  template <class Structure>
  struct Rebind_TDS {
    using Other = Aged<typename Base::template Rebind_TDS<Structure>::Other>;
  };

  using Has_timestamp = CGAL::Tag_true;
  std::size_t time_stamp() const { return age_; }
  void set_time_stamp(std::size_t age) { age_ = age; }

 private:
  std::size_t age_ = static_cast<std::size_t>(-1);  // CGAL's sign of one that has no age yet
};

using Cell = CGAL::Advancing_front_surface_reconstruction_cell_base_3<Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Aged<RankedVertex<>>, Aged<Cell>>>;

/// CGAL's own priority for what the rule allows.
struct RulePriority {
  const FaceRule* rule;

  template <class Front, class Cell>
  double operator()(const Front& front, Cell& cell, const int& index) const {
    std::array<std::size_t, 3> corner;
    for (int i = 0; i < 3; ++i) corner[i] = cell->vertex((index + 1 + i) % 4)->info();
    if (*std::max_element(corner.begin(), corner.end()) >= rule->points.size()) return front.infinity();
    if (!rule->allows(static_cast<Index>(corner[0]), static_cast<Index>(corner[1]), static_cast<Index>(corner[2])))
      return front.infinity();
    return front.smallest_radius_delaunay_sphere(cell, index);
  }
};

}  // namespace

std::vector<Triangle> front_triangles(const FaceRule& rule) {
  constexpr double radius_ratio_bound = 5, beta = 0.52;  // CGAL's own
  std::vector<std::pair<Kernel::Point_3, std::size_t>> points;
  for (const Vec3& p : rule.points) points.emplace_back(Kernel::Point_3(p.x, p.y, p.z), points.size());
  border_ranks.reset();
  return guarded([&] {
    Delaunay delaunay(points.begin(), points.end());
    CGAL::Advancing_front_surface_reconstruction<Delaunay, RulePriority> front(delaunay, RulePriority{&rule});
    front.run(radius_ratio_bound, beta);
    std::vector<Triangle> faces;
    if (delaunay.dimension() < 3) return faces;
    const auto& surface = front.triangulation_data_structure_2();
    for (auto face = surface.faces_begin(); face != surface.faces_end(); ++face) {
      if (!face->is_on_surface()) continue;
      const auto corner = [&](int i) { return static_cast<Index>(face->vertex(i)->vertex_3()->info()); };
      faces.push_back({corner(0), corner(1), corner(2)});
    }
    return faces;
  });
}

}  // namespace geodrome
