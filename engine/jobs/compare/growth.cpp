// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/growth.hpp"

#include <algorithm>

#include "engine/checks/seeded_subset.hpp"
#include "engine/input/finding_text.hpp"
#include "engine/jobs/compare/refined_surface.hpp"

namespace geodrome {

namespace {

/// The point of a sample that a source is; no_index for one that is none.
Index element_of(const NamedPoint& source, const Input& input) {
  return source.row == no_index ? no_index : input.element_of_row[source.row];
}

std::string size_text(InputKind kind, unsigned level) {
  if (kind == InputKind::mesh) return "faces cut in " + std::to_string(std::uint64_t{1} << (2 * level));
  return "1/" + std::to_string(std::uint64_t{1} << level) + " of the points";
}

RunSettings on_triangles(RunSettings settings) {
  settings.metric = Metric::flat;
  return settings;
}

}  // namespace

std::vector<NamedPoint> SamplePart::place(std::span<const NamedPoint> sources, const Input& whole,
                                          const PlacedSurface& surface) const {
  std::vector<NamedPoint> placed(sources.begin(), sources.end());
  for (NamedPoint& source : placed) {
    if (const Index wanted = element_of(source, whole); wanted != no_index) {
      const auto row = std::lower_bound(element.begin(), element.end(), wanted) - element.begin();
      source.row = static_cast<Index>(row);
      source.place = surface.places[source.row];
    } else if (source.place.state == Place::State::on_surface) {
      source.place.at = surface.locator->closest(source.place.position).at;
      source.place.vertex = surface.mesh->vertex_at(source.place.at);
    }
  }
  return placed;
}

SamplePart part_of(const Input& input, std::size_t points, std::span<const NamedPoint> sources, std::uint64_t seed) {
  SamplePart part;
  part.element = seeded_subset(static_cast<Index>(input.positions.size()), static_cast<Index>(points), seed);
  for (const NamedPoint& source : sources)
    if (const Index element = element_of(source, input); element != no_index) part.element.push_back(element);
  std::sort(part.element.begin(), part.element.end());
  part.element.erase(std::unique(part.element.begin(), part.element.end()), part.element.end());
  part.input.file = input.file, part.input.format = input.format, part.input.kind = input.kind;
  for (const Index element : part.element) {
    part.input.element_of_row.push_back(static_cast<Index>(part.input.positions.size()));
    part.input.positions.push_back(input.positions[element]);
  }
  part.input.facts.rows = part.element.size();
  return part;
}

/// A part of the sample and its surfaces.
struct ComparisonGrowth::Sparser {
  SamplePart part;
  ComparedSurfaces surfaces;

  Sparser(SamplePart sample, std::vector<NamedPoint> sources, const Input& whole, const PluginHost& host,
          const RunSettings& settings, Observer& observer)
      : part(std::move(sample)),
        surfaces(part.input, host, settings, observer,
                 [this, &whole, sources = std::move(sources)](const PlacedSurface& surface) {
                   return part.place(sources, whole, surface);
                 }) {}
};

ComparisonGrowth::ComparisonGrowth(unsigned levels, const Input& input, const PluginHost& host,
                                   const RunSettings& settings, Observer& observer)
    : levels_(levels), input_(input), host_(host), settings_(on_triangles(settings)), observer_(observer) {}

ComparisonGrowth::~ComparisonGrowth() = default;

std::shared_ptr<const ComparedSurface> ComparisonGrowth::finer(const std::shared_ptr<const ComparedSurface>& on,
                                                               unsigned level) {
  if (level == 0) return on;
  std::shared_ptr<const ComparedSurface>& known = finer_[level];
  if (!known) known = refined(*finer(on, level - 1));
  return known;
}

std::shared_ptr<const ComparedSurface> ComparisonGrowth::sparser(const StageChoice& choice, const ComparedSurface& on,
                                                                 unsigned level) {
  std::unique_ptr<Sparser>& known = sparser_[level];
  if (!known)
    known = std::make_unique<Sparser>(part_of(input_, input_.positions.size() >> level, on.sources, settings_.seed),
                                      std::vector<NamedPoint>(on.sources.begin(), on.sources.end()), input_, host_,
                                      settings_, observer_);
  return known->surfaces.placed(known->surfaces.make(choice));
}

std::vector<GrowthStep> ComparisonGrowth::of(const Combination& combination, const Plugin<ShortestPathSolver>& solver,
                                             const std::shared_ptr<const ComparedSurface>& on, const SearchCost& own) {
  std::vector<GrowthStep> steps;
  if (levels_ == 0) return steps;
  steps.push_back({on->targets.size(), own});
  for (unsigned level = 1; level <= levels_; ++level) {
    const std::string name = combination.name + ", " + size_text(input_.kind, level);
    try {
      const bool is_mesh = input_.kind == InputKind::mesh;
      const auto other = is_mesh ? finer(on, level) : sparser(combination.choice, *on, level);
      const Measurement measured = measure(*other, solver, host_, settings_, name, observer_);
      const std::size_t rows = is_mesh ? measured.cost.vertices : other->targets.size();
      steps.push_back({rows, measured.cost});
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& error) {
      observer_.log(LogLevel::warning, "growth: " + name + ": left out: " + text_of(error, observer_));
    }
  }
  std::stable_sort(steps.begin(), steps.end(),
                   [](const GrowthStep& a, const GrowthStep& b) { return a.rows < b.rows; });
  return steps;
}

}  // namespace geodrome
