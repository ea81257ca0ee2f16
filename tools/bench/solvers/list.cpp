// SPDX-License-Identifier: MIT
#include "tools/bench/solvers/list.hpp"

#include <algorithm>

namespace geodrome::bench {
namespace {

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    if (end > begin) parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

bool is_option(std::string_view part) {
  return part.find('=') != std::string_view::npos && part.find(':') > part.find('=');
}

}  // namespace

std::vector<std::string> split_solvers(std::string_view list) {
  std::vector<std::string> solvers;
  for (const std::string& part : split(list, ','))
    if (is_option(part) && !solvers.empty())
      solvers.back() += "," + part;
    else
      solvers.push_back(part);
  return solvers;
}

std::string without_option(std::string_view solver, std::string_view key) {
  const std::size_t colon = std::min(solver.find(':'), solver.size());
  std::string rest(solver.substr(0, colon));
  char before = ':';
  for (const std::string& option : split(solver.substr(std::min(colon + 1, solver.size())), ',')) {
    if (option.substr(0, option.find('=')) == key) continue;
    rest += before + option;
    before = ',';
  }
  return rest;
}

}  // namespace geodrome::bench
