// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <vector>

#include "engine/report/json.hpp"
#include "engine/report/sample_report.hpp"
#include "engine/surface/opened.hpp"

/// What the reports of all jobs have in common.
namespace geodrome {

std::uint64_t peak_memory_bytes();

/// Versions, seed, threads.
Json settings_json(const RunSettings& settings);

/// The sample report of a job whose sample was not refused; none for a mesh. `factor`: the solver's.
std::optional<SampleReport> sample_report_of(const Opened& opened, double factor, std::uint64_t seed);

/// Input, surface, sample report, stages, the solver's factor, into `json`.
void add_provenance(Json& json, const Opened& opened, const std::optional<SampleReport>& sample,
                    const SurfaceFacts& surface, const PreparedSolver& solver);

/// The report of a job whose sample was refused, as JSON: `settings` and what is known up to there.
std::string refusal_report(const Json& settings, const Opened& opened, std::uint64_t seed);

/// Lines "input", "surface" and "solver".
void summarize_provenance(const Input& input, const SurfaceFacts& surface, const PreparedSolver& solver,
                          std::ostream& out);

}  // namespace geodrome
