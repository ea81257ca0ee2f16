// SPDX-License-Identifier: MIT
#include "engine/report/sample_report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <tuple>

#include "tests/support/sample_surfaces.hpp"

namespace geodrome {
namespace {

using test::sampled;
using test::SampledSurface;

SampleReport report_of(const SampledSurface& made, std::optional<double> factor = {}) {
  return make_sample_report(made.input, made.surface, nullptr, factor, 1);
}

SampledSurface measured(std::map<std::string, double> measures) {
  SampledSurface made = sampled(test::octahedron(), 0.5);
  made.surface.stages.back().measures = std::move(measures);
  return made;
}

std::string full_text(const SampleReport& report) {
  std::ostringstream out;
  print_full(report, out);
  return out.str();
}

TEST(SampleReport, OfASoundSampleFindsNothingAgainstTheGuarantee) {
  const SampleReport report = report_of(measured({{"inconsistent_stars", 0}, {"epsilon", 0.04}}), 1);
  EXPECT_TRUE(report.guarantee.void_because.empty());
  EXPECT_EQ(report.practice.verdict, Practice::Verdict::good);
  EXPECT_TRUE(std::isnan(report.points_for_the_paper));
}

TEST(SampleReport, CountsPointsByWhatBecameOfThem) {
  SampledSurface made = sampled(test::octahedron(), 0.5);
  made.surface.sample->control.state = {PointState::ok,        PointState::capped,  PointState::capped,
                                        PointState::unbounded, PointState::dropped, PointState::ok};
  made.input.facts.merged = 3, made.input.facts.dropped = 2, made.input.facts.rows = 11;
  const Json json = to_json(report_of(made))["sample"];
  const std::pair<const char*, int> expected[] = {{"rows", 11},   {"points", 6},    {"capped", 2}, {"unbounded", 1},
                                                  {"dropped", 1}, {"nonfinite", 2}, {"merged", 3}, {"kept", 6}};
  for (const auto& [key, value] : expected) EXPECT_EQ(json[key], value) << key;
}

TEST(SampleReport, SaysWhoDidNotMeasureAFigureAndNeverZero) {
  const SampleReport report = report_of(sampled(test::octahedron(), 0.5));
  const Json json = to_json(report);
  for (const char* name : {"inconsistent_stars", "star_ties", "flips", "lids", "rounds", "epsilon"}) {
    EXPECT_TRUE(json["sample"][name].is_null()) << name;
    EXPECT_EQ(json["sample"]["not_measured"][name], "reconstructor_d") << name;
  }
  EXPECT_EQ(json["sample"]["not_measured"]["outliers"], "tangent_a");
  EXPECT_NE(full_text(report).find("flips, lids, rounds: not measured by reconstructor_d"), std::string::npos);
  EXPECT_NE(full_text(report).find("sigma: not measured by tangent_a"), std::string::npos);
}

TEST(SampleReport, TakesAFigureFromWhicheverStageMeasuredIt) {
  SampledSurface made = sampled(test::octahedron(), 0.5);
  made.surface.stages[1].measures["epsilon"] = 0.25;
  const StageFigure epsilon = report_of(made).figure("epsilon");
  EXPECT_EQ(epsilon.value, 0.25);
  EXPECT_EQ(epsilon.by, "control_b");
}

TEST(SampleReport, ScalesTheNumberOfPointsWithTheSquareOfEpsilon) {
  const SampleReport report = report_of(measured({{"epsilon", 0.6}}));
  EXPECT_NEAR(report.points_for_the_paper, 6 * 13.2 * 13.2, 1e-9);
  EXPECT_NEAR(report.points_for_practice, 6 * 4, 1e-9);
}

TEST(SampleReport, FallsBackOnTheCurvatureWhereNoStageEstimatedEpsilon) {
  SampledSurface made = sampled(test::octahedron(), 0.6);
  for (TangentPlane& plane : made.surface.sample->tangents.plane) plane.normal = plane.origin;
  const SampleReport report = report_of(made);
  EXPECT_NEAR(report.epsilon, 0.6, 1e-12);
  EXPECT_NEAR(report.points_for_practice, 6 * 4, 1e-9);
  EXPECT_EQ(report.practice.verdict, Practice::Verdict::doubtful);
  EXPECT_TRUE(to_json(report)["sample"]["epsilon"].is_null());
}

TEST(SampleReport, VoidsTheGuaranteeByEpsilonAlone) {
  const SampleReport report = report_of(measured({{"epsilon", 0.046}}), 1);
  ASSERT_EQ(report.guarantee.void_because.size(), 1u);
  EXPECT_NE(report.guarantee.void_because[0].find("epsilon"), std::string::npos);
}

TEST(SampleReport, SaysThatASolverThatIsNotExactVoidsTheGuarantee) {
  const SampledSurface made = measured({{"epsilon", 0.04}});
  EXPECT_TRUE(report_of(made, 1).guarantee.void_because.empty());
  EXPECT_EQ(report_of(made, 1.1).guarantee.void_because.size(), 1u);
}

TEST(SampleReport, JudgesPracticeByInconsistentStars) {
  const std::pair<double, Practice::Verdict> cases[] = {
      {0.04, Practice::Verdict::good}, {0.07, Practice::Verdict::fair}, {0.12, Practice::Verdict::doubtful}};
  for (const auto& [share, verdict] : cases)
    EXPECT_EQ(report_of(measured({{"inconsistent_stars", share}})).practice.verdict, verdict) << share;
}

TEST(SampleReport, JudgesPracticeByEpsilonApartFromTheGuarantee) {
  const std::pair<double, Practice::Verdict> cases[] = {
      {0.25, Practice::Verdict::good}, {0.4, Practice::Verdict::fair}, {0.7, Practice::Verdict::doubtful}};
  for (const auto& [epsilon, verdict] : cases) {
    const SampleReport report = report_of(measured({{"epsilon", epsilon}}), 1);
    EXPECT_EQ(report.practice.verdict, verdict) << epsilon;
    EXPECT_FALSE(report.guarantee.void_because.empty());
  }
}

TEST(SampleReport, NeverCallsAPracticeGoodWhereFacesAreLargerThanPsiExplains) {
  // The octahedron's edges are sqrt(2), its circumradii sqrt(2 / 3).
  const std::tuple<double, Practice::Verdict, const char*> cases[] = {
      {0.42, Practice::Verdict::good, ""},
      {0.39, Practice::Verdict::fair, "circumradius over psi <= 2.056 fails: 2.09"},
      {0.34, Practice::Verdict::fair, "edge length over psi <= 4.112 fails: 4.16"}};
  for (const auto& [psi, verdict, why] : cases) {
    SampledSurface made = sampled(test::octahedron(), psi);
    made.surface.stages.back().measures = {{"inconsistent_stars", 0}, {"epsilon", 0.04}};
    const Practice practice = report_of(made).practice;
    EXPECT_EQ(practice.verdict, verdict) << psi;
    EXPECT_EQ(std::ranges::count(practice.because, why), *why != 0 ? 1 : 0) << psi;
  }
}

TEST(SampleReport, NeverCallsAPracticeGoodWhereTheSurfaceBendsMoreThanTheEpsilonOfAStageSays) {
  SampledSurface made = sampled(test::octahedron(), 0.6);
  for (TangentPlane& plane : made.surface.sample->tangents.plane) plane.normal = plane.origin;
  made.surface.stages.back().measures = {{"inconsistent_stars", 0}, {"epsilon", 0.04}};
  const Practice practice = report_of(made).practice;
  EXPECT_EQ(practice.verdict, Practice::Verdict::fair);
  EXPECT_EQ(practice.because, std::vector<std::string>{"phi over radius of curvature <= 0.3 fails: 0.6"});
}

TEST(SampleReport, DoubtsNoiseOfMoreThanAHundredthOfTheDiagonal) {
  SampledSurface made = measured({{"epsilon", 0.1}});
  made.surface.sample->tangents.sigma = 0.019;  // the diagonal is 2
  EXPECT_EQ(report_of(made).practice.verdict, Practice::Verdict::good);
  made.surface.sample->tangents.sigma = 0.021;
  EXPECT_EQ(report_of(made).practice.verdict, Practice::Verdict::doubtful);
}

TEST(SampleReport, MeasuresHowFarThePointsAreFromTheSurface) {
  SampledSurface made = sampled(test::plane_grid(1), 1);
  made.surface.places[2].position.z = 0.3;
  made.surface.places[1].position.z = -0.4;
  const SampleReport report = report_of(made);
  ASSERT_TRUE(report.distance);
  EXPECT_DOUBLE_EQ(report.distance->largest, 0.4);
  EXPECT_EQ(report.distance->farthest_row, 1u);
  EXPECT_DOUBLE_EQ(report.distance->root_mean_square, 0.25);
  EXPECT_EQ(to_json(report)["sample"]["distance_from_surface"]["largest_over_diagonal"], 0.2);
}

TEST(SampleReport, DoesNotCountDroppedPointsInTheDistance) {
  SampledSurface made = sampled(test::plane_grid(1), 1);
  made.surface.places[2] = {Place::State::dropped, {}, no_index, {9, 9, 9}};
  EXPECT_EQ(report_of(made).distance->largest, 0);
}

TEST(SampleReport, OfARefusedSampleTellsReasonRemedyAndWhatWasMeasured) {
  SampledSurface made = measured({{"inconsistent_stars", 0.4}, {"epsilon", 0.9}});
  test::refuse(made);
  SampleError refusal("too sparse", "give more", {{Finding::Severity::refusal, "inconsistent_stars", "m", 1, {4}}});
  refusal.attribute_to("reconstructor_d");
  const SampleReport report = make_sample_report(made.input, made.surface, &refusal, {}, 1);
  const Json json = to_json(report);
  EXPECT_EQ(json["refused"], true);
  EXPECT_EQ(json["refusal"], Json({{"plugin", "reconstructor_d"}, {"reason", "too sparse"}, {"remedy", "give more"}}));
  EXPECT_EQ(json["sample"]["inconsistent_stars"], 0.4);
  EXPECT_EQ(json["practice"]["verdict"], "refused");
  EXPECT_EQ(json["guarantee_of_the_paper"]["verdict"], "void");
  EXPECT_FALSE(json.contains("surface"));
  EXPECT_EQ(json["worst_places"][0]["row"], 4);
  EXPECT_NE(full_text(report).find("0.3 about 54"), std::string::npos) << full_text(report);
}

TEST(SampleReport, OfASampleThatStageOneRefusedHasNothingButTheInput) {
  SampledSurface made = sampled(test::octahedron(), 0.5);
  test::refuse(made);
  made.surface.sample.emplace();
  made.surface.stages = {test::record_of("tangent", "a", {})};
  const SampleError refusal("on a line");
  const Json json = to_json(make_sample_report(made.input, made.surface, &refusal, {}, 1));
  EXPECT_EQ(json["sample"]["points"], 6);
  EXPECT_TRUE(json["sample"]["psi_smallest"].is_null());
  EXPECT_EQ(json["sample"]["not_measured"]["flips"], "its stage did not run");
  EXPECT_TRUE(json["sample"]["epsilon_at_least"].is_null());
}

}  // namespace
}  // namespace geodrome
