// SPDX-License-Identifier: MIT
// The audits of a session: silent about what it gave, and not about what was changed afterwards.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "geodrome/engine/session.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/temporary_folder.hpp"

namespace geodrome::testing {
namespace {

using Strings = std::vector<std::string>;

class SessionAudits : public ::testing::Test {
 protected:
  static Session on_torus(const RunSettings& settings = {}) {
    const MeshPtr mesh = test::bumpy_torus(12, 8, 0.05, 2);
    return Session(make_input({.positions = mesh->positions(), .faces = mesh->triangles()}), settings);
  }
};

/// Sources in one face, at a vertex, and one that starts late.
std::vector<NamedPoint> some_sources(const Session& session) {
  const SurfacePoint inside[] = {{3, {0.2, 0.3, 0.5}}, {3, {0.6, 0.2, 0.2}}};
  std::vector<NamedPoint> sources = session.select(inside);
  for (const NamedPoint& vertex : session.select("50,70")) sources.push_back(vertex);
  sources.back().start = 0.25;
  return sources;
}

TEST_F(SessionAudits, OfNearestDistancesFindWhatWasChanged) {
  const Session session = on_torus();
  const auto sources = some_sources(session), targets = session.select("all");
  const std::vector<Distance> given = session.nearest(sources, targets);
  EXPECT_EQ(session.audit_nearest(sources, targets, given, infinity, 1), Strings{});
  const auto changed = [&](auto&& change) {
    std::vector<Distance> wrong = given;
    change(wrong[20]);
    return session.audit_nearest(sources, targets, wrong);
  };
  EXPECT_EQ(changed([](Distance& d) { d.value *= 1.000001; }).size(), 1u);
  EXPECT_EQ(changed([](Distance& d) { d.value *= 0.999999; }).size(), 1u);
  EXPECT_EQ(changed([](Distance& d) { d.source = (d.source + 1) % 4; }).size(), 1u);
  EXPECT_EQ(changed([](Distance& d) { d.source = no_index; }).size(), 1u);
  EXPECT_GE(changed([](Distance& d) { d = {}; }).size(), 1u);
}

TEST_F(SessionAudits, OfNearestDistancesWithALimit) {
  const Session session = on_torus();
  const auto sources = some_sources(session), targets = session.select("all");
  std::vector<Distance> given = session.nearest(sources, targets, 0.7);
  EXPECT_EQ(session.audit_nearest(sources, targets, given, 0.7, 1), Strings{});
  const auto reached = std::ranges::find_if(given, [](const Distance& d) { return d.value > 0.2 && d.value < 0.6; });
  ASSERT_NE(reached, given.end());
  *reached = {infinity, Reach::beyond_limit, no_index};
  EXPECT_EQ(session.audit_nearest(sources, targets, given, 0.7).size(), 1u);
}

TEST_F(SessionAudits, OfAPathFindWhatWasChanged) {
  const Session session = on_torus();
  const auto ends = session.select("0,60");
  const PathResult path = session.path(ends[0], ends[1]);
  EXPECT_EQ(session.audit_path(ends[0], ends[1], path), Strings{});
  const auto changed = [&](auto&& change) {
    PathResult wrong = path;
    change(wrong);
    return session.audit_path(ends[0], ends[1], wrong);
  };
  EXPECT_FALSE(changed([](PathResult& p) { p.distance *= 1.0001; }).empty());
  EXPECT_FALSE(changed([](PathResult& p) { p.length *= 0.9999; }).empty());
  EXPECT_FALSE(changed([](PathResult& p) { p.points.erase(p.points.begin() + 1); }).empty());
  EXPECT_FALSE(changed([](PathResult& p) { p.points.clear(), p.length = 0; }).empty());
  EXPECT_FALSE(changed([](PathResult& p) { p = {.distance = infinity}; }).empty());
  EXPECT_FALSE(session.audit_path(ends[0], session.select("61")[0], path).empty()) << "another end";
}

TEST_F(SessionAudits, OfPairsFindWhatWasChanged) {
  RunSettings settings;
  settings.stages.solver = "test_pairs";
  settings.plugin_path = {GEODROME_BINARY_DIR "/tests/sound_plugins"};
  const Session session = on_torus(settings);
  const auto rows = session.select("0,9,60,61");
  const std::vector<NamedPair> pairs{{rows[0], rows[1]}, {rows[2], rows[3]}};
  std::vector<double> values = session.pairs(pairs);
  EXPECT_EQ(session.audit_pairs(pairs, values), Strings{});
  values[1] *= 1.0001;
  EXPECT_EQ(session.audit_pairs(pairs, values).size(), 1u);
  EXPECT_NE(session.audit_pairs(pairs, values)[0].find("pair 1"), std::string::npos);
}

TEST_F(SessionAudits, AskForAsManyAsWereAsked) {
  const Session session = on_torus();
  const auto rows = session.select("0,9");
  EXPECT_THROW(session.audit_nearest(rows, rows, {}), OptionError);
  EXPECT_THROW(session.audit_nearest(rows, rows, session.nearest(rows, rows), infinity, 0), OptionError);
  EXPECT_THROW(session.audit_pairs({}, std::vector<double>{1}), OptionError);
}

}  // namespace
}  // namespace geodrome::testing
