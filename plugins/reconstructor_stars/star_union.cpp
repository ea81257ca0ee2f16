// SPDX-License-Identifier: MIT
#include "plugins/reconstructor_stars/star_union.hpp"

#include <algorithm>

namespace geodrome {
namespace {

/// A triangle as the star of `owner` has it.
struct Entry {
  Triangle sorted;
  Index owner;
  Triangle face;

  friend bool operator<(const Entry& a, const Entry& b) {
    return a.sorted != b.sorted ? a.sorted < b.sorted : a.owner < b.owner;
  }
};

std::vector<Entry> entries(const PlanarStars& stars, std::span<const Vec3> points, std::span<const double> farthest) {
  std::vector<Entry> all;
  for (Index s = 0; s < stars.size(); ++s) {
    const std::span<const StarCorner> star = stars(s);
    for (std::size_t i = 0; i < star.size(); ++i) {
      if (!star[i].real || distance(star[i].centre, points[s]) > farthest[s]) continue;
      const Triangle face{s, star[i == 0 ? star.size() - 1 : i - 1].site, star[i].site};
      Triangle sorted = face;
      std::sort(sorted.begin(), sorted.end());
      all.push_back({sorted, s, face});
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

StarUnion union_of(const PlanarStars& stars, std::span<const Vec3> points, std::span<const double> farthest) {
  const std::vector<Entry> all = entries(stars, points, farthest);
  StarUnion result;
  for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
    while (end < all.size() && all[end].sorted == all[i].sorted) ++end;
    if (end - i < 3) result.disputed.push_back(static_cast<Index>(result.faces.size()));
    result.faces.push_back(all[i].face);
  }
  return result;
}

}  // namespace geodrome
