// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/text.hpp"

#include <algorithm>
#include <cmath>

#include "engine/formats/number_text.hpp"
#include "engine/formats/text_stream.hpp"

namespace geodrome {

namespace {

/// A name that is longer has a line of its own above its figures.
constexpr std::size_t longest_name = 32;

constexpr const char* nothing = "-";

struct Column {
  const char* head;
  std::size_t width;
  std::string (*cell)(const CombinationFigures&);
  bool of_smooth = false;  ///< shown of distances on the smooth surface too
};

std::string seconds(double value) { return rounded_text(value, 3); }

std::string megabytes(const std::optional<std::uint64_t>& bytes) {
  if (!bytes) return nothing;
  const double value = static_cast<double>(*bytes) / 1e6;
  return value < 1000 ? rounded_text(value, 3) : std::to_string(std::lround(value));
}

std::string mean_of(const ErrorSummary& summary) {
  return summary.compared > 0 ? rounded_text(summary.mean, 2) : nothing;
}

std::string max_of(const ErrorSummary& summary) {
  return summary.compared > 0 ? rounded_text(summary.max, 2) : nothing;
}

std::string guarantee_text(const CombinationFigures& combination) {
  const GuaranteeFigures& guarantee = combination.guarantee;
  const std::string stated = guarantee.stated ? number_text(*guarantee.stated) : "none";
  if (guarantee.held == false) return stated + " BROKEN";
  if (!guarantee.stated) return stated;
  return stated + (guarantee.held ? " held" : " ?");
}

std::string invariants_text(const CombinationFigures& combination) {
  std::string failing;
  std::size_t more = 0;
  for (const auto& [name, check] : combination.invariants) {
    if (check.holds()) continue;
    failing.empty() ? void(failing = name) : void(++more);
  }
  if (failing.empty()) return "ok";
  return "NOT " + failing + (more > 0 ? " +" + std::to_string(more) : "");
}

std::string certified_text(const CombinationFigures& combination) {
  return combination.certified ? rounded_text(combination.certified->largest, 2) : nothing;
}

constexpr Column columns[] = {
    {"prepare", 9, [](const CombinationFigures& c) { return seconds(c.cost.prepare_seconds); }},
    {"s/source", 9, [](const CombinationFigures& c) { return seconds(c.cost.median_seconds()); }, true},
    {"peak MB", 8, [](const CombinationFigures& c) { return megabytes(c.cost.peak_bytes); }},
    {"max err", 8, [](const CombinationFigures& c) { return max_of(c.errors.all); }, true},
    {"mean", 8, [](const CombinationFigures& c) { return mean_of(c.errors.all); }, true},
    {"near", 8, [](const CombinationFigures& c) { return mean_of(c.errors.near); }, true},
    {"far", 8, [](const CombinationFigures& c) { return mean_of(c.errors.far); }, true},
    {"certified", 11, certified_text},
    {"guarantee", 11, guarantee_text},
    {"invariants", 11, invariants_text, true},
    {"no path", 8, [](const CombinationFigures& c) { return std::to_string(c.errors.unreachable); }, true}};

std::string right(const std::string& text, std::size_t width) {
  return std::string(text.size() < width ? width - text.size() : 1, ' ') + text;
}

/// The name as the first column; one that is too long ends its line.
std::string first_column(const std::string& name, std::size_t width) {
  if (name.size() <= width) return name + std::string(width - name.size(), ' ');
  return name + "\n" + std::string(width, ' ');
}

std::size_t name_width(const ComparisonFigures& figures) {
  std::size_t width = std::string_view("combination").size();
  for (const CombinationFigures& combination : figures.combinations)
    if (combination.name.size() <= longest_name) width = std::max(width, combination.name.size());
  return width;
}

bool any_certified(const ComparisonFigures& figures) {
  return std::ranges::any_of(figures.combinations,
                             [](const CombinationFigures& c) { return c.ran() && c.certified.has_value(); });
}

bool any_smooth(const ComparisonFigures& figures) {
  return std::ranges::any_of(figures.combinations,
                             [](const CombinationFigures& c) { return c.ran() && c.smooth.has_value(); });
}

/// The distances on the smooth surface as a combination of its own.
CombinationFigures smooth_of(const CombinationFigures& combination) {
  CombinationFigures smooth{.name = combination.name + ", smooth"};
  smooth.cost.source_seconds = combination.smooth->source_seconds;
  smooth.errors = combination.smooth->errors;
  smooth.invariants = combination.smooth->invariants;
  return smooth;
}

/// All columns, but for that of the intervals where no solver states any.
std::vector<Column> columns_of(const ComparisonFigures& figures) {
  std::vector<Column> shown(std::begin(columns), std::end(columns));
  if (!any_certified(figures)) std::erase_if(shown, [](const Column& c) { return c.cell == certified_text; });
  return shown;
}

void print_table(const ComparisonFigures& figures, std::ostream& out) {
  const std::size_t width = name_width(figures);
  const std::vector<Column> shown = columns_of(figures);
  out << first_column("combination", width);
  for (const Column& column : shown) out << right(column.head, column.width);
  out << "\n";
  for (const CombinationFigures& combination : figures.combinations) {
    out << first_column(combination.name, width);
    if (combination.ran())
      for (const Column& column : shown) out << right(column.cell(combination), column.width);
    else
      out << " not run: " << combination.error;
    out << "\n";
    if (!combination.ran() || !combination.smooth) continue;
    out << first_column("  smooth", width);
    const CombinationFigures smooth = smooth_of(combination);
    for (const Column& column : shown) out << right(column.of_smooth ? column.cell(smooth) : nothing, column.width);
    out << "\n";
  }
}

void print_notes(const CombinationFigures& combination, std::ostream& out) {
  const auto note = [&](const std::string& text) { out << combination.name << ": " << text << "\n"; };
  if (combination.errors.reach_differs > 0)
    note(std::to_string(combination.errors.reach_differs) + " targets are reached by only one of it and the truth");
  if (combination.errors.all.compared == 0) note("no target has both a distance and a true one above 0");
  if (combination.guarantee.held == false) note("guarantee BROKEN: " + combination.guarantee.why);
  for (const auto& [name, check] : combination.invariants)
    if (!check.holds())
      note(name + " FAILS " + std::to_string(check.violated) + " times of " + std::to_string(check.tested));
}

void print_notes(const ComparisonFigures& figures, std::ostream& out) {
  out << "truth: " << figures.truth.text << "\n"
      << "errors: |D/T - 1|; near: mean below " << near_share << " of the largest true distance, far: from "
      << far_share << " on; times in seconds, on one thread\n";
  if (any_certified(figures))
    out << "certified: what D can be off by at most, of the distance, by the solver's own lower bounds\n";
  if (any_smooth(figures))
    out << "smooth: D on the smooth surface, against the truth's there"
        << (figures.truth.kind == "file" ? ", the same file" : "") << "; s/source with the paths\n";
  for (const ComparedSource& source : figures.sources)
    if (source.off_surface > 0)
      out << "source " << source.entry << ": " << rounded_text(source.off_surface, 4)
          << " off the surface; its closest surface point is taken\n";
  for (const CombinationFigures& combination : figures.combinations) {
    if (!combination.ran()) continue;
    print_notes(combination, out);
    if (combination.smooth) print_notes(smooth_of(combination), out);
  }
}

void print_growth(const ComparisonFigures& figures, std::ostream& out) {
  const bool any = std::any_of(figures.combinations.begin(), figures.combinations.end(),
                               [](const CombinationFigures& c) { return c.ran() && !c.growth.empty(); });
  if (!any) return;
  const std::size_t width = name_width(figures);
  out << "\n" << first_column("growth", width);
  for (const char* head : {"rows", "faces", "prepare s", "s/source", "peak MB"}) out << right(head, 11);
  out << "\n";
  for (const CombinationFigures& combination : figures.combinations)
    for (const auto& [rows, cost] : combination.growth) {
      out << first_column(combination.name, width);
      for (const std::string& cell : {std::to_string(rows), std::to_string(cost.faces), seconds(cost.prepare_seconds),
                                      seconds(cost.median_seconds()), megabytes(cost.peak_bytes)})
        out << right(cell, 11);
      out << "\n";
    }
}

}  // namespace

std::string text_of(const ComparisonFigures& figures) {
  TextOutput out;
  print_table(figures, out);
  print_notes(figures, out);
  print_growth(figures, out);
  return out.str();
}

}  // namespace geodrome
