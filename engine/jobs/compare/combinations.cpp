// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/combinations.hpp"

#include <algorithm>

#include "engine/formats/remedies.hpp"
#include "engine/formats/text.hpp"
#include "engine/formats/text_stream.hpp"

namespace geodrome {

namespace {

struct StageMember {
  const char* stage;
  std::string StageChoice::*choice;
};

/// In the order in which they run.
constexpr StageMember stage_members[] = {{TangentEstimator::stage, &StageChoice::tangent},
                                         {ControlFunction::stage, &StageChoice::control},
                                         {Decimator::stage, &StageChoice::decimator},
                                         {SurfaceReconstructor::stage, &StageChoice::reconstructor},
                                         {ShortestPathSolver::stage, &StageChoice::solver}};

const StageMember& member_of(const std::string& stage) {
  std::string names;
  for (const StageMember& member : stage_members) {
    if (member.stage == stage) return member;
    append_word(names, member.stage);
  }
  throw OptionError("there is no stage '" + stage + "'", "stages are " + names);
}

void check_varied(const VariedStage& varied, const StageMember& member, const StageChoice& fixed, InputKind kind) {
  if (kind == InputKind::mesh && varied.stage != ShortestPathSolver::stage)
    throw OptionError("the " + varied.stage + " is varied: the input is a mesh, which needs no stage but the solver",
                      remedies::varied_solver_or_points());
  if (fixed.*member.choice != StageChoice().*member.choice)
    throw OptionError("the " + varied.stage + " is both chosen and varied", remedies::varied_only());
}

}  // namespace

VariedStage parse_varied_stage(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw OptionError("the varied stage '" + text + "' names no choices", remedies::varied_syntax());
  VariedStage varied{text.substr(0, equals), {}};
  member_of(varied.stage);
  TextInput words(text.substr(equals + 1));
  for (std::string word; std::getline(words, word, ',');) {
    const bool is_option = word.find('=') != std::string::npos && word.find(':') == std::string::npos;
    if (is_option && !varied.choices.empty())
      varied.choices.back() += "," + word;
    else if (word.empty() || is_option)
      throw OptionError("the varied stage '" + text + "': there is no plugin before or after a comma",
                        remedies::varied_syntax());
    else
      varied.choices.push_back(word);
  }
  if (varied.choices.empty())
    throw OptionError("the varied stage '" + text + "' names no choices", remedies::varied_syntax());
  for (auto choice = varied.choices.begin(); choice != varied.choices.end(); ++choice)
    if (std::find(varied.choices.begin(), choice, *choice) != choice)
      throw OptionError("the varied stage '" + text + "' names " + *choice + " twice", "name it once");
  return varied;
}

std::vector<Combination> combinations_of(std::span<const VariedStage> varied, const StageChoice& fixed,
                                         InputKind kind) {
  std::vector<Combination> all{{"", fixed}};
  for (std::size_t k = 0; k < varied.size(); ++k) {
    const StageMember& member = member_of(varied[k].stage);
    for (const VariedStage& other : varied.first(k))
      if (other.stage == varied[k].stage)
        throw OptionError("the stage " + other.stage + " is varied twice", "name all its choices in one");
    check_varied(varied[k], member, fixed, kind);
    std::vector<Combination> longer;
    for (const Combination& before : all)
      for (const std::string& choice : varied[k].choices) {
        Combination combination{before.name + (before.name.empty() ? "" : ", ") + choice, before.choice};
        combination.choice.*member.choice = choice;
        longer.push_back(std::move(combination));
      }
    all = std::move(longer);
  }
  if (varied.empty()) all.front().name = fixed.solver;
  return all;
}

std::vector<std::pair<std::string, std::string>> choices_by_stage(const StageChoice& choice, InputKind kind) {
  std::vector<std::pair<std::string, std::string>> choices;
  for (const StageMember& member : stage_members)
    if (kind == InputKind::points || std::string_view(member.stage) == ShortestPathSolver::stage)
      choices.emplace_back(member.stage, choice.*member.choice);
  return choices;
}

}  // namespace geodrome
