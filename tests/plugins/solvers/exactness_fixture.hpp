// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <iostream>
#include <string>
#include <vector>

#include "tests/plugins/solvers/fixture.hpp"
#include "tools/bench/solvers/exactness.hpp"

namespace geodrome::test {

/// Exact solvers that are judged by CGAL's, by the paths they trace and by the audit.
inline std::vector<std::string> judged_solvers() {
  std::vector<std::string> names = exact_solvers();
  std::erase(names, "cgal");
  return names;
}

/// Fails unless the solver is exact on the mesh. Where the peer is proven wrong, or silent though it could be asked,
/// that is told.
inline void expect_exact(const std::string& solver, const std::string& name, const MeshPtr& mesh,
                         const bench::ExactnessOptions& options) {
  const Plugin<ShortestPathSolver> judged = load_solver(solver), peer = load_solver("cgal");
  const bench::Exactness result = bench::judge(judged, &peer, mesh, options);
  const std::string figures =
      bench::exactness_names() + "\n" + bench::exactness_figures(result) + "\n" + bench::exactness_notes(result);
  EXPECT_TRUE(result.exact()) << solver << " on " << name << "\n" << figures;
  if (result.peer_wrong > 0) std::cout << "cgal proven wrong on " << name << "\n" << figures;
  if (mesh->manifold() && !result.peer_silent.empty())
    std::cout << "cgal silent on " << name << ": " << result.peer_silent << "\n";
}

}  // namespace geodrome::test
