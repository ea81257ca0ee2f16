// SPDX-License-Identifier: MIT
#include "engine/report/capability_words.hpp"

namespace geodrome {
namespace {

template <std::size_t N>
std::vector<std::string> words_of(std::uint64_t bits, const char* const (&names)[N]) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < N; ++i)
    if (bits >> i & 1) words.emplace_back(names[i]);
  return words;
}

}  // namespace

std::vector<std::string> needs_words(std::uint64_t needs) {
  static constexpr const char* names[] = {"manifold", "oriented", "closed"};
  return words_of(needs, names);
}

std::vector<std::string> provides_words(std::uint64_t provides) {
  static constexpr const char* names[] = {
      "start_distances",  "face_sources", "radius_limit", "target_limit",     "any_point",    "paths",
      "path_is_distance", "pair_queries", "weights",      "factor_any_point", "never_shorter"};
  return words_of(provides, names);
}

}  // namespace geodrome
