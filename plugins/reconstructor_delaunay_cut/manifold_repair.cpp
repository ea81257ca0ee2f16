// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/manifold_repair.hpp"

#include <algorithm>
#include <deque>
#include <set>

namespace geodrome {
namespace {

/// How often a cell may change sides. Once is the rule; a second and a third time undo what a neighbour's repair
/// spoilt.
constexpr std::uint8_t most_flips = 3;

/// Cells around a point that hang together on one side, and what flipping them costs.
struct Group {
  std::vector<Index> cells;
  bool inside = false;
  std::int64_t cost = 0;
};

class Repair {
 public:
  Repair(const Tetrahedra& tetrahedra, const CutCosts& costs, const CellsOfPoint& cells_of, std::size_t point_count,
         Labels& inside)
      : tetrahedra_(tetrahedra),
        costs_(costs),
        cells_of_(cells_of),
        inside_(inside),
        flips_(tetrahedra.size(), 0),
        mark_(tetrahedra.size(), no_index),
        waiting_(point_count, 1) {
    for (Index p = 0; p < point_count; ++p) queue_.push_back(p);
  }

  RepairRecord run() {
    RepairRecord record;
    std::set<Index> places, unresolved;
    while (!queue_.empty()) {
      const Index p = queue_.front();
      queue_.pop_front();
      waiting_[p] = 0;
      unresolved.erase(p);
      std::vector<Group> groups = groups_around(p);
      if (is_sound(groups)) continue;
      places.insert(p);
      const std::vector<const Group*> weakest = cheapest_repair(groups);
      if (weakest.empty()) unresolved.insert(p);
      for (const Group* group : weakest) flip(*group, record);
    }
    record.places.assign(places.begin(), places.end());
    record.unresolved.assign(unresolved.begin(), unresolved.end());
    return record;
  }

 private:
  static bool is_sound(const std::vector<Group>& groups) {
    const auto inside = std::count_if(groups.begin(), groups.end(), [](const Group& g) { return g.inside; });
    return inside <= 1 && static_cast<std::ptrdiff_t>(groups.size()) - inside <= 1;
  }

  std::vector<Group> groups_around(Index p) {
    const std::span<const Index> cells = cells_of_(p);
    for (const Index c : cells) mark_[c] = p;
    std::vector<Group> groups;
    for (const Index first : cells) {
      if (mark_[first] != p) continue;
      groups.push_back({{first}, inside_[first] != 0, 0});
      Group& group = groups.back();
      mark_[first] = no_index;
      for (std::size_t k = 0; k < group.cells.size(); ++k)
        for (int i = 0; i < 4; ++i) {
          const Index other = tetrahedra_.neighbours[group.cells[k]][i];
          if (mark_[other] != p || (inside_[other] != 0) != group.inside) continue;
          mark_[other] = no_index;
          group.cells.push_back(other);
        }
    }
    return groups;
  }

  /// Change of the labelling's cost when a group changes sides; none if a cell of it may not.
  bool price(Group& group) const {
    group.cost = 0;
    const auto in_group = [&](Index c) {
      return std::find(group.cells.begin(), group.cells.end(), c) != group.cells.end();
    };
    for (const Index c : group.cells) {
      if (tetrahedra_.infinite(c) || flips_[c] >= most_flips) return false;
      group.cost += group.inside ? -costs_.inside[c] : costs_.inside[c];
      for (int i = 0; i < 4; ++i) {
        const Index other = tetrahedra_.neighbours[c][i];
        if (in_group(other)) continue;
        const bool was_cut = (inside_[other] != 0) != group.inside;
        group.cost += was_cut ? -std::int64_t{costs_.cut[c][i]} : std::int64_t{costs_.cut[c][i]};
      }
    }
    return true;
  }

  /// All groups of one side but the one that is dearest to flip, of the side where that is cheaper.
  std::vector<const Group*> cheapest_repair(std::vector<Group>& groups) {
    std::vector<const Group*> best;
    std::int64_t best_cost = 0;
    for (const bool side : {false, true}) {
      std::vector<const Group*> movable;
      std::size_t fixed = 0;
      for (Group& group : groups) {
        if (group.inside != side) continue;
        if (price(group))
          movable.push_back(&group);
        else
          ++fixed;
      }
      if (movable.size() + fixed < 2 || fixed > 1) continue;
      std::sort(movable.begin(), movable.end(), [](const Group* a, const Group* b) {
        return a->cost != b->cost ? a->cost < b->cost : a->cells.front() < b->cells.front();
      });
      if (fixed == 0) movable.pop_back();
      std::int64_t cost = 0;
      for (const Group* group : movable) cost += group->cost;
      if (best.empty() || cost < best_cost) best = movable, best_cost = cost;
    }
    return best;
  }

  void flip(const Group& group, RepairRecord& record) {
    for (const Index c : group.cells) {
      inside_[c] = group.inside ? 0 : 1;
      ++flips_[c];
      ++record.flips;
      for (const Index p : tetrahedra_.corners[c])
        if (p != no_index && !waiting_[p]) waiting_[p] = 1, queue_.push_back(p);
    }
  }

  const Tetrahedra& tetrahedra_;
  const CutCosts& costs_;
  const CellsOfPoint& cells_of_;
  Labels& inside_;
  std::vector<std::uint8_t> flips_;
  std::vector<Index> mark_;
  std::vector<char> waiting_;
  std::deque<Index> queue_;
};

}  // namespace

RepairRecord make_manifold(const Tetrahedra& tetrahedra, const CutCosts& costs, const CellsOfPoint& cells_of,
                           std::size_t point_count, Labels& inside) {
  return Repair(tetrahedra, costs, cells_of, point_count, inside).run();
}

}  // namespace geodrome
