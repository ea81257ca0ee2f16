// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/rows/near_lists.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "interfaces/internal/shared_work.hpp"
#include "plugins/solver_chen_han/propagation.hpp"

namespace geodrome::chen_han {
namespace {

/// Returns the smallest float that is not below.
float rounded_up(double value) {
  const auto nearest = static_cast<float>(value);
  return nearest < value ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
}

/// Searches the surroundings of vertices.
class NearSearch {
 public:
  NearSearch(const PackedMesh& surface, const Settings& settings)
      : surface_(surface), propagation_(surface, settings) {}

  /// Writes the vertices nearest to `vertex`, at most as many as there are places; returns how many.
  std::size_t write(Index vertex, std::span<NearLists::Entry> out, const RunContext& context) {
    if (surface_.corners(vertex).empty()) return 0;  // on no face
    double radius = first_radius(vertex);
    for (std::size_t before = 0;; radius *= 1.5) {
      search(vertex, radius, out.size(), context);
      // A ball that does not grow any more may have reached the end of the component, or a gap: two more are tried.
      if (found_.size() >= out.size() / 2 || (found_.size() == before && ++vain_ > 2)) break;
      if (found_.size() != before) before = found_.size(), vain_ = 0;
    }
    vain_ = 0;
    const auto nearer = [](const NearLists::Entry& a, const NearLists::Entry& b) {
      return a.length != b.length ? a.length < b.length : a.vertex < b.vertex;
    };
    const std::size_t count = std::min(found_.size(), out.size());
    std::partial_sort(found_.begin(), found_.begin() + static_cast<std::ptrdiff_t>(count), found_.end(), nearer);
    std::copy_n(found_.begin(), count, out.begin());
    return count;
  }

 private:
  double first_radius(Index vertex) const {
    double sum = 0;
    const auto corners = surface_.corners(vertex);
    for (const Index corner : corners) sum += surface_.length(corner);
    return corners.empty() ? 1 : 3.0 * sum / static_cast<double>(corners.size());
  }

  void search(Index vertex, double radius, std::size_t wanted, const RunContext& context) {
    propagation_.begin(false, radius);
    propagation_.seed({surface_.mesh().at_vertex(surface_.original_vertex(vertex))}, 0);
    propagation_.run(context, [&] { return enough(wanted); });
    found_.clear();
    for (const Index v : propagation_.reached())
      if (v != vertex) found_.push_back({v, rounded_up(propagation_.answer(v).distance)});
  }

  /// Where vertices are much denser nearby than around the source, the search ends early.
  double enough(std::size_t wanted) {
    const auto& reached = propagation_.reached();
    if (reached.size() < 4 * wanted) return infinity;
    double farthest = 0;
    for (std::size_t i = 0; i < 4 * wanted; ++i)
      farthest = std::max(farthest, propagation_.answer(reached[i]).distance);
    return farthest;
  }

  const PackedMesh& surface_;
  Propagation propagation_;
  std::vector<NearLists::Entry> found_;
  int vain_ = 0;
};

}  // namespace

NearLists::NearLists(const PackedMesh& surface, const Settings& settings, std::size_t count, RunContext& context)
    : count_(count), entries_(count * surface.vertex_count()), size_(surface.vertex_count()) {
  share_work(surface.vertex_count(), 64, context.threads(), context, [&] {
    return [&, search = NearSearch(surface, settings)](std::uint64_t begin, std::uint64_t end) mutable {
      for (auto v = static_cast<Index>(begin); v < end; ++v)
        size_[v] = static_cast<Index>(search.write(v, {entries_.data() + v * count_, count_}, context));
    };
  });
}

}  // namespace geodrome::chen_han
