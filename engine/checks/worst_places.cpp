// SPDX-License-Identifier: MIT
#include "engine/checks/worst_places.hpp"

#include <algorithm>
#include <map>

#include "engine/surface/input_rows.hpp"

namespace geodrome {

namespace {

/// Points nearer than this times psi are one place: about the longest edge that Lemma 9 allows, so that what is wrong
/// with a face is not shown once for each of its corners.
constexpr double same_place_psi = 5;

/// Where no stage gave a psi: this share of the bounding box's diagonal.
constexpr double same_place_diagonal = 0.01;

/// What is asked of the user, by what fails.
std::string remedy_for(const std::string& code, bool decimated) {
  static const std::string denser = "sample more densely here";
  static const std::map<std::string, std::string> remedies = {
      {"circumradius_to_psi", denser + ": the surface spans a gap"},
      {"edge_to_psi", denser + ": the surface spans a gap"},
      {"phi_to_curvature_radius", denser + ": the surface bends too much between two points"},
      {"psi_lipschitz", "choose another control plugin"},
      {"off_surface", "remove the point if it is an outlier, else " + denser},
      {"inconsistent_stars", denser + ", or smooth the noise away"},
      {"repaired", denser + ", or smooth the noise away"},
      {"boundary", denser + " if the surface should be closed, say boundary=open if not"},
      {"one_sided", "give the strip as a mesh, or cut it open across here"},
      {"unused_points", "remove outliers, or " + denser},
      {"components", denser + " if the parts belong together"}};
  if (const auto found = remedies.find(code); found != remedies.end()) return found->second;
  return decimated ? denser : "sample more evenly here, or decimate (decimator greedy)";
}

/// Candidates of one kind, worst first.
struct Kind {
  Trouble trouble;  ///< without what differs from place to place
  const Claim* claim = nullptr;
  std::vector<PlacedValue> candidates;
  std::size_t failing = 0;  ///< the first so many fail

  Trouble trouble_at(const PlacedValue& candidate) const {
    Trouble at = trouble;
    if (claim) at.measured = candidate.measured, at.fails = claim->strain(candidate.measured) > 1;
    if (!at.fails) at.remedy.clear();
    return at;
  }
};

Kind kind_of(const Claim& claim, bool decimated) {
  Kind kind{{}, &claim, claim.places, 0};
  kind.trouble = {claim.code, claim.name, true, true, 0, claim.bound, claim.source, remedy_for(claim.code, decimated)};
  const auto holds = [&](const PlacedValue& value) { return claim.strain(value.measured) <= 1; };
  kind.failing =
      static_cast<std::size_t>(std::find_if(claim.places.begin(), claim.places.end(), holds) - claim.places.begin());
  return kind;
}

Kind kind_of(const Finding& finding, const Input& input, bool decimated) {
  Kind kind;
  std::string what = finding.code;
  std::replace(what.begin(), what.end(), '_', ' ');
  kind.trouble = {finding.code, what, true, false, 0, 0, "", remedy_for(finding.code, decimated)};
  for (const Index row : finding.elements)
    if (row < input.element_of_row.size() && input.element_of_row[row] != no_index)
      kind.candidates.push_back({input.element_of_row[row], 0});
  kind.failing = kind.candidates.size();
  return kind;
}

/// Refusals, warnings, then claims.
std::vector<Kind> kinds_of(const Input& input, const PlacedSurface& surface, std::span<const Claim> claims,
                           std::span<const Finding> findings) {
  const bool decimated = surface.sample->kept.size() < input.positions.size();
  std::vector<Kind> kinds;
  for (const auto severity : {Finding::Severity::refusal, Finding::Severity::warning})
    for (const Finding& finding : findings)
      if (finding.severity == severity) kinds.push_back(kind_of(finding, input, decimated));
  for (const Claim& claim : claims) kinds.push_back(kind_of(claim, decimated));
  return kinds;
}

/// Chooses points that are no neighbours of each other.
class Chooser {
 public:
  Chooser(const Input& input, const std::vector<double>& psi) : input_(input), psi_(psi) {}

  bool full() const { return chosen_.size() == worst_places_shown; }
  const std::vector<Index>& chosen() const { return chosen_; }

  bool choose(Index point) {
    if (place_of(point) < chosen_.size()) return false;
    chosen_.push_back(point);
    return true;
  }

  /// The nearest chosen place that the point belongs to; their number if there is none.
  std::size_t place_of(Index point) const {
    std::size_t best = chosen_.size();
    double nearest = infinity;
    for (std::size_t k = 0; k < chosen_.size(); ++k) {
      const double apart = distance(input_.positions[point], input_.positions[chosen_[k]]);
      if (apart > std::max(reach(point), reach(chosen_[k])) || apart >= nearest) continue;
      best = k, nearest = apart;
    }
    return best;
  }

 private:
  double reach(Index point) const {
    if (point < psi_.size() && std::isfinite(psi_[point])) return same_place_psi * psi_[point];
    return same_place_diagonal * input_.facts.bounding_box_diagonal;
  }

  const Input& input_;
  const std::vector<double>& psi_;
  std::vector<Index> chosen_;
};

/// One place of each kind in turn, as long as any has a failing candidate left.
void choose_failing(const std::vector<Kind>& kinds, Chooser& chooser) {
  std::vector<std::size_t> next(kinds.size(), 0);
  for (bool any = true; any && !chooser.full();) {
    any = false;
    for (std::size_t s = 0; s < kinds.size() && !chooser.full(); ++s)
      while (next[s] < kinds[s].failing)
        if (chooser.choose(kinds[s].candidates[next[s]++].point)) {
          any = true;
          break;
        }
  }
}

/// Whatever strains a bound most, of all claims.
std::vector<std::pair<const Kind*, PlacedValue>> choose_strained(const std::vector<Kind>& kinds, Chooser& chooser) {
  std::vector<std::pair<const Kind*, PlacedValue>> all, added;
  for (const Kind& kind : kinds)
    for (std::size_t i = kind.failing; i < kind.candidates.size() && kind.claim->strain_tells; ++i)
      all.push_back({&kind, kind.candidates[i]});
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.first->claim->strain(a.second.measured) > b.first->claim->strain(b.second.measured);
  });
  for (const auto& candidate : all) {
    if (chooser.full()) break;
    if (chooser.choose(candidate.second.point)) added.push_back(candidate);
  }
  return added;
}

void tell(WorstPlace& place, Trouble trouble) {
  const auto same = [&](const Trouble& told) { return told.code == trouble.code; };
  if (std::none_of(place.troubles.begin(), place.troubles.end(), same)) place.troubles.push_back(std::move(trouble));
}

}  // namespace

std::vector<WorstPlace> worst_places(const Input& input, const PlacedSurface& surface, std::span<const Claim> claims,
                                     std::span<const Finding> findings) {
  const std::vector<Kind> kinds = kinds_of(input, surface, claims, findings);
  Chooser chooser(input, surface.sample->control.psi);
  choose_failing(kinds, chooser);
  const std::size_t failing = chooser.chosen().size();
  const auto strained = choose_strained(kinds, chooser);

  const std::vector<Index> row_of = rows_of_elements(input);
  std::vector<WorstPlace> places;
  for (const Index point : chooser.chosen()) places.push_back({row_of[point], input.positions[point], {}});
  for (const Kind& kind : kinds)
    for (std::size_t i = 0; i < kind.failing; ++i)
      if (const std::size_t k = chooser.place_of(kind.candidates[i].point); k < places.size())
        tell(places[k], kind.trouble_at(kind.candidates[i]));
  for (std::size_t k = 0; k < strained.size(); ++k)
    tell(places[failing + k], strained[k].first->trouble_at(strained[k].second));
  return places;
}

}  // namespace geodrome
