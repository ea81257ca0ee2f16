// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// A stage that a comparison varies, and the choices for it.
struct VariedStage {
  std::string stage;
  std::vector<std::string> choices;
};

/// Reads "solver=A,B:k=v,j=w,C": a comma that k=v follows belongs to the options of the choice before it. Throws
/// OptionError for a stage that does not exist, no choice, or one that is there twice.
VariedStage parse_varied_stage(const std::string& text);

/// One choice for every stage.
struct Combination {
  std::string name;  ///< the choices of the varied stages, joined by ", "; the solver where none is varied
  StageChoice choice;
};

/// All combinations of the varied stages' choices, the last stage's changing fastest; other stages as in `fixed`. Names
/// are unique. Throws OptionError for a stage that is varied twice, or both varied and chosen otherwise in `fixed`, and
/// for a sample stage where the input is a mesh.
std::vector<Combination> combinations_of(std::span<const VariedStage> varied, const StageChoice& fixed, InputKind kind);

/// Stage and choice, in the order of the stages; only the solver for a mesh.
std::vector<std::pair<std::string, std::string>> choices_by_stage(const StageChoice& choice, InputKind kind);

}  // namespace geodrome
