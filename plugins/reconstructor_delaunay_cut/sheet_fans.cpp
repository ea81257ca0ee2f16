// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/sheet_fans.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plugins/common/points/frame.hpp"

namespace geodrome {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// From one direction counter-clockwise to another, in [0, 2 pi). Sectors that share a neighbour end where the next
/// begins to the last bit, since the same directions are subtracted.
double turn(double from, double to) {
  const double difference = to - from;
  return difference < 0 ? difference + full_turn : difference;
}

}  // namespace

SheetFans::SheetFans(std::span<const Vec3> points, std::span<const Vec3> normals)
    : points_(points), sectors_(points.size()) {
  for (const Vec3& n : normals) u_.push_back(tangent_to(n)), v_.push_back(cross(n, u_.back()));
}

SheetFans::Sector SheetFans::sector(Index at, Index a, Index b) const {
  const auto direction = [&](Index to) {
    const Vec3 way = points_[to] - points_[at];
    return std::atan2(dot(way, v_[at]), dot(way, u_[at]));
  };
  const double to_a = direction(a), to_b = direction(b);
  const double width = turn(to_a, to_b);
  return width < std::numbers::pi ? Sector{a, b, to_a, width} : Sector{b, a, to_b, turn(to_b, to_a)};
}

bool SheetFans::fits(const Triangle& triangle) const {
  for (int i = 0; i < 3; ++i) {
    const Index at = triangle[i], a = triangle[(i + 1) % 3], b = triangle[(i + 2) % 3];
    const Sector wanted = sector(at, a, b);
    if (!(wanted.width > 0)) return false;
    for (const Sector& there : sectors_[at])
      if (turn(there.begin, wanted.begin) < there.width || turn(wanted.begin, there.begin) < wanted.width) return false;
  }
  for (int i = 0; i < 3; ++i)
    if (faces_at(triangle[i], triangle[(i + 1) % 3]) == 0 && crosses(triangle[i], triangle[(i + 1) % 3])) return false;
  return true;
}

void SheetFans::add(const Triangle& triangle) {
  for (int i = 0; i < 3; ++i)
    sectors_[triangle[i]].push_back(sector(triangle[i], triangle[(i + 1) % 3], triangle[(i + 2) % 3]));
  faces_.push_back(triangle);
}

int SheetFans::faces_at(Index a, Index b) const {
  return static_cast<int>(
      std::ranges::count_if(sectors_[a], [&](const Sector& s) { return s.first == b || s.last == b; }));
}

std::vector<SheetFans::Gap> SheetFans::gaps(Index point) const {
  std::vector<Sector> around = sectors_[point];
  std::ranges::sort(around, {}, &Sector::begin);
  std::vector<Gap> found;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Index from = around[i].last, to = around[(i + 1) % around.size()].first;
    if (from != to) found.push_back({from, to});
  }
  return found;
}

/// Sectors show every crossing but that of an edge with the far sides of triangles around neither of its ends: edges
/// between neighbours of its ends are looked at, in the plane of its first end.
bool SheetFans::crosses(Index a, Index b) const {
  const auto flat = [&](Index p) {
    const Vec3 way = points_[p] - points_[a];
    return std::pair(dot(way, u_[a]), dot(way, v_[a]));
  };
  const auto [bx, by] = flat(b);
  const auto side = [&](Index p) {
    const auto [x, y] = flat(p);
    return bx * y - by * x;
  };
  for (const Index end : {a, b})
    for (const Sector& s : sectors_[end])
      for (const Index c : {s.first, s.last})
        for (const Sector& t : sectors_[c])
          for (const Index d : {t.first, t.last}) {
            if (c == a || c == b || d == a || d == b) continue;
            if (!(side(c) * side(d) < 0)) continue;
            const auto [cx, cy] = flat(c);
            const auto [dx, dy] = flat(d);
            const double of_a = (dx - cx) * (0 - cy) - (dy - cy) * (0 - cx);
            const double of_b = (dx - cx) * (by - cy) - (dy - cy) * (bx - cx);
            if (of_a * of_b < 0) return true;
          }
  return false;
}

}  // namespace geodrome
