// SPDX-License-Identifier: MIT
#include "tools/bench/commands/bench_mesh.hpp"

#include <charconv>
#include <string_view>
#include <utility>
#include <vector>

#include "geodrome/engine/input.hpp"
#include "tools/shapes/fuzz_mesh.hpp"
#include "tools/shapes/hostile.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* remedy = "write shape:KIND:FACES[:SEED], hostile:NAME:SIZE[:SEED] or fuzz:SEED";

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
    throw OptionError("'" + text + "' in " + name + " is not a whole number", remedy);
  return value;
}

/// "KIND:NUMBER[:SEED]" behind the prefix.
template <class Generator>
SurfaceMesh make_of_kind(const std::string& name, Generator&& generator) {
  const std::vector<std::string> part = split(name);
  if (part.size() < 3 || part.size() > 4) throw OptionError("'" + name + "' is no shape", remedy);
  const std::uint64_t seed = part.size() == 4 ? whole_number(part[3], name) : 1;
  return generator(part[1], whole_number(part[2], name), seed);
}

SurfaceMesh read_mesh(const std::string& name) {
  Input input = read_input(name);
  if (input.kind != InputKind::mesh) throw InputError(InputFault::unsupported, name + " holds points without faces");
  return SurfaceMesh(std::move(input.positions), std::move(input.triangles));
}

SurfaceMesh make_mesh(const std::string& name) {
  if (name.starts_with("shape:")) return make_of_kind(name, shapes::mesh);
  if (name.starts_with("hostile:")) return make_of_kind(name, shapes::hostile);
  if (name.starts_with("fuzz:")) return shapes::fuzz_mesh(whole_number(name.substr(5), name)).mesh;
  return read_mesh(name);
}

}  // namespace

MeshPtr load_mesh(const std::string& name) { return std::make_shared<const SurfaceMesh>(make_mesh(name)); }

}  // namespace geodrome::bench
