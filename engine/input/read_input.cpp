// SPDX-License-Identifier: MIT
#include <new>
#include <stdexcept>

#include "engine/input/check_soup.hpp"
#include "engine/input/merge.hpp"
#include "engine/input/weights.hpp"
#include "geodrome/engine/boundary.hpp"

namespace geodrome {

Input read_input(const std::filesystem::path& path, const ReadOptions& options) {
  using namespace input;
  try {
    const SourceFile file = read_source(path);
    Soup soup = parse(file, {weight_choice(options.weights).property, options.columns});
    if (soup.vertices_by_place) merge_vertices(soup);
    return check_soup(Origin(path), options, std::move(soup), content_hash(file.bytes));
  } catch (const std::bad_alloc&) {
    throw RefusedError(path.string() + ": the file does not fit into memory", out_of_memory_remedy);
  } catch (const std::length_error&) {
    throw RefusedError(path.string() + ": the file does not fit into memory", out_of_memory_remedy);
  }
}

}  // namespace geodrome
