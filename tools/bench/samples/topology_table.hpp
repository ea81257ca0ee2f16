// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/samples/sample_case.hpp"

namespace geodrome::bench {

/// Which samples are tried. The families: `clean`, `boundary` (the cut shapes, boundary=open and boundary=auto),
/// `sheets` (shapes that can be unrolled, with the errors of distances), and `noise`, `outliers` of the closed shapes,
/// with the first of the samplings. Only sheets come in loose lattices.
struct TableChoice {
  std::vector<std::string> families{"clean", "boundary", "sheets", "noise", "outliers"};
  std::vector<std::string> shapes{"sphere",     "ellipsoid", "torus",      "genus2",  "genus5",   "trefoil",
                                  "cut-sphere", "cut-torus", "swiss-roll", "s-curve", "slit-pipe"};
  std::vector<std::string> samplings{"uniform", "blue", "grid", "jittered", "loose"};
  std::vector<std::size_t> points{5000, 20000};
  std::vector<std::uint64_t> seeds{1, 2, 3};
  std::vector<double> noise{0.001, 0.005, 0.01};  ///< shares of the diagonal
  std::vector<double> outliers{0.01, 0.05};       ///< shares of the number of points
};

/// All cases of a family, those that differ in nothing but the seed one after the other. An exact lattice has no seed:
/// it comes once. Throws OptionError for an unknown family or shape.
std::vector<SampleCase> cases_of(const std::string& family, const TableChoice& choice);

/// Runs the cases of every family and prints a table each, line by line as they are done: how many came out right, were
/// refused, are wrong or failed, with the reasons, and the paper's constants over the right ones.
void print_topology_tables(std::ostream& out, const TableChoice& choice, const PluginHost& host,
                           const RunSettings& settings);

}  // namespace geodrome::bench
