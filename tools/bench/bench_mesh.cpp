// SPDX-License-Identifier: MIT
#include "tools/bench/bench_mesh.hpp"

#include <charconv>
#include <string_view>
#include <vector>

#include "geodrome/engine/input.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

constexpr std::string_view prefix = "shape:";

std::vector<std::string> split(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(':', begin), text.size());
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

std::uint64_t whole_number(const std::string& text, const std::string& name) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw OptionError("'" + text + "' in " + name + " is not a whole number", "write shape:KIND:FACES[:SEED]");
  return value;
}

MeshPtr make_shape(const std::string& name) {
  const std::vector<std::string> part = split(std::string_view(name).substr(prefix.size()));
  if (part.size() < 2 || part.size() > 3)
    throw OptionError("'" + name + "' is no shape", "write shape:KIND:FACES[:SEED]");
  const std::uint64_t seed = part.size() == 3 ? whole_number(part[2], name) : 1;
  return std::make_shared<const SurfaceMesh>(shapes::mesh(part[0], whole_number(part[1], name), seed));
}

}  // namespace

MeshPtr load_mesh(const std::string& name) {
  if (name.starts_with(prefix)) return make_shape(name);
  Input input = read_input(name);
  if (input.kind != InputKind::mesh) throw InputError(InputFault::unsupported, name + " holds points without faces");
  return std::make_shared<const SurfaceMesh>(std::move(input.positions), std::move(input.triangles));
}

}  // namespace geodrome::bench
