// SPDX-License-Identifier: MIT
#include "engine/formats/remedies.hpp"

namespace geodrome {

namespace {

constexpr RemedySentence sentences[] = {
    {"consent", "set `yes`, ask for fewer sources or targets, or store float32"},
    {"output.distances", "name an output in `matrix` or `nearest`"},
    {"output.matrix", "name it in `matrix`"},
    {"output.nearest", "name it in `nearest`"},
    {"output.pairs", "name an output in `out`"},
    {"output.page", "install Debian's nodejs and npm, then configure and build Geodrome again; or leave `page` empty"},
    {"resume", "set `resume` to go on with it"},
    {"resume.disk", "check the disk, then set `resume` to go on"},
    {"resume.anew", "{0}, or leave `resume` out to start anew"},
    {"index", "name a file that `run_pairs` made, or a new one"},
    {"read.weld", "set `read.weld` to merge them"},
    {"read.weld_within", "set `read.weld`, and `read.weld_tolerance` to {0}, to join them"},
    {"read.drop_nonfinite", "set `read.drop_nonfinite` to leave such points out"},
    {"read.columns", "choose the columns of x, y and z in `read.columns`, as {0}"},
    {"read.points", "set `read.as` to points"},
    {"read.vertices", "set `read.as` to points to take its vertices"},
    {"read.finite_points", "repair the mesh, or set `read.as` to points and `read.drop_nonfinite`"},
    {"read.weights", "set `read.weights` to property:{0} to measure with it"},
    {"part.take", "set `part` to largest for the part that makes a surface by itself, {0}"},
    {"part.whole", "leave `part` at whole"},
    {"part.whole_or_points", "leave `part` at whole, or set `read.as` to points to take the vertices"},
    {"query.project", "leave `query` at project"},
    {"query.project_or", "{0}, or leave `query` at project"},
    {"query.project_or_points", "leave `query` at project, or set `read.as` to points to take the vertices"},
    {"query.insert_or_project", "set `query` to insert, or leave it at project"},
    {"metric.flat", "set `metric` to flat"},
    {"metric.flat_or_estimator", "choose a `tangent` estimator that does, as jet, or set `metric` to flat"},
    {"metric.flat_or_no_index", "leave `index` empty, or set `metric` to flat"},
    {"metric.smooth_or_no_flat", "leave `flat` empty, or set `metric` to smooth"},
    {"varied.syntax", "write STAGE=A,B[:k=v,...] in `varied`, e.g. solver=chen_han,cgal"},
    {"varied.only", "name all choices in `varied`"},
    {"varied.solver_or_points", "vary the solver, or set `read.as` to points to take the vertices as a sample"},
    {"solver.provides", "choose a solver that does (`PluginInfo::provides` tells)"},
    {"solver.needs", "repair the mesh, or choose a solver that needs less (`PluginInfo::needs` tells)"},
    {"solver.bounds",
     "choose a solver with a finite factor (`PluginInfo::default_factor` tells); the distances of an exact one are "
     "their own lower bounds"},
    {"solver.pairs", "choose a `solver` that does ({0}), or use `run_distances`, which works with every solver"},
    {"solver.no_pairs", "no solver here does: use `run_distances`, which works with every solver"},
};

/// The row of a code; a code that has none does not compile.
consteval std::size_t row(std::string_view code) {
  for (std::size_t i = 0; i < std::size(sentences); ++i)
    if (sentences[i].code == code) return i;
  throw "no such code";
}

Remedy made(std::size_t at, std::vector<std::string> parameters = {}) {
  std::string text = filled(sentences[at].sentence, parameters);
  return {std::string(sentences[at].code), std::move(parameters), std::move(text)};
}

}  // namespace

std::span<const RemedySentence> remedy_sentences() noexcept { return sentences; }

std::string filled(std::string_view sentence, std::span<const std::string> parameters) {
  std::string text(sentence);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string place = "{" + std::to_string(i) + "}";
    if (const std::size_t at = text.find(place); at != text.npos) text.replace(at, place.size(), parameters[i]);
  }
  return text;
}

std::string text_of(const Error& error, const std::string& words) {
  const std::string message = error.plugin().empty() ? error.message() : error.plugin() + ": " + error.message();
  return message + (words.empty() ? "" : "; " + words);
}

namespace remedies {

Remedy consent() { return made(row("consent")); }
Remedy distances_output() { return made(row("output.distances")); }
Remedy matrix_output() { return made(row("output.matrix")); }
Remedy nearest_output() { return made(row("output.nearest")); }
Remedy pairs_output() { return made(row("output.pairs")); }
Remedy page_output() { return made(row("output.page")); }
Remedy go_on() { return made(row("resume")); }
Remedy go_on_after_repair() { return made(row("resume.disk")); }
Remedy start_anew(std::string otherwise) { return made(row("resume.anew"), {std::move(otherwise)}); }
Remedy other_index() { return made(row("index")); }

Remedy weld() { return made(row("read.weld")); }
Remedy weld_within(std::string tolerance) { return made(row("read.weld_within"), {std::move(tolerance)}); }
Remedy drop_nonfinite() { return made(row("read.drop_nonfinite")); }
Remedy choose_columns(std::string columns) { return made(row("read.columns"), {std::move(columns)}); }
Remedy take_points() { return made(row("read.points")); }
Remedy take_vertices() { return made(row("read.vertices")); }
Remedy finite_points() { return made(row("read.finite_points")); }
Remedy use_weights(std::string property) { return made(row("read.weights"), {std::move(property)}); }

Remedy take_part(std::string what, const std::string& otherwise) {
  return made(row("part.take"), {std::move(what) + (otherwise.empty() ? "" : "; or " + otherwise)});
}
Remedy whole_sample() { return made(row("part.whole")); }
Remedy whole_or_points() { return made(row("part.whole_or_points")); }

Remedy default_rule() { return made(row("query.project")); }
Remedy default_rule_or(std::string otherwise) { return made(row("query.project_or"), {std::move(otherwise)}); }
Remedy default_rule_or_points() { return made(row("query.project_or_points")); }
Remedy insertion_or_default_rule() { return made(row("query.insert_or_project")); }

Remedy flat_metric() { return made(row("metric.flat")); }
Remedy flat_metric_or_other_estimator() { return made(row("metric.flat_or_estimator")); }
Remedy no_index_or_flat_metric() { return made(row("metric.flat_or_no_index")); }
Remedy smooth_metric_or_no_flat_path() { return made(row("metric.smooth_or_no_flat")); }

Remedy varied_syntax() { return made(row("varied.syntax")); }
Remedy varied_only() { return made(row("varied.only")); }
Remedy varied_solver_or_points() { return made(row("varied.solver_or_points")); }
Remedy solver_that_provides() { return made(row("solver.provides")); }
Remedy solver_that_needs_less() { return made(row("solver.needs")); }
Remedy solver_with_bounds() { return made(row("solver.bounds")); }

Remedy solver_of_pairs(const std::string& able) {
  return able.empty() ? made(row("solver.no_pairs")) : made(row("solver.pairs"), {able});
}

}  // namespace remedies

}  // namespace geodrome
