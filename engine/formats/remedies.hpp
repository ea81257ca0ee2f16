// SPDX-License-Identifier: MIT
#pragma once

#include "geodrome/engine/remedies.hpp"

/// The remedies that name a member or a function of the library, and so have a code: every program can say how its own
/// users set that member. The sentences are in `remedies.cpp`.
namespace geodrome::remedies {

// Outputs of jobs
Remedy consent();             ///< to a matrix that is larger than jobs write unasked
Remedy distances_output();    ///< for a job that would write nothing
Remedy matrix_output();       ///< for an option that only a matrix has
Remedy nearest_output();      ///< for an option that only the table of nearest sources has
Remedy pairs_output();        ///< for pairs that would be written nowhere
Remedy page_output();         ///< for a page whose template was not built
Remedy go_on();               ///< with an unfinished matrix
Remedy go_on_after_repair();  ///< with a matrix that changed on the disk
/// For an unfinished matrix that is not this job's; `otherwise` is what else helps.
Remedy start_anew(std::string otherwise);
Remedy other_index();  ///< for a file that is no index of pairs

// Reading
Remedy weld();                               ///< for vertices at one place
Remedy weld_within(std::string tolerance);   ///< for vertices at one place but for rounding
Remedy drop_nonfinite();                     ///< for points that are not finite
Remedy choose_columns(std::string columns);  ///< of a table that does not tell; `columns` is an example
Remedy take_points();                        ///< for a file without faces
Remedy take_vertices();                      ///< for a file whose faces are of no use
Remedy finite_points();                      ///< for a mesh with vertices that are not finite
Remedy use_weights(std::string property);    ///< for weights that were passed over

// Parts of a sample
/// For a sample that makes no surface as a whole: `what` the part is; `otherwise` is what else helps, or empty.
Remedy take_part(std::string what, const std::string& otherwise);
Remedy whole_sample();     ///< for a sample that has no such part
Remedy whole_or_points();  ///< for a mesh, which is taken as it is

// Points off the surface
Remedy default_rule();                          ///< for a rule that goes with something else not
Remedy default_rule_or(std::string otherwise);  ///< `otherwise` is what else helps
Remedy default_rule_or_points();                ///< for a rule that needs a sample, and a mesh
Remedy insertion_or_default_rule();             ///< for a rule that has no paths

// Metrics
Remedy flat_metric();                     ///< for what is not measured on a smooth surface
Remedy flat_metric_or_other_estimator();  ///< for a tangent estimator that fits none
Remedy smooth_metric_or_no_flat_path();   ///< for a flat path beside a path that is flat
Remedy no_index_or_flat_metric();         ///< for an oracle's index beside smooth distances

// Choices of plugins
Remedy varied_syntax();            ///< for choices that cannot be read
Remedy varied_only();              ///< for a stage that is both chosen and varied
Remedy varied_solver_or_points();  ///< for a sample stage that is varied, and a mesh
Remedy solver_that_provides();     ///< what another does not provide
Remedy solver_that_needs_less();   ///< than the mesh has
Remedy solver_with_bounds();       ///< for lower bounds, where a solver has none
/// For a solver without a pair oracle; `able` names those that have one, separated by commas, or is empty.
Remedy solver_of_pairs(const std::string& able);

}  // namespace geodrome::remedies
