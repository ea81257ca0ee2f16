// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/rows/near_lists.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

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

  /// Returns what all searches so far took together.
  const NearCounts& counts() const { return counts_; }

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
    count();
    found_.clear();
    for (const Index v : propagation_.reached())
      if (v != vertex) found_.push_back({v, rounded_up(propagation_.answer(v).distance)});
  }

  /// Where vertices are much denser nearby than around the source, the search ends early: as many others as wanted are
  /// no farther than those found so far.
  double enough(std::size_t wanted) {
    const auto& reached = propagation_.reached();
    if (reached.size() < 4 * wanted) return infinity;
    distances_.clear();
    for (const Index v : reached) distances_.push_back(propagation_.answer(v).distance);
    const auto last = distances_.begin() + static_cast<std::ptrdiff_t>(wanted);  // the vertex itself is the first
    std::nth_element(distances_.begin(), last, distances_.end());
    return *last;
  }

  void count() {
    counts_.reached += static_cast<double>(propagation_.reached().size());
    for (const Counter& counter : propagation_.counters())
      if (std::string_view(counter.name) == "half_edges_passed") counts_.passes += static_cast<double>(counter.value);
  }

  const PackedMesh& surface_;
  Propagation propagation_;
  std::vector<NearLists::Entry> found_;
  std::vector<double> distances_;
  NearCounts counts_;
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

NearCounts count_near(const PackedMesh& surface, const Settings& settings, std::size_t count,
                      std::span<const Index> vertices, double most_work, const RunContext& context) {
  NearSearch search(surface, settings);
  std::vector<NearLists::Entry> entries(count);
  for (std::size_t i = 0; i < vertices.size() && search.counts().work() <= most_work; ++i)
    search.write(vertices[i], entries, context);
  return search.counts();
}

}  // namespace geodrome::chen_han
