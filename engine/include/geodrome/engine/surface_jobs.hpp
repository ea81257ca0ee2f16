// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geodrome/engine/observer.hpp"
#include "geodrome/engine/pipeline.hpp"

/// The jobs that end before the solver: what a file holds, and the surface that is made of it.
namespace geodrome {

/// Checks what a file holds; of points also what stages 1 to 4 make of it, unless `input_only`.
struct CheckJob {
  std::filesystem::path input;
  RunSettings settings;
  bool input_only = false;
};

/// The report as JSON text and for people. A sample that a stage refuses is no exception here: it is told with all that
/// was learned up to there.
struct CheckReport {
  std::string json, text;
  std::optional<SampleError> refusal;
};

/// Throws what reading and the stages throw, but for SampleError.
CheckReport run_check(const CheckJob& job, Observer& observer);

/// The JSON that stands in the place of `CheckReport::json` for a file that cannot be read: "usable" false, the file,
/// and the error with its fault, its message, and `remedy`, the words for what can be done.
std::string unusable_json(const std::filesystem::path& file, const InputError& error, const std::string& remedy);

/// The surface of a point sample; of a mesh the mesh as it is used, weights included.
struct SurfaceJob {
  std::filesystem::path input;
  RunSettings settings;       ///< `stages.solver` is not used
  std::filesystem::path out;  ///< .ply, .off, .obj or .stl; .ply for a mesh with weights; empty: not written
  ScalarType scalar = ScalarType::float64;  ///< of the coordinates of .ply; .stl has float32 always
};

/// Makes the surface, writes it, and gives it back. Throws what reading and the stages throw, OptionError for a name
/// that cannot be written, InputError (io) if writing fails.
MeshPtr run_surface(const SurfaceJob& job, Observer& observer);

}  // namespace geodrome
