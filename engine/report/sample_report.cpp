// SPDX-License-Identifier: MIT
#include "engine/report/sample_report.hpp"

#include <algorithm>

#include "engine/formats/text_stream.hpp"
#include "engine/surface/input_rows.hpp"

namespace geodrome {

namespace {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

SurfaceDistance distance_of(const Input& input, const PlacedSurface& surface) {
  SurfaceDistance result;
  const std::vector<Index> row_of = rows_of_elements(input);
  double sum = 0;
  std::size_t count = 0;
  for_each_live_point(input, surface, [&](Index point, const Place& place) {
    const double squared = squared_distance(place.position, surface.mesh->position(place.at));
    if (result.farthest_row == no_index || std::sqrt(squared) > result.largest)
      result.largest = std::sqrt(squared), result.farthest_row = row_of[point];
    sum += squared, ++count;
  });
  if (count > 0) result.root_mean_square = std::sqrt(sum / static_cast<double>(count));
  return result;
}

/// A sample's points are spread over a surface: their number goes with the square of 1 / epsilon.
double points_for(double wanted, double epsilon, std::size_t live) {
  if (!(epsilon > wanted)) return not_known;  // also if it is NaN
  return static_cast<double>(live) * (epsilon / wanted) * (epsilon / wanted);
}

std::string percent(double share) {
  TextOutput text;
  text.precision(3);
  text << 100 * share << " %";
  return text.str();
}

std::string number(double value) {
  TextOutput text;
  text.precision(3);
  text << value;
  return text.str();
}

class Judge {
 public:
  /// At most `good`, at most `fair`, or more.
  void weigh(double value, double good, double fair, const std::string& what) {
    if (std::isnan(value)) return;
    worsen(value <= good   ? Practice::Verdict::good
           : value <= fair ? Practice::Verdict::fair
                           : Practice::Verdict::doubtful,
           what);
  }

  void worsen(Practice::Verdict verdict, const std::string& what) {
    const bool unknown = practice_.verdict == Practice::Verdict::unknown;
    if (unknown || verdict > practice_.verdict) practice_.verdict = verdict;
    if (verdict != Practice::Verdict::good) practice_.because.push_back(what);
  }

  Practice verdict() && { return std::move(practice_); }

 private:
  Practice practice_;
};

/// The claims about faces. All held on every closed surface that came out right. A face that is larger than psi
/// explains may close a hole or join two sheets; needles at a rim, where points are as they are, harm nothing.
bool concerns_practice(const Claim& claim, bool closed) {
  if (claim.code == "circumradius_to_psi" || claim.code == "edge_to_psi") return true;
  return closed && (claim.code == "degree" || claim.code == "edge_ratio" || claim.code == "smallest_angle");
}

Practice practice_of(const SampleReport& report, const Claim& curvature, const Claim& on_surface,
                     const std::vector<Finding>& findings) {
  Judge judge;
  const bool closed = report.surface && report.surface->closed;
  const StageFigure& stars = report.figure("inconsistent_stars");
  const char* about = report.figure("epsilon").is_measured() ? "epsilon is about " : "epsilon is at least about ";
  judge.weigh(stars.value, good_stars, fair_stars, percent(stars.value) + " of the stars are inconsistent");
  judge.weigh(report.epsilon, good_epsilon, fair_epsilon, about + number(report.epsilon));
  if (report.facts.sigma > most_noise * report.diagonal)
    judge.worsen(Practice::Verdict::doubtful, "noise is over 1 % of the diagonal");
  if (on_surface.fails())
    judge.worsen(Practice::Verdict::doubtful, "a point lies " + number(on_surface.measured) + " psi off the surface");
  if (report.distance && report.distance->largest > most_distance * report.diagonal)
    judge.worsen(Practice::Verdict::doubtful, "a point lies " + percent(report.distance->largest / report.diagonal) +
                                                  " of the diagonal off the surface");
  if (const auto& torn = report.torn)
    judge.worsen(Practice::Verdict::doubtful, "rows " + std::to_string(torn->first) + " and " +
                                                  std::to_string(torn->second) +
                                                  " are neighbours, but on parts of the surface that do not meet");
  if (const auto& empty = report.empty_place)  // where there is a boundary, shadows of a scan are usual
    judge.worsen(closed ? Practice::Verdict::doubtful : Practice::Verdict::fair,
                 "the surface spans a place without points, " + number(2 * empty->radius) + " wide, near row " +
                     std::to_string(empty->nearest_row) + ", where about " + number(std::round(empty->missing)) +
                     " would be expected: if it is an opening, distances across it are too short");
  if (curvature.fails() && report.epsilon <= good_epsilon)  // else epsilon has told it
    judge.worsen(Practice::Verdict::fair, curvature.name + " fails: " + number(curvature.measured));
  for (const Claim& claim : report.guarantee.claims)
    if (claim.fails() && concerns_practice(claim, closed))
      judge.worsen(Practice::Verdict::fair, claim.name + " fails: " + number(claim.measured));
  for (const Finding& finding : findings)
    if (finding.severity == Finding::Severity::warning)
      judge.worsen(Practice::Verdict::fair, "the reconstructor warns of '" + finding.code + "'");
  if (report.refusal) judge.worsen(Practice::Verdict::refused, "the sample was refused");
  return std::move(judge).verdict();
}

}  // namespace

SampleReport make_sample_report(const Input& input, const PlacedSurface& surface, const SampleError* refusal,
                                std::optional<double> factor, std::uint64_t seed) {
  SampleReport report;
  report.facts = facts_of(input, *surface.sample);
  report.diagonal = input.facts.bounding_box_diagonal;
  report.figures = figures_of(surface.stages);
  if (report.figure("sigma").is_measured()) report.facts.sigma = report.figure("sigma").value;
  report.part = surface.part;
  if (surface.mesh) {
    report.surface = facts_of(*surface.mesh), report.distance = distance_of(input, surface);
    report.empty_place = widest_empty_place(input, surface), report.torn = torn_neighbours(input, surface);
  }
  if (refusal) report.refusal = Refusal{refusal->plugin(), refusal->message(), refusal->remedy()};
  const StageFigure& estimate = report.figure("epsilon");
  const Claim curvature = claim_curvature(surface), on_surface = claim_points_on_surface(input, surface);
  report.epsilon = estimate.is_measured() ? estimate.value : least_epsilon(surface);
  report.points_for_the_paper = points_for(epsilon_of_the_paper, report.epsilon, report.facts.live());
  report.points_for_practice = points_for(good_epsilon, report.epsilon, report.facts.live());

  std::vector<Claim> claims = claims_of(surface, seed);
  claims.push_back(claim_epsilon(estimate));
  const bool closed = !report.surface || report.surface->closed;
  report.guarantee = judge(claims, report.facts, closed, factor);
  if (refusal) report.guarantee.void_because.insert(report.guarantee.void_because.begin(), "the sample was refused");

  const std::vector<Finding>& findings = refusal ? refusal->findings() : surface.findings;
  report.practice = practice_of(report, curvature, on_surface, findings);
  claims.insert(claims.end(), {curvature, on_surface});
  report.worst = worst_places(input, surface, claims, findings);
  return report;
}

}  // namespace geodrome
