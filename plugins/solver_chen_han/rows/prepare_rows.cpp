// SPDX-License-Identifier: MIT
#include "plugins/solver_chen_han/rows/prepare_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "plugins/common/exact/exact_prepared.hpp"
#include "plugins/solver_chen_han/rows/row_choice.hpp"
#include "plugins/solver_chen_han/rows/row_search.hpp"

namespace geodrome::chen_han {
namespace {

using Prepared = ExactPrepared<Propagation>;

/// Runs what it can by lists, everything else as without a plan.
class PlannedSearch final : public Search {
 public:
  PlannedSearch(const PreparedSurface& plain, std::shared_ptr<const RowTables> tables)
      : plain_(plain), rows_(std::move(tables)) {}

  const ShortestPathMap& run(std::span<const Source> sources, const Request& request, RunContext& context) override {
    if (rows_.can_run(sources, request)) return rows_.run(sources, request, context);
    if (!search_) search_ = plain_.make_search();
    return search_->run(sources, request, context);
  }

 private:
  const PreparedSurface& plain_;
  RowSearch rows_;
  std::unique_ptr<Search> search_;
};

class PlannedSurface final : public PreparedSurface {
 public:
  PlannedSurface(const PreparedSurface& plain, std::shared_ptr<const RowTables> tables)
      : plain_(plain), tables_(std::move(tables)) {}
  std::unique_ptr<Search> make_search() const override { return std::make_unique<PlannedSearch>(plain_, tables_); }
  std::size_t bytes() const override { return plain_.bytes() + tables_->bytes(); }

 private:
  const PreparedSurface& plain_;
  std::shared_ptr<const RowTables> tables_;
};

std::string text(const char* format, double value) {
  char buffer[64];
  return {buffer, static_cast<std::size_t>(std::snprintf(buffer, sizeof buffer, format, value))};
}

/// Makes what one plan needs, or tells why not.
class RowPlanner {
 public:
  RowPlanner(const Prepared& prepared, const SearchPlan& plan, RunContext& context)
      : prepared_(prepared),
        surface_(*prepared.surface()),
        settings_(prepared.settings()),
        distance_(std::ldexp(plan.radius, surface_.exponent())),
        context_(context) {
    for (const SurfacePoint& source : plan.sources) {
      const Index vertex = surface_.mesh().vertex_at(source);
      if (vertex != no_index) sources_.push_back(surface_.vertex_of_original(vertex));
    }
    std::sort(sources_.begin(), sources_.end());
    sources_.erase(std::unique(sources_.begin(), sources_.end()), sources_.end());
  }

  std::unique_ptr<PreparedSurface> planned() {
    if (settings_.rows == Rows::plain) return plain("the option rows says so");
    if (!settings_.filter) return plain("lists of direct paths need filter=on");
    if (sources_.size() < fewest_sources())
      return plain("lists of direct paths pay for " + std::to_string(fewest_sources()) +
                   " sources at vertices or more");
    bends_ = bends_of(surface_, sources_);
    if (bends_.empty()) return plain("no path bends at a vertex");
    const std::vector<Index> chosen = samples(sources_);
    const SearchCounts plain_counts = count_plain(surface_, settings_, chosen, distance_, context_);
    if (!forced() && probing_is_dear(plain_counts.plain_work() * static_cast<double>(sources_.size())))
      return plain("to find out whether lists of direct paths pay would take too much of so few or so short searches");
    if (distance_ < infinity)
      if (auto near = bends_within(surface_, settings_, sources_, distance_, settings_.most_list_bytes, context_))
        bends_ = std::move(*near);
    if (bends_.empty()) return plain("no path bends at a vertex within the distance");
    return with_ground(plain_counts, chosen);
  }

 private:
  /// So much of all the work may go into the question whether lists pay.
  static constexpr double most_probing = 0.025;
  /// Lists are made where they take no more of the work of plain searches: they take memory, and caches, too.
  static constexpr double worth_it = 0.85;

  /// The same where near lists take more than usual: such meshes are rough, or vertices have very many faces.
  static constexpr double most_unusual_probing = 0.1;

  bool forced() const { return settings_.rows == Rows::lists; }
  std::size_t fewest_sources() const { return forced() ? 1 : 64; }
  /// Whether near lists, which the estimate needs, take too much beside the work of plain searches: by what they take
  /// on most meshes, and by samples.
  bool probing_is_dear(double plain_work) const {
    return usual_near_work(surface_) > most_probing * plain_work ||
           near_lists_take_more(surface_, settings_, most_unusual_probing * plain_work, context_);
  }

  std::unique_ptr<PreparedSurface> with_ground(const SearchCounts& plain_counts, std::span<const Index> chosen) {
    DirectGround ground(surface_, settings_, context_);
    const SearchCounts direct = count_direct(surface_, settings_, ground, chosen, distance_, context_);
    const RowEstimate estimate{plain_counts, direct, sources_.size(), bends_.size() + smooth_sources(), bends_.size()};
    context_.measure("lists_estimated_share", estimate.share());
    context_.measure("lists_estimated_bytes", estimate.bytes());
    const std::string share = text("%.2f", estimate.share()), mebibytes = text("%.0f", estimate.bytes() / (1 << 20));
    if (!forced() && estimate.share() > worth_it)
      return plain("lists of direct paths would take about " + share + " of the work of plain searches");
    if (estimate.bytes() > static_cast<double>(settings_.most_list_bytes)) return too_large("about " + mebibytes);
    context_.log(LogLevel::info, "rows by " + std::to_string(bends_.size()) + " lists of direct paths, about " +
                                     mebibytes + " MiB: about " + share + " of the work of plain searches");
    return with_lists(std::move(ground));
  }

  std::unique_ptr<PreparedSurface> with_lists(DirectGround ground) {
    auto lists = make_lists(surface_, settings_, ground, bends_, distance_, settings_.most_list_bytes, context_);
    if (!lists) return outgrown();
    context_.measure("lists_bytes", static_cast<double>(lists->bytes));
    std::vector<bool> is_source(surface_.vertex_count());
    for (const Index source : sources_) is_source[source] = true;
    return std::make_unique<PlannedSurface>(
        prepared_, std::make_shared<RowTables>(RowTables{prepared_.surface(), settings_, std::move(ground),
                                                         std::move(*lists), std::move(is_source), distance_}));
  }

  std::size_t smooth_sources() const {
    return static_cast<std::size_t>(std::count_if(sources_.begin(), sources_.end(), [this](Index v) {
      return surface_.kind(v) == PackedMesh::VertexKind::smooth;
    }));
  }

  std::unique_ptr<PreparedSurface> plain(const std::string& reason) {
    context_.log(LogLevel::info, "every row by a search of its own: " + reason);
    return nullptr;
  }
  std::unique_ptr<PreparedSurface> too_large(const std::string& size) {
    return plain("lists of direct paths would take " + size + " MiB, lists_memory allows " + mebibytes_allowed());
  }

  /// A line came before that told of lists, and time was lost on them, so this one says that they are gone.
  std::unique_ptr<PreparedSurface> outgrown() {
    context_.log(LogLevel::warning,
                 "the lists of direct paths grew larger than estimated, beyond the " + mebibytes_allowed() +
                     " MiB that lists_memory allows: they are given up, every row by a search of its own");
    return nullptr;
  }
  std::string mebibytes_allowed() const { return std::to_string(settings_.most_list_bytes >> 20); }

  const Prepared& prepared_;
  const PackedMesh& surface_;
  const Settings& settings_;
  double distance_;
  RunContext& context_;
  std::vector<Index> sources_, bends_;
};

}  // namespace

std::unique_ptr<PreparedSurface> prepare_rows(const PreparedSurface& prepared, const SearchPlan& plan,
                                              RunContext& context) {
  const auto* const own = dynamic_cast<const Prepared*>(&prepared);
  return own ? RowPlanner(*own, plan, context).planned() : nullptr;
}

}  // namespace geodrome::chen_han
