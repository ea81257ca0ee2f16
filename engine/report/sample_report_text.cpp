// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iomanip>
#include <iterator>
#include <ostream>

#include "engine/formats/number_text.hpp"
#include "engine/formats/text.hpp"
#include "engine/formats/text_stream.hpp"
#include "engine/report/sample_report.hpp"

namespace geodrome {

namespace {

/// Two digits: it is an estimate.
std::string about(double count) {
  const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(count)) - 1));
  TextOutput text;
  text << std::fixed << std::setprecision(0) << std::ceil(count / unit) * unit;
  return text.str();
}

std::string not_measured(const StageFigure& figure) {
  return figure.by.empty() ? "not measured (the stage did not run)" : "not measured by " + figure.by;
}

std::string percent_or_not(const StageFigure& figure) {
  if (!figure.is_measured()) return not_measured(figure);
  TextOutput text;
  text << std::setprecision(3) << 100 * figure.value << " %";
  return text.str();
}

std::string value_or_not(const StageFigure& figure) {
  if (!figure.is_measured()) return not_measured(figure);
  TextOutput text;
  text << std::setprecision(4) << figure.value;
  return text.str();
}

void print_sample(const SampleReport& report, std::ostream& out) {
  const SampleFacts& f = report.facts;
  out << "sample     " << counted(f.points, "point", "points") << ", " << f.kept << " kept; " << f.capped << " capped, "
      << f.unbounded << " unbounded, " << f.dropped + f.nonfinite << " dropped, " << f.merged << " merged\n";
}

void print_part(const SampleReport& report, std::ostream& out) {
  if (!report.part) return;
  const SurfacePart& part = *report.part;
  if (part.points == 0) {
    out << "part       none of the sample makes a surface by itself\n";
    return;
  }
  out << "part       " << text_of(part) << ", spacing " << part.spacing
      << (report.surface ? "" : ", makes a surface by itself") << "; set aside: " << part.no_surface
      << " where the sample shows no surface that belongs to it, " << part.other_pieces << " near other pieces, "
      << part.off_surface << " off the surface, and " << part.faces_left_out << " faces that span gaps\n";
}

void print_stars(const SampleReport& report, std::ostream& out) {
  out << "stars      inconsistent: " << percent_or_not(report.figure("inconsistent_stars"));
  if (report.figure("inconsistent_stars").is_measured())
    out << " (ok below " << 100 * good_stars << " %, doubtful above " << 100 * fair_stars << " %, refused above "
        << 100 * most_stars << " %); in cocircular ties: " << percent_or_not(report.figure("star_ties"));
  out << "\n";
}

void print_density(const SampleReport& report, std::ostream& out) {
  const StageFigure& estimate = report.figure("epsilon");
  out << "density    epsilon: " << value_or_not(estimate);
  if (!estimate.is_measured() && !std::isnan(report.epsilon))
    out << ", at least " << report.epsilon << " by the curvature seen";
  if (!std::isnan(report.points_for_the_paper))
    out << "; the paper's 1/22 would take about " << about(report.points_for_the_paper) << " points";
  if (!std::isnan(report.points_for_practice))
    out << ", " << good_epsilon << " about " << about(report.points_for_practice);
  out << "\n";
}

void print_distance(const SampleReport& report, std::ostream& out) {
  if (!report.distance) return;
  const SurfaceDistance& d = *report.distance;
  out << "distance   of the points from the surface: at most " << d.largest << " (" << 100 * d.largest / report.diagonal
      << " % of the diagonal), root mean square " << d.root_mean_square << "\n";
}

void print_practice(const SampleReport& report, std::ostream& out) {
  const Practice& practice = report.practice;
  out << "practice   " << word(practice.verdict);
  for (std::size_t i = 0; i < practice.because.size(); ++i) out << (i == 0 ? ": " : "; ") << practice.because[i];
  if (practice.verdict == Practice::Verdict::unknown) out << ": neither stars nor epsilon were measured";
  out << "\n";
}

void print_guarantee(const SampleReport& report, bool all_reasons, std::ostream& out) {
  const std::vector<std::string>& because = report.guarantee.void_because;
  out << "guarantee  ";
  if (because.empty())
    out << "not refuted by the sample";
  else
    out << "of the paper is void: " << because.front();
  for (std::size_t i = 1; all_reasons && i < because.size(); ++i) out << "; " << because[i];
  if (!all_reasons && because.size() > 1) out << " (and " << because.size() - 1 << " more)";
  out << "\n";
}

void print_surface(const SurfaceFacts& s, std::ostream& out) {
  out << "surface    " << s.vertices << " vertices, " << s.faces << " faces, " << (s.closed ? "closed" : "bordered")
      << ", " << counted(s.components, "component", "components") << ", Euler number " << s.euler_number << ", "
      << (s.genus ? "genus " + std::to_string(*s.genus) : "no genus") << ", "
      << counted(s.boundary_loops, "boundary loop", "boundary loops") << "\n";
}

/// "flips: 3; lids: 0"; said once if none of them was measured.
void print_values(const SampleReport& report, std::initializer_list<const char*> names, std::ostream& out) {
  const auto measured = [&](const char* name) { return report.figure(name).is_measured(); };
  if (std::none_of(names.begin(), names.end(), measured)) {
    for (const char* name : names) out << name << (name == *std::prev(names.end()) ? ": " : ", ");
    out << not_measured(report.figure(*names.begin()));
    return;
  }
  for (const char* name : names)
    out << (name == *names.begin() ? "" : "; ") << name << ": " << value_or_not(report.figure(name));
}

/// psi >= 5 sigma is what keeps noise out of the surface.
void print_noise(const SampleReport& report, std::ostream& out) {
  const SampleFacts& f = report.facts;
  const StageFigure& sigma = report.figure("sigma");
  const bool known = sigma.is_measured() || f.sigma > 0;  // 0 is also what an estimator says that does not estimate it
  out << "noise      sigma: ";
  if (known)
    out << f.sigma;
  else
    out << not_measured(sigma);
  if (f.sigma > 0) out << " (smallest psi / sigma " << f.psi_smallest / f.sigma << ", wanted: 5 or more)";
  out << "; ";
  print_values(report, {"smoothed", "outliers"}, out);
  out << "\n";
}

void print_repair(const SampleReport& report, std::ostream& out) {
  out << "repair     ";
  print_values(report, {"flips", "lids", "rounds"}, out);
  out << "\n";
}

void print_claims(const std::vector<Claim>& claims, std::ostream& out) {
  out << "claims of the paper:\n";
  for (const Claim& claim : claims) {
    out << "  " << std::left << std::setw(44) << claim.name << std::setw(22) << "(" + claim.source + ")" << std::right;
    if (claim.is_measured())
      out << claim.measured << (claim.holds() ? ", holds" : ", FAILS") << "\n";
    else
      out << claim.not_measured << "\n";
  }
}

std::string line_of(const WorstPlace& place) {
  TextOutput line;
  line.precision(6);
  line << "point " << place.row << " at (" << place.position.x << ", " << place.position.y << ", " << place.position.z
       << "): ";
  line.precision(4);
  std::string remedy;
  for (std::size_t i = 0; i < place.troubles.size(); ++i) {
    const Trouble& t = place.troubles[i];
    line << (i == 0 ? "" : ", ") << t.what;
    if (t.has_bound) line << (t.fails ? " fails: " : ": ") << t.measured;
    if (remedy.empty()) remedy = t.remedy;
  }
  return line.str() + (remedy.empty() ? "" : "; " + remedy);
}

}  // namespace

const char* word(Practice::Verdict verdict) {
  constexpr const char* words[] = {"good", "fair", "doubtful", "refused", "unknown"};
  return words[static_cast<int>(verdict)];
}

std::string text_of(const SurfacePart& part) {
  return std::to_string(part.points) + " of " + counted(part.sample, "point", "points") + " (" +
         rounded_text(100 * part.share(), 3) + " %), around row " + std::to_string(part.row);
}

std::vector<std::string> lines_of(const std::vector<WorstPlace>& worst) {
  std::vector<std::string> lines;
  for (const WorstPlace& place : worst) lines.push_back(line_of(place));
  return lines;
}

void print_short(const SampleReport& report, std::ostream& out) {
  print_sample(report, out);
  print_part(report, out);
  print_stars(report, out);
  print_distance(report, out);
  print_practice(report, out);
  print_guarantee(report, false, out);
}

void print_full(const SampleReport& report, std::ostream& out) {
  print_sample(report, out);
  print_part(report, out);
  if (report.surface) print_surface(*report.surface, out);
  print_distance(report, out);
  print_stars(report, out);
  print_repair(report, out);
  print_density(report, out);
  print_noise(report, out);
  print_claims(report.guarantee.claims, out);
  print_guarantee(report, true, out);
  print_practice(report, out);
  out << "           (" << practice_note << ")\n";
  if (!report.worst.empty()) out << "worst places:\n";
  for (const std::string& line : lines_of(report.worst)) out << "  " << line << "\n";
  if (report.refusal)
    out << "refused    " << (report.refusal->plugin.empty() ? "" : "by " + report.refusal->plugin + ": ")
        << report.refusal->reason << "; " << report.refusal->remedy << "\n";
}

}  // namespace geodrome
