// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/tetrahedra.hpp"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "plugins/common_gpl/guarded.hpp"

namespace geodrome {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
using CellBase =
    CGAL::Triangulation_cell_base_with_info_3<Index, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

/// Sorts the corners by exchanges of three, which keep the orientation: at most the last two stay out of order.
/// `slot[i]` follows along.
void put_in_order(Tetrahedra::Cell& corners, std::array<int, 4>& slot) {
  bool odd = false;
  for (int i = 1; i < 4; ++i)
    for (int j = i; j > 0 && corners[j] < corners[j - 1]; --j) {
      std::swap(corners[j], corners[j - 1]);
      std::swap(slot[j], slot[j - 1]);
      odd = !odd;
    }
  if (!odd) return;
  std::swap(corners[2], corners[3]);
  std::swap(slot[2], slot[3]);
}

Tetrahedra flatten(const Delaunay& delaunay) {
  const auto vertex = [&](Delaunay::Vertex_handle v) { return delaunay.is_infinite(v) ? no_index : v->info(); };
  std::vector<std::pair<Tetrahedra::Cell, Delaunay::Cell_handle>> cells;
  cells.reserve(delaunay.number_of_cells());
  for (const Delaunay::Cell_handle c : delaunay.all_cell_handles()) {
    Tetrahedra::Cell corners;
    std::array<int, 4> slot{};
    for (int i = 0; i < 4; ++i) corners[i] = vertex(c->vertex(i));
    put_in_order(corners, slot);
    cells.emplace_back(corners, c);
  }
  std::sort(cells.begin(), cells.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (Index k = 0; k < cells.size(); ++k) cells[k].second->info() = k;
  Tetrahedra flat;
  flat.corners.reserve(cells.size());
  flat.neighbours.resize(cells.size());
  for (Index k = 0; k < cells.size(); ++k) {
    const auto& [sorted, cell] = cells[k];
    Tetrahedra::Cell corners;
    std::array<int, 4> slot{0, 1, 2, 3};
    for (int i = 0; i < 4; ++i) corners[i] = vertex(cell->vertex(i));
    put_in_order(corners, slot);
    flat.corners.push_back(sorted);
    for (int i = 0; i < 4; ++i) flat.neighbours[k][i] = cell->neighbor(slot[i])->info();
  }
  return flat;
}

}  // namespace

Tetrahedra delaunay_tetrahedra(std::span<const Vec3> points) {
  std::vector<std::pair<Kernel::Point_3, Index>> given;
  given.reserve(points.size());
  for (Index i = 0; i < points.size(); ++i)
    given.emplace_back(Kernel::Point_3(points[i].x, points[i].y, points[i].z), i);
  return guarded([&] {
    const Delaunay delaunay(given.begin(), given.end());
    return delaunay.dimension() < 3 ? Tetrahedra{} : flatten(delaunay);
  });
}

int Tetrahedra::mirror(Index cell, int i) const {
  const Cell& other = corners[neighbours[cell][i]];
  const auto holds = [&](Index p) { return std::count(corners[cell].begin(), corners[cell].end(), p) > 0; };
  for (int k = 0; k < 3; ++k)
    if (!holds(other[k])) return k;
  return 3;
}

CellsOfPoint::CellsOfPoint(const Tetrahedra& tetrahedra, std::size_t point_count) : first_(point_count + 1, 0) {
  for (const auto& corners : tetrahedra.corners)
    for (const Index p : corners)
      if (p != no_index) ++first_[p + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  cells_.resize(first_.back());
  std::vector<Index> next(first_.begin(), first_.end() - 1);
  for (Index c = 0; c < tetrahedra.size(); ++c)
    for (const Index p : tetrahedra.corners[c])
      if (p != no_index) cells_[next[p]++] = c;
}

}  // namespace geodrome
