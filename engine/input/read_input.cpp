// SPDX-License-Identifier: MIT
#include <new>
#include <stdexcept>

#include "engine/input/check_soup.hpp"
#include "engine/input/merge.hpp"
#include "engine/input/weights.hpp"

namespace geodrome {

Input read_input(const std::filesystem::path& path, const ReadOptions& options) {
  using namespace input;
  try {
    const SourceFile file = read_source(path);
    Soup soup = parse(file, {weight_choice(options.weights).property, options.columns});
    if (soup.vertices_by_place) merge_vertices(soup);
    return check_soup(Origin(path), options, std::move(soup), content_hash(file.bytes));
  } catch (const std::bad_alloc&) {
    throw InputError(InputFault::unsupported, path.string() + ": the file does not fit into memory");
  } catch (const std::length_error&) {
    throw InputError(InputFault::unsupported, path.string() + ": the file does not fit into memory");
  }
}

}  // namespace geodrome
