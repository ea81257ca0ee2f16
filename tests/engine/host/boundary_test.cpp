// SPDX-License-Identifier: MIT
#include "geodrome/engine/boundary.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ostream>

#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/shortest_path_solver.hpp"

namespace geodrome {
namespace {

/// Loads a plugin of tests/bad_plugins and lets it compute.
void compute_with(const std::string& name) {
  const PluginHost host({std::string(GEODROME_BINARY_DIR) + "/tests/bad_plugins"});
  const auto solver = host.load<ShortestPathSolver>(name);
  const auto mesh = std::make_shared<const SurfaceMesh>(std::vector<Vec3>{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}},
                                                        std::vector<Triangle>{{0, 1, 2}});
  solver.call([&](const auto& s) { return distances(s, mesh, {0, {1, 0, 0}}); });
}

template <class Kind>
std::string message_of(const std::string& name) {
  try {
    compute_with(name);
  } catch (const Kind& error) {
    return error.what();
  }
  return "(no error of that kind)";
}

TEST(Boundary, AnExceptionWhileComputingNamesPluginStageAndFile) {
  const std::string message = message_of<PluginError>("bad_throws_in_run");
  EXPECT_EQ(message.find("solver_bad_throws_in_run: stage solver failed: wavefront is empty; choose another solver"),
            0u)
      << message;
  EXPECT_NE(message.find("bad_plugins/solver_bad_throws_in_run.so"), std::string::npos) << message;
}

TEST(Boundary, WhatIsNoExceptionIsToldToo) {
  const std::string message = message_of<PluginError>("bad_throws_number_in_run");
  EXPECT_EQ(message.find("solver_bad_throws_number_in_run: stage solver failed: an exception of unknown type"), 0u)
      << message;
}

TEST(Boundary, AnErrorOfGeodromeKeepsItsType) {
  EXPECT_EQ(message_of<NumericalError>("bad_throws_error_in_run"),
            "solver_bad_throws_error_in_run: two windows overlap");
}

struct Crash {
  const char *name, *what;
};

void PrintTo(const Crash& crash, std::ostream* out) { *out << crash.name; }

class BoundaryDeathTest : public ::testing::TestWithParam<Crash> {};

TEST_P(BoundaryDeathTest, EndsWithStatus5AndNamesThePlugin) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const std::string name = GetParam().name;
  const std::string expected = "geodrome: plugin solver_" + name + " \\(stage solver\\) " + GetParam().what +
                               " while computing; choose another solver plugin or report this to its author "
                               "\\(.*solver_" +
                               name + "\\.so\\)";
  EXPECT_EXIT((install_crash_handlers(), compute_with(name)), ::testing::ExitedWithCode(5), expected);
}

INSTANTIATE_TEST_SUITE_P(Crashes, BoundaryDeathTest,
                         ::testing::Values(Crash{"bad_crashes_in_run", "crashed with SIGSEGV"},
                                           Crash{"bad_overflows_in_run", "crashed with SIGSEGV"},
                                           Crash{"bad_aborts_in_run", "crashed with SIGABRT"},
                                           Crash{"bad_terminates_in_run",
                                                 "ended the program with an exception: thread lost its way"}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Boundary, ACrashOutsideOfPluginsBlamesNone) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT((install_crash_handlers(), std::abort()), ::testing::ExitedWithCode(1),
              "geodrome: crashed with SIGABRT outside of any plugin");
}

TEST(Boundary, AScopeEndsWithItsPlugin) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  PluginInfo plugin;
  plugin.stage = "solver", plugin.name = "innocent";
  const auto crash_after_scope = [&] {
    install_crash_handlers();
    cross_boundary(plugin, [] { return 0; });
    std::abort();
  };
  EXPECT_EXIT(crash_after_scope(), ::testing::ExitedWithCode(1), "outside of any plugin");
}

TEST(Boundary, ALackOfMemoryIsARefusalThatNamesThePlugin) {
  PluginInfo plugin;
  plugin.stage = "solver", plugin.name = "large";
  try {
    cross_boundary(plugin, [] { throw std::bad_alloc(); });
    FAIL() << "nothing was thrown";
  } catch (const RefusedError& error) {
    EXPECT_EQ(error.plugin(), "solver_large");
    EXPECT_EQ(error.message(), "stage solver ran out of memory");
  }
}

TEST(Boundary, ALackOfMemoryThatEndsTheProgramIsToldAsSuch) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto run_out = []() noexcept { std::rethrow_exception(std::make_exception_ptr(std::bad_alloc())); };
  EXPECT_EXIT((install_crash_handlers(), run_out()), ::testing::ExitedWithCode(4), "geodrome: out of memory");
}

}  // namespace
}  // namespace geodrome
