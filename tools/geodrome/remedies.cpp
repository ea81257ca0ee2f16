// SPDX-License-Identifier: MIT
#include "tools/geodrome/remedies.hpp"

#include <algorithm>

namespace geodrome::cli {

namespace {

constexpr RemedySentence sentences[] = {
    {"consent", "say --yes, ask for fewer sources or targets, or store float32"},
    {"output.distances", "name an output: -o FILE or --nearest FILE"},
    {"output.matrix", "name it with -o FILE"},
    {"output.nearest", "name it with --nearest FILE"},
    {"output.pairs", "name an output: -o FILE"},
    {"output.page", "install Debian's nodejs and npm, then configure and build Geodrome again; or leave --html out"},
    {"resume", "--resume goes on with it"},
    {"resume.disk", "check the disk, then rerun with --resume"},
    {"resume.anew", "{0}, or rerun without --resume to start anew"},
    {"index", "name a file that 'geodrome queries --index' made, or a new one"},
    {"read.weld", "use --weld to merge them"},
    {"read.weld_within", "--weld {0} joins them"},
    {"read.drop_nonfinite", "use --drop-nonfinite to leave such points out"},
    {"read.columns", "choose the columns of x, y and z, as --columns {0}"},
    {"read.points", "use --as points"},
    {"read.vertices", "use --as points to take its vertices"},
    {"read.finite_points", "repair the mesh, or use --as points --drop-nonfinite"},
    {"read.weights", "--weights property:{0} measures with it"},
    {"part.take", "--part largest gives the part that makes a surface by itself, {0}"},
    {"part.whole", "leave --part out"},
    {"part.whole_or_points", "leave --part out, or take the vertices as points with --as points"},
    {"query.project", "leave --query out"},
    {"query.project_or", "{0}, or leave --query out"},
    {"query.project_or_points", "leave --query out, or take the vertices as points with --as points"},
    {"query.insert_or_project", "say --query insert, or leave it out"},
    {"metric.flat", "say --metric flat"},
    {"metric.flat_or_estimator", "choose a --tangent estimator that does, as jet, or say --metric flat"},
    {"metric.flat_or_no_index", "leave --index out, or say --metric flat"},
    {"metric.smooth_or_no_flat", "leave --flat out, or say --metric smooth"},
    {"varied.syntax", "write --stage STAGE=A,B[:k=v,...], e.g. --stage solver=chen_han,cgal"},
    {"varied.only", "name all choices in --stage"},
    {"varied.solver_or_points", "vary the solver, or say --as points to take the vertices as a sample"},
    {"solver.provides", "choose a solver that does ('geodrome plugins show NAME' tells)"},
    {"solver.needs", "repair the mesh, or choose a solver that needs less ('geodrome plugins show NAME' tells)"},
    {"solver.bounds",
     "choose a solver with a guarantee ('geodrome plugins show NAME' tells), as --accuracy does; the distances of an "
     "exact one are their own lower bounds"},
    {"solver.pairs",
     "say --solver with one that does ({0}), or use 'geodrome distances', which works with every solver"},
    {"solver.no_pairs", "no solver here does: use 'geodrome distances', which works with every solver"},
};

}  // namespace

std::span<const RemedySentence> sentences_of_flags() noexcept { return sentences; }

std::string words(const Remedy& remedy) {
  const auto found = std::ranges::find(sentences, remedy.code, &RemedySentence::code);
  return found == std::end(sentences) ? remedy.text : filled(found->sentence, remedy.parameters);
}

std::string text_of(const Error& error) { return geodrome::text_of(error, words(error.coded_remedy())); }

}  // namespace geodrome::cli
