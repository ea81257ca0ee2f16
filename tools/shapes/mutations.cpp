// SPDX-License-Identifier: MIT
#include "tools/shapes/mutations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace geodrome::shapes {
namespace {

double mean_edge(const Soup& soup) {
  double sum = 0;
  for (const auto& [a, b, c] : soup.triangles)
    sum += distance(soup.positions[a], soup.positions[b]) + distance(soup.positions[b], soup.positions[c]) +
           distance(soup.positions[c], soup.positions[a]);
  return sum / (3.0 * static_cast<double>(std::max<std::size_t>(1, soup.triangles.size())));
}

bool has(const Triangle& triangle, Index vertex) {
  return triangle[0] == vertex || triangle[1] == vertex || triangle[2] == vertex;
}

std::vector<std::size_t> faces_around(const Soup& soup, Index vertex) {
  std::vector<std::size_t> faces;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    if (has(soup.triangles[f], vertex)) faces.push_back(f);
  return faces;
}

std::set<Index> neighbours(const Soup& soup, Index vertex) {
  std::set<Index> found;
  for (const std::size_t f : faces_around(soup, vertex))
    found.insert(soup.triangles[f].begin(), soup.triangles[f].end());
  found.erase(vertex);
  return found;
}

/// `faces` ascending.
void erase_faces(Soup& soup, const std::vector<std::size_t>& faces) {
  for (auto face = faces.rbegin(); face != faces.rend(); ++face)
    soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(*face));
}

/// The faces around a vertex in cyclic order, from the border's first one on if there is one; the vertex has one fan.
std::vector<std::size_t> fan_in_order(const Soup& soup, Index vertex) {
  std::vector<std::size_t> left = faces_around(soup, vertex), ordered;
  const auto corner_after = [&](std::size_t face, int steps) {
    const Triangle& t = soup.triangles[face];
    const auto own = std::find(t.begin(), t.end(), vertex) - t.begin();
    return t[static_cast<std::size_t>(own + steps) % 3];
  };
  const auto is_first = [&](std::size_t face) {
    return std::ranges::none_of(left,
                                [&](std::size_t other) { return corner_after(other, 2) == corner_after(face, 1); });
  };
  auto next = std::ranges::find_if(left, is_first);
  if (next == left.end()) next = left.begin();
  while (next != left.end()) {
    ordered.push_back(*next);
    const Index edge = corner_after(*next, 2);
    left.erase(next);
    next = std::ranges::find_if(left, [&](std::size_t face) { return corner_after(face, 1) == edge; });
  }
  return ordered;
}

Index used_vertex(const Soup& soup, Random& random) {
  return soup.triangles[random.index(soup.triangles.size())][random.index(3)];
}

}  // namespace

void append(Soup& soup, const Soup& other) {
  const auto shift = static_cast<Index>(soup.positions.size());
  soup.positions.insert(soup.positions.end(), other.positions.begin(), other.positions.end());
  for (const auto& [a, b, c] : other.triangles) soup.triangles.push_back({a + shift, b + shift, c + shift});
}

void stretch(Soup& soup, Random& random) {
  const auto factor = [&] { return std::pow(10, random.uniform(-1, 1)); };
  const Vec3 by{factor(), factor(), factor()};
  for (Vec3& p : soup.positions) p = {by.x * p.x, by.y * p.y, by.z * p.z};
}

void jitter(Soup& soup, Random& random) {
  const double reach = random.uniform(0, 0.3) * mean_edge(soup);
  for (Vec3& p : soup.positions)
    p = p + reach * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

void pull_needles(Soup& soup, std::size_t count, Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    const Triangle& t = soup.triangles[random.index(soup.triangles.size())];
    const std::size_t corner = random.index(3);
    Vec3& p = soup.positions[t[corner]];
    const Vec3 q = soup.positions[t[(corner + 1) % 3]], r = soup.positions[t[(corner + 2) % 3]];
    const bool to_edge = random.uniform() < 0.6, exactly = random.uniform() < 0.125;
    const double along = random.uniform(0.2, 0.8), rest = std::pow(10, -random.uniform(1, 9));
    const Vec3 aim = to_edge ? (exactly ? 0.5 * (q + r) : q + along * (r - q)) : q;
    p = aim + (to_edge && exactly ? 0 : rest) * (p - aim);
  }
}

void cut_holes(Soup& soup, std::size_t count, Random& random) {
  const bool was_manifold = soup.mesh().manifold();
  for (std::size_t i = 0; i < count && soup.triangles.size() > 1; ++i) {
    const std::size_t face = random.index(soup.triangles.size());
    const Triangle removed = soup.triangles[face];
    erase_faces(soup, {face});
    if (was_manifold && !soup.mesh().manifold())
      soup.triangles.insert(soup.triangles.begin() + static_cast<std::ptrdiff_t>(face), removed);
  }
}

void cut_stars(Soup& soup, std::size_t count, Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<std::size_t> star = faces_around(soup, used_vertex(soup, random));
    if (star.size() < soup.triangles.size()) erase_faces(soup, star);
  }
}

void leave_touching_fans(Soup& soup, std::size_t count, Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::vector<std::size_t> fan = fan_in_order(soup, used_vertex(soup, random));
    std::vector<std::size_t> removed;
    for (std::size_t k = 1; k < fan.size(); k += 2) removed.push_back(fan[k]);
    std::sort(removed.begin(), removed.end());
    if (removed.size() < soup.triangles.size()) erase_faces(soup, removed);
  }
}

void tie_bows(Soup& soup, std::size_t count, Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    const Index a = used_vertex(soup, random), b = used_vertex(soup, random);
    const std::set<Index> around_a = neighbours(soup, a), around_b = neighbours(soup, b);
    const auto is_near = [&](Index v) { return around_a.contains(v); };
    if (a == b || around_a.contains(b) || std::ranges::any_of(around_b, is_near)) continue;
    soup.positions[a] = 0.5 * (soup.positions[a] + soup.positions[b]);
    for (Triangle& t : soup.triangles) std::ranges::replace(t, b, a);
  }
}

void renumber(Soup& soup, Random& random) {
  for (std::size_t i = soup.triangles.size(); i > 1; --i)  // Fisher and Yates
    std::swap(soup.triangles[i - 1], soup.triangles[random.index(i)]);
  for (Triangle& t : soup.triangles)
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random.index(3)), t.end());
}

}  // namespace geodrome::shapes
