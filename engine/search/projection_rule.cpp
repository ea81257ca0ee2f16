// SPDX-License-Identifier: MIT
#include "engine/search/projection_rule.hpp"

#include <algorithm>
#include <string>

#include "engine/formats/remedies.hpp"

namespace geodrome {

std::string_view name(ProjectionRule rule) {
  switch (rule) {
    case ProjectionRule::insert:
      return "insert";
    case ProjectionRule::printed:
      return "printed";
    default:
      return "project";
  }
}

std::string_view caveat(ProjectionRule rule) {
  switch (rule) {
    case ProjectionRule::insert:
      return "every source has a surface of its own: symmetry and the triangle inequality are not promised";
    case ProjectionRule::printed:
      return "for comparison only: the rule as the paper prints it gives 0 where a target's nearest vertex is the "
             "source, and distances below the straight line; neither D >= Euclid, nor symmetry, nor the triangle "
             "inequality is promised";
    default:
      return {};
  }
}

void check_rule(ProjectionRule rule, const Opened& opened, std::span<const NamedPoint> sources) {
  if (rule == ProjectionRule::project) return;
  const std::string option = "the rule " + std::string(name(rule));
  if (opened.input.kind == InputKind::mesh)
    throw OptionError(option + " is for point samples: every row of a mesh is a vertex of the surface already",
                      remedies::default_rule_or_points());
  if (std::ranges::any_of(sources, [](const NamedPoint& source) { return source.row == no_index; }))
    throw OptionError(option + " inserts points of the sample, and a source names a place that is none",
                      remedies::default_rule_or("name sources by their rows"));
  if (opened.surface.smooth)
    throw OptionError(option + " has a surface for each source, and smooth distances are measured on one for all",
                      remedies::default_rule_or("measure on the triangles"));
  if (!opened.surface.inserter && opened.surface.part)
    throw CapabilityError(option + " inserts points into a surface as the reconstructor made it, not into a part of it",
                          remedies::default_rule());
  if (!opened.surface.inserter)
    throw CapabilityError(opened.surface.stages.back().plugin.full_name() + " cannot insert points into its surface, " +
                              "which " + option + " needs",
                          remedies::default_rule_or("choose another reconstructor"));
}

void check_limit(double max_distance) {
  if (!(max_distance >= 0)) throw OptionError("the largest distance must be a number >= 0");
}

void check_path_rule(ProjectionRule rule) {
  if (rule == ProjectionRule::printed)
    throw OptionError("the rule printed has no paths: its distances are minima over several points",
                      remedies::insertion_or_default_rule());
}

void check_bounds_rule(ProjectionRule rule) {
  if (rule == ProjectionRule::printed)
    throw OptionError("the rule printed has no lower bounds: its distances are no lengths of paths",
                      remedies::insertion_or_default_rule());
}

}  // namespace geodrome
