// SPDX-License-Identifier: MIT
// What solver_aleksandrov keeps in an index file. The first byte: 1 puts the magic word before the rest.
#include <sstream>

#include "plugins/solver_aleksandrov/pairs/pair_index.hpp"
#include "plugins/solver_chen_han/chen_han.hpp"
#include "tests/fuzzing/target.hpp"
#include "tools/shapes/small_meshes.hpp"

namespace geodrome::fuzzing {
namespace {

using aleksandrov::PairIndex;

constexpr std::size_t magic_bytes = 8;

const MeshPtr& meshed() {
  static const MeshPtr mesh = shapes::small::bumpy_torus(12, 6, 0.1, 1);
  return mesh;
}

std::string saved(const PairIndex& index) {
  std::ostringstream out;
  index.save(out);
  return std::move(out).str();
}

/// Of a mesh that is cut in parts.
std::string saved_by_search() {
  const ChenHanSolver exact{OptionValues(ChenHanSolver::options)};
  QuietContext quiet;
  return saved(PairIndex(meshed(), 1.5, exact, quiet));
}

}  // namespace

void check_pair_index(std::string_view input) {
  static const std::string magic = saved_by_search().substr(0, magic_bytes);
  const std::string bytes = (Choices(input).bit(0) ? magic : "") + std::string(rest_of(input));
  const auto index = read_or_refusal("pair index", bytes, [&] {
    std::istringstream in(bytes);
    return PairIndex(*meshed(), in);
  });
  if (!index) return;
  demand(bytes.starts_with(saved(*index)), "an index that is saved reads back");
  for (Index from = 0; from < meshed()->vertex_count(); from += 5)
    for (Index to = 0; to < meshed()->vertex_count(); ++to) {
      const aleksandrov::Bounds bounds = index->between(from, to);
      demand(bounds.least >= 0 && bounds.most >= 0, "bounds of distances are distances");
    }
}

std::vector<std::string> pair_index_seeds() {
  const std::string bytes = saved_by_search();
  return {std::string(1, '\0') + bytes, std::string(1, '\1') + bytes.substr(magic_bytes)};
}

}  // namespace geodrome::fuzzing
