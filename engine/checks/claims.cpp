// SPDX-License-Identifier: MIT
#include "engine/checks/claims.hpp"

#include <algorithm>
#include <numbers>
#include <random>

#include "engine/surface/face_shape.hpp"
#include "engine/checks/gauge.hpp"
#include "engine/surface/input_rows.hpp"
#include "engine/checks/surface_facts.hpp"

namespace geodrome {

namespace {

constexpr std::size_t random_pairs = 10'000;

/// The gauges of the paper's bounds, and what feeds them.
class PaperGauges {
 public:
  explicit PaperGauges(const PlacedSurface& surface)
      : surface_(surface), psi_(surface.sample->control.psi), points_(surface.sample->smoothed.points) {}

  void add_edge(Index a, Index b) {
    if (a == no_index || b == no_index) return;
    const double length = distance(points_[a], points_[b]);
    const Index low = psi_[b] < psi_[a] ? b : a, high = low == a ? b : a;
    edge_to_psi_.add(low, length / psi_[low]);
    lemma_6_.add(high, length / psi_[high]);
  }

  void add_pair(Index a, Index b) {
    if (a == b || a == no_index || b == no_index || std::isnan(psi_[a]) || std::isnan(psi_[b])) return;
    lipschitz_.add(psi_[b] > psi_[a] ? b : a, std::abs(psi_[a] - psi_[b]) / distance(points_[a], points_[b]));
  }

  void add_face(Index f) {
    const Triangle& t = surface_.mesh->triangles()[f];
    const auto& sample_of = surface_.sample->sample_of_vertex;
    const std::array<Index, 3> corner{sample_of[t[0]], sample_of[t[1]], sample_of[t[2]]};
    const FaceShape shape = shape_of(surface_.mesh->corners(f));
    for (int i = 0; i < 3; ++i) {
      add_edge(corner[i], corner[(i + 1) % 3]);
      add_pair(corner[i], corner[(i + 1) % 3]);
      angle_.add(corner[i], shape.angle[i]);
    }
    const auto shortest = std::min_element(shape.length.begin(), shape.length.end()) - shape.length.begin();
    edge_ratio_.add(corner[(shortest + 1) % 3], shape.edge_ratio);
    Index tightest = no_index;
    for (const Index c : corner)
      if (c != no_index && (tightest == no_index || psi_[c] < psi_[tightest])) tightest = c;
    if (tightest != no_index) circumradius_.add(tightest, shape.circumradius / psi_[tightest]);
  }

  void add_surface() {
    for (Index f = 0; f < surface_.mesh->face_count(); ++f) add_face(f);
    const std::vector<std::size_t> degrees = degrees_of(*surface_.mesh);
    for (std::size_t v = 0; v < degrees.size(); ++v)
      degree_.add(surface_.sample->sample_of_vertex[v], static_cast<double>(degrees[v]));
  }

  void add_random_pairs(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    for (std::size_t k = 0; k < random_pairs && !psi_.empty(); ++k) {
      const auto i = static_cast<Index>(random() % psi_.size());
      add_pair(i, static_cast<Index>(random() % psi_.size()));
    }
  }

  /// Lemma 6 as the decimator itself measured it, where it did.
  void add_records() {
    for (const StageRecord& stage : surface_.stages)
      if (const auto found = stage.measures.find("lemma_6_worst_ratio"); found != stage.measures.end())
        lemma_6_.add(no_index, found->second);
  }

  std::vector<Claim> finish() && {
    constexpr const char* no_psi = "there is no psi";
    constexpr const char* no_surface = "there is no surface";
    std::vector<Claim> claims;
    claims.push_back(std::move(lipschitz_).finish(no_psi));
    claims.push_back(std::move(lemma_6_).finish(no_surface));
    for (Claim& claim : claims) claim.strain_tells = false;
    for (Gauge* gauge : {&circumradius_, &edge_to_psi_, &degree_, &edge_ratio_, &angle_})
      claims.push_back(std::move(*gauge).finish(no_surface));
    return claims;
  }

 private:
  static constexpr auto at_most = Claim::Sense::at_most, at_least = Claim::Sense::at_least;

  const PlacedSurface& surface_;
  const std::vector<double>& psi_;
  const std::vector<Vec3>& points_;
  std::size_t n_ = psi_.size();
  Gauge lipschitz_{"psi_lipschitz", "psi is 1/18-Lipschitz", "Lemma 5", at_most, 1.0 / 18, n_};
  Gauge lemma_6_{"lemma_6", "distance of kept points over psi >= 17/18", "Lemma 6", at_least, 17.0 / 18, n_};
  Gauge circumradius_{"circumradius_to_psi", "circumradius over psi <= 2.056", "Lemma 8", at_most, 2.056, n_};
  Gauge edge_to_psi_{"edge_to_psi", "edge length over psi <= 4.112", "Lemma 9", at_most, 4.112, n_};
  Gauge degree_{"degree", "degree <= 3925", "Lemma 12", at_most, 3925, n_};
  Gauge edge_ratio_{"edge_ratio", "edge ratio of a face <= 6", "Lemma 14", at_most, 6, n_};
  Gauge angle_{"smallest_angle", "smallest angle >= pi/20", "Lemma 15", at_least, std::numbers::pi / 20, n_};
};

}  // namespace

std::vector<Claim> claims_of(const PlacedSurface& surface, std::uint64_t seed) {
  PaperGauges gauges(surface);
  if (surface.mesh) gauges.add_surface();
  gauges.add_random_pairs(seed);
  gauges.add_records();
  return std::move(gauges).finish();
}

Claim claim_points_on_surface(const Input& input, const PlacedSurface& surface) {
  const std::vector<double>& psi = surface.sample->control.psi;
  Gauge gauge("off_surface", "distance of a point from the surface over psi <= 1", "practice", Claim::Sense::at_most, 1,
              psi.size());
  for_each_live_point(input, surface, [&](Index point, const Place& place) {
    gauge.add(point, distance(place.position, surface.mesh->position(place.at)) / psi[point]);
  });
  return std::move(gauge).finish("there is no surface");
}

}  // namespace geodrome
