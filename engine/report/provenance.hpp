// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <vector>

#include "engine/report/json.hpp"
#include "engine/report/sample_report.hpp"
#include "engine/search/prepared_solver.hpp"
#include "engine/surface/opened.hpp"

/// The parts that the reports of all jobs have in common.
namespace geodrome {

/// Versions, seed, threads.
Json settings_json(const RunSettings& settings);

/// Surface, sample report and stages, into `json`.
void add_surface(Json& json, const Opened& opened, const std::optional<SampleReport>& sample,
                 const SurfaceFacts& surface);

/// Surface, sample report and stages, as `add_surface`, with the input, and with the solver as the last stage.
void add_provenance(Json& json, const Opened& opened, const std::optional<SampleReport>& sample,
                    const SurfaceFacts& surface, const PreparedSolver& solver);

/// The report of a job whose sample was refused, as JSON: `settings` and what is known up to there.
std::string refusal_report(const Json& settings, const Opened& opened, const SampleReport& sample);

/// Lines "input", "surface" and "solver".
void summarize_provenance(const Input& input, const SurfaceFacts& surface, const PreparedSolver& solver,
                          std::ostream& out);

}  // namespace geodrome
