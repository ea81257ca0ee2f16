// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace geodrome {

/// `wanted` of the numbers 0 .. count - 1, ascending; all of them if `wanted` is not below `count`. Drawn without
/// repetition by the seed: the first steps of a Fisher-Yates shuffle, whose choices are remainders of the generator's
/// own numbers, the same with every standard library. The bias is below count / 2^64. O(count).
template <class Integer>
std::vector<Integer> seeded_subset(Integer count, Integer wanted, std::uint64_t seed) {
  std::vector<Integer> chosen(count);
  std::iota(chosen.begin(), chosen.end(), Integer{0});
  if (wanted >= count) return chosen;
  std::mt19937_64 random(seed);
  for (Integer i = 0; i < wanted; ++i) std::swap(chosen[i], chosen[i + random() % (count - i)]);
  chosen.resize(wanted);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

/// A share of `count`, rounded up, so at least one of them; all from a share of 1 on.
template <class Integer>
Integer size_of_share(Integer count, double share) {
  return static_cast<Integer>(std::ceil(std::min(share, 1.0) * static_cast<double>(count)));
}

/// seeded_subset() of a share of the numbers.
template <class Integer>
std::vector<Integer> seeded_share(Integer count, double share, std::uint64_t seed) {
  return seeded_subset(count, size_of_share(count, share), seed);
}

}  // namespace geodrome
