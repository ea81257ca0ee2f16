// SPDX-License-Identifier: MIT
#include "tools/bench/samples/topology_table.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ostream>

#include "tools/bench/samples/claim_extremes.hpp"
#include "tools/shapes/sheets.hpp"

namespace geodrome::bench {
namespace {

constexpr std::array outcome_words{"right", "refused", "wrong", "failed"};

struct Tally {
  std::array<std::size_t, outcome_words.size()> count{};
  std::size_t runs = 0, sheets = 0;
  double seconds = 0, mean_error = 0, shortest = 0, longest = 0;  ///< errors: of far pairs in sheets

  void add(const SampleResult& result) {
    ++count[static_cast<std::size_t>(result.outcome)], ++runs;
    seconds += result.seconds;
    if (!result.sheet) return;
    const DistanceErrors::Group& far = result.sheet->distances.far;
    mean_error += far.mean, ++sheets;
    shortest = std::max(shortest, far.largest_under), longest = std::max(longest, far.largest_over);
  }
  void add(const Tally& other) {
    for (std::size_t i = 0; i < count.size(); ++i) count[i] += other.count[i];
    runs += other.runs, seconds += other.seconds;
  }
};

std::string percent(double share) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g %%", 100 * share);
  return text;
}

/// What tells a line of a table apart from the others, beside shape, sampling and points.
std::string extra(const SampleCase& c) {
  if (!c.boundary.empty()) return c.boundary;
  if (c.noise > 0) return percent(c.noise);
  return c.outliers > 0 ? percent(c.outliers) : "";
}

bool same_line(const SampleCase& a, const SampleCase& b) {
  return a.shape == b.shape && a.sampling == b.sampling && a.points == b.points && extra(a) == extra(b);
}

void print_line(std::ostream& out, const SampleCase& c, const Tally& tally, const std::string& reasons) {
  char line[200];
  const auto& n = tally.count;
  std::snprintf(line, sizeof line, "%-11s %-9s %8zu  %-7s %3zu of %-3zu %8zu %8zu %8zu %9.3f\n", c.shape.c_str(),
                c.sampling.c_str(), c.points, extra(c).c_str(), n[0], tally.runs, n[1], n[2], n[3],
                tally.seconds / static_cast<double>(tally.runs));
  out << line;
  if (tally.sheets > 0) {
    std::snprintf(line, sizeof line, "    far pairs: mean error %.3f %%, worst -%.2f %% and +%.2f %%\n",
                  100 * tally.mean_error / static_cast<double>(tally.sheets), 100 * tally.shortest,
                  100 * tally.longest);
    out << line;
  }
  out << reasons << std::flush;
}

void print_total(std::ostream& out, const std::string& what, const Tally& tally) {
  char line[200];
  const auto& n = tally.count;
  std::snprintf(line, sizeof line, "%s: right %zu of %zu (%.1f %%), refused %zu, wrong %zu, failed %zu; %.1f s\n",
                what.c_str(), n[0], tally.runs, 100.0 * static_cast<double>(n[0]) / static_cast<double>(tally.runs),
                n[1], n[2], n[3], tally.seconds);
  out << line << std::flush;
}

std::string reason_line(const SampleCase& c, const SampleResult& result) {
  constexpr std::size_t first_words = 160;
  if (result.outcome == Outcome::right) return {};
  return "    seed " + std::to_string(c.seed) + " " + outcome_words[static_cast<std::size_t>(result.outcome)] + ": " +
         result.reason.substr(0, first_words) + "\n";
}

/// The family's table; returns its sums.
Tally print_family(std::ostream& out, const std::string& family, const std::vector<SampleCase>& cases,
                   const PluginHost& host, const RunSettings& settings) {
  char head[200];
  std::snprintf(head, sizeof head, "\n%-11s %-9s %8s  %-7s %10s %8s %8s %8s %9s\n", family.c_str(), "sampling",
                "points", family == "clean" ? "" : family.c_str(), "right", "refused", "wrong", "failed", "s per run");
  out << head << std::flush;
  Tally sum;
  ClaimExtremes claims;
  for (std::size_t i = 0; i < cases.size();) {
    const SampleCase& first = cases[i];
    Tally line;
    std::string reasons;
    for (; i < cases.size() && same_line(cases[i], first); ++i) {
      const SampleResult result = run_case(cases[i], host, settings);
      line.add(result);
      reasons += reason_line(cases[i], result);
      if (result.outcome == Outcome::right) claims.add(*result.surface, cases[i].seed);
    }
    print_line(out, first, line, reasons);
    sum.add(line);
  }
  if (sum.runs == 0) return sum;
  print_total(out, family, sum);
  claims.print(out);
  return sum;
}

/// The variants of a family at one shape, sampling and size: all but the seed.
std::vector<SampleCase> variants(const std::string& family, const SampleCase& plain, const TableChoice& choice) {
  std::vector<SampleCase> result;
  const auto add = [&](auto SampleCase::*member, const auto& values) {
    for (const auto& value : values) {
      result.push_back(plain);
      result.back().*member = value;
    }
  };
  if (family == "clean" || family == "sheets") result.push_back(plain);
  if (family == "boundary") add(&SampleCase::boundary, std::array<std::string, 2>{"open", "auto"});
  if (family == "noise") add(&SampleCase::noise, choice.noise);
  if (family == "outliers") add(&SampleCase::outliers, choice.outliers);
  return result;
}

}  // namespace

std::vector<SampleCase> cases_of(const std::string& family, const TableChoice& choice) {
  constexpr std::array known{"clean", "boundary", "sheets", "noise", "outliers"};
  if (std::find(known.begin(), known.end(), family) == known.end())
    throw OptionError("unknown family '" + family + "'", "valid: clean, boundary, sheets, noise, outliers");
  std::vector<std::string> samplings = choice.samplings;
  if (family == "noise" || family == "outliers") samplings.resize(std::min<std::size_t>(samplings.size(), 1));
  std::vector<SampleCase> cases;
  for (const std::string& shape : choice.shapes) {
    const bool sheet = std::ranges::count(shapes::sheet_kinds(), shape) > 0;
    if (sheet != (family == "sheets")) continue;
    if (!sheet && (expected_topology(shape).loops > 0) != (family == "boundary")) continue;
    for (const std::string& sampling : samplings) {
      if (sampling == "loose" && !sheet) continue;
      for (const std::size_t points : choice.points)
        for (SampleCase c : variants(family, {shape, sampling, points}, choice))
          for (const std::uint64_t seed : choice.seeds) {
            c.seed = seed;
            const bool seedless = sampling == "grid" && c.noise == 0 && c.outliers == 0;
            if (!seedless || seed == choice.seeds.front()) cases.push_back(c);
          }
    }
  }
  return cases;
}

void print_topology_tables(std::ostream& out, const TableChoice& choice, const PluginHost& host,
                           const RunSettings& settings) {
  Tally all;
  for (const std::string& family : choice.families)
    all.add(print_family(out, family, cases_of(family, choice), host, settings));
  if (all.runs == 0) throw OptionError("nothing to run", "the shapes given are of none of the families given");
  out << '\n';
  print_total(out, "all", all);
}

}  // namespace geodrome::bench
