// SPDX-License-Identifier: MIT
#include "plugins/solver_merged_windows/merged_windows.hpp"

#include <string>
#include <utility>

#include "plugins/common/exact/exact_prepared.hpp"
#include "plugins/solver_merged_windows/bounded_search.hpp"

namespace geodrome {

double MergedWindowsSolver::factor(const OptionValues* values) noexcept {
  const Settings settings = options.parsed(*values);
  return settings.value == merged_windows::Value::upper ? 1 + settings.delta : infinity;
}

std::unique_ptr<PreparedSurface> MergedWindowsSolver::prepare(MeshPtr mesh, RunContext& context) const {
  constexpr std::size_t most_faces = merged_windows::Window::deepest / 2;
  if (mesh->face_count() > most_faces)
    throw CapabilityError("the mesh has more than " + std::to_string(most_faces) + " faces",
                          "choose an exact solver such as chen_han");
  return prepare_exact<merged_windows::Fallback, merged_windows::BoundedSearch>(std::move(mesh), settings_, context);
}

}  // namespace geodrome
