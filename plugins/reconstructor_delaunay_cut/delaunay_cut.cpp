// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/reconstructor_delaunay_cut/delaunay_cut.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <utility>

#include "geodrome/spatial_order.hpp"
#include "plugins/common/points/cell_radius.hpp"
#include "plugins/common/surfaces/face_deletion.hpp"
#include "plugins/common_gpl/planar_triangles.hpp"
#include "plugins/reconstructor_delaunay_cut/open_sheets.hpp"
#include "plugins/reconstructor_delaunay_cut/orient_normals.hpp"
#include "plugins/reconstructor_delaunay_cut/piece_surface.hpp"

namespace geodrome {
namespace {

/// Shares of inconsistent star triangles: smooth samples that came out right had up to 0.20, wrong surfaces 0.29 and
/// more.
constexpr double note_stars = 0.05, warn_stars = 0.10, refuse_stars = 0.20;
/// Repairs of more than this share of the points are guesses.
constexpr double most_repaired = 0.02;
/// A piece with fewer points bounds no volume.
constexpr std::size_t least_points = 4;

/// The points of one piece, along a curve that keeps neighbours together: the tetrahedra inherit the order.
OrientedPiece piece_of(const std::vector<Index>& members, const KeptPoints& kept, const std::vector<Vec3>& normals) {
  std::vector<Vec3> points;
  for (const Index k : members) points.push_back(kept.points[k]);
  OrientedPiece piece;
  for (const Index i : spatial_order(points)) {
    const Index k = members[i];
    piece.points.push_back(kept.points[k]);
    piece.normals.push_back(normals[k]);
    piece.psi.push_back(kept.psi[k]);
    piece.kept.push_back(k);
  }
  return piece;
}

/// What all pieces together gave; points are kept points.
struct Gathered {
  std::vector<Triangle> faces;
  std::vector<Index> repaired, unresolved, closed_gaps, bridges, holes;
  std::size_t flips = 0, lids = 0, gaps = 0, rounds = 0, bubble_faces = 0;
  double epsilon = 0;
};

std::vector<Index> translated(const std::vector<Index>& indices, const std::vector<Index>& to) {
  std::vector<Index> result;
  for (const Index i : indices) result.push_back(to[i]);
  std::sort(result.begin(), result.end());
  return result;
}

template <class Element>
void append(std::vector<Element>& all, const std::vector<Element>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void gather_faces(const std::vector<Triangle>& faces, const std::vector<Index>& kept, Gathered& all) {
  for (const auto& [a, b, c] : faces) all.faces.push_back({kept[a], kept[b], kept[c]});
}

/// Opens the gaps that the rule calls holes.
void gather(const PieceSurface& surface, const OrientedPiece& piece, BoundaryRule rule, const std::vector<double>& phi,
            Gathered& all) {
  std::vector<Index> lids;
  for (const Gap& gap : surface.gaps) {
    const bool opened = rule == BoundaryRule::open || (rule == BoundaryRule::automatic && gap.hole);
    if (opened) append(lids, gap.faces), ++all.lids;
    if (!opened && !gap.hole && !gap.disk) append(all.bridges, translated(gap.places, piece.kept));
    if (!opened && !gap.hole) append(all.closed_gaps, translated(gap.places, piece.kept)), ++all.gaps;
    if (gap.hole) append(all.holes, translated(gap.places, piece.kept));
  }
  std::sort(lids.begin(), lids.end());
  gather_faces(without_faces(surface.faces, lids, piece.points.size()), piece.kept, all);
  append(all.repaired, translated(surface.repaired, piece.kept));
  append(all.unresolved, translated(surface.unresolved, piece.kept));
  all.flips += surface.flips, all.bubble_faces += surface.bubble_faces;
  all.rounds = std::max(all.rounds, surface.rounds);
  for (std::size_t p = 0; p < surface.feature_size.size(); ++p)
    all.epsilon = std::max(all.epsilon, phi[piece.kept[p]] / surface.feature_size[p]);
}

class Reconstructing {
 public:
  Reconstructing(const PointSample& sample, const Tangents& tangents, const Control& control, BoundaryRule boundary,
                 bool allow_stars, std::span<const Index> kept, RunContext& context)
      : sample_(sample),
        tangents_(tangents),
        boundary_(boundary),
        allow_stars_(allow_stars),
        context_(context),
        kept_(kept_points(sample, tangents, control, kept)) {
    for (const Index i : kept) phi_.push_back(control.phi[i]);
    if (boundary != BoundaryRule::closed) sheets_.emplace(sample, control, kept_, context);
  }

  Reconstruction run() {
    const FaceRule rule{kept_.points, kept_.psi, true};
    const auto plane = common_plane(kept_.points);
    if (plane && !(sheets_ && sheets_->any())) {
      std::vector<Triangle> faces = planar_surface(*plane, rule, result_.findings);
      close_up(std::move(faces));
      return std::move(result_);
    }
    cut_pieces();
    judge_repairs();
    close_up(std::move(all_.faces));
    return std::move(result_);
  }

 private:
  void cut_pieces() {
    const Neighbours neighbours(kept_.points);
    const PlanarStars stars(neighbours, kept_.normals, sample_reach(kept_.points), context_, {0, 0.2});
    std::vector<double> farthest;
    for (const double psi : kept_.psi) farthest.push_back(FaceRule::radius_bound * psi);
    judge_stars(agreement(stars, kept_.points, farthest), stars);
    const OrientedSample oriented = orient(stars, kept_.points, kept_.normals, kept_.psi, FaceRule::edge_bound);
    context_.progress(0.3);
    std::size_t done = 0;
    for (const std::vector<Index>& members : oriented.pieces) {
      context_.throw_if_cancelled();
      cut_one(members, oriented.normals, stars);
      done += members.size();
      context_.progress(0.3 + 0.6 * static_cast<double>(done) / static_cast<double>(kept_.points.size()));
    }
    context_.measure("flips", static_cast<double>(all_.flips));
    context_.measure("lids", static_cast<double>(all_.lids));
    context_.measure("rounds", static_cast<double>(all_.rounds));
    if (all_.epsilon > 0) context_.measure("epsilon", all_.epsilon);
  }

  void cut_one(const std::vector<Index>& members, const std::vector<Vec3>& normals, const PlanarStars& stars) {
    if (members.size() < least_points || lay_sheet(members, stars)) return;
    const OrientedPiece piece = piece_of(members, kept_, normals);
    if (on_a_line(piece.points)) return;
    if (const auto plane = common_plane(piece.points)) {
      const FaceRule rule{piece.points, piece.psi, true};
      gather_faces(planar_surface(*plane, rule, result_.findings), piece.kept, all_);
      return;
    }
    const std::size_t before = all_.faces.size();
    gather(cut_piece(piece, stars, context_), piece, boundary_, phi_, all_);
    if (sheets_) tell_closed_rim(sheets_->closed_rim(members, std::span(all_.faces).subspan(before)));
  }

  void tell_closed_rim(const std::vector<Index>& rim) {
    if (rim.empty()) return;
    add(Finding::Severity::warning, "closed_rim",
        "at " + counted(rim.size(), "point", "points") +
            " the sample seems to show a boundary, which the surface closes: distances there may be too short.",
        rim);
  }

  /// Where the sample shows a boundary there need not be an inside: a sheet is laid then, if one comes out whole.
  bool lay_sheet(const std::vector<Index>& members, const PlanarStars& stars) {
    if (!sheets_ || !sheets_->shown_by(members)) return false;
    SheetSurface sheet = sheets_->make(stars, members, boundary_ == BoundaryRule::automatic);
    if (!is_whole(sheet, members.size())) return false;
    orient_sheet(sheet, kept_, result_);
    append(all_.faces, sheet.faces);
    append(all_.closed_gaps, sheet.thin);
    all_.gaps += sheet.thin_places;
    return true;
  }

  void judge_stars(const StarAgreement& stars, const PlanarStars& cells) {
    context_.measure("inconsistent_stars", stars.inconsistent);
    context_.measure("star_ties", stars.ties);
    inconsistent_ = stars.inconsistent;
    std::vector<Index> worst = stars.places;
    const auto relative = [&](Index p) { return cells.radius(p) / kept_.psi[p]; };
    std::stable_sort(worst.begin(), worst.end(), [&](Index a, Index b) { return relative(a) > relative(b); });
    char share_text[16];
    const std::string share(share_text, std::to_chars(share_text, share_text + sizeof share_text,
                                                      100 * stars.inconsistent, std::chars_format::fixed, 1)
                                            .ptr);
    if (stars.inconsistent > note_stars)
      add(stars.inconsistent > warn_stars ? Finding::Severity::warning : Finding::Severity::note, "inconsistent_stars",
          share +
              " % of the star triangles are not shared by the stars of all their corners: the sample is sparse for "
              "the shape there.",
          worst);
    if (stars.inconsistent > refuse_stars && !allow_stars_)
      refuse("the planar stars disagree on " + share + " % of their triangles (at most 20 %)");
  }

  void judge_repairs() {
    if (!all_.repaired.empty())
      add(Finding::Severity::note, "repaired",
          counted(all_.flips, "tetrahedron", "tetrahedra") + " changed sides to make the surface a 2-manifold.",
          all_.repaired);
    if (all_.bubble_faces > 0)
      result_.findings.push_back(
          finding(Finding::Severity::warning, "dropped_faces",
                  counted(all_.bubble_faces, "face", "faces") + " of pockets too small for a surface were left out.",
                  all_.bubble_faces));
    if (all_.gaps > 0)
      add(Finding::Severity::note, "closed_gaps",
          counted(all_.gaps, "place is", "places are") +
              " thinner sampled than psi explains and were closed: say boundary=open if they are holes.",
          all_.closed_gaps);
    if (!all_.unresolved.empty()) {
      add(Finding::Severity::refusal, "not_a_manifold", "no labelling makes the surface a 2-manifold there.",
          all_.unresolved);
      refuse("the surface is no 2-manifold at " + counted(all_.unresolved.size(), "point", "points"));
    }
    if (!all_.bridges.empty()) {
      add(Finding::Severity::refusal, "bridge",
          "faces that psi does not explain join parts of the surface there: a handle or a tunnel that the sample does "
          "not show.",
          all_.bridges);
      refuse("the surface has a handle or a tunnel that the sample does not show, at point " +
             std::to_string(kept_.sample[all_.bridges.front()]));
    }
    if (static_cast<double>(all_.repaired.size()) > most_repaired * static_cast<double>(kept_.points.size()))
      refuse("the surface had to be repaired at " + std::to_string(all_.repaired.size()) + " of " +
             std::to_string(kept_.points.size()) + " points (at most 2 %)");
    if (boundary_ == BoundaryRule::closed && !all_.holes.empty()) {
      add(Finding::Severity::refusal, "boundary", "the sample shows a hole there.", all_.holes);
      throw SampleError("the sample shows a hole, at point " + std::to_string(kept_.sample[all_.holes.front()]),
                        "sample it, or allow a boundary with boundary=auto", std::move(result_.findings));
    }
  }

  void add(Finding::Severity severity, const char* code, std::string message, const std::vector<Index>& places) {
    result_.findings.push_back(finding(severity, code, std::move(message), places.size(), translated_in_order(places)));
  }
  std::vector<Index> translated_in_order(const std::vector<Index>& places) const {
    std::vector<Index> sample;
    for (const Index p : places) sample.push_back(kept_.sample[p]);
    return sample;
  }

  /// Sheets nearer to each other than the sample is dense look like noise as well.
  [[noreturn]] void refuse(const std::string& what) {
    const double psi = *std::max_element(kept_.psi.begin(), kept_.psi.end());
    if (tangents_.sigma > 0 && 5 * tangents_.sigma >= psi)
      throw SampleError("the sample is too noisy, or too sparse for sheets that lie near each other: " + what +
                            ", with noise of " + std::to_string(tangents_.sigma),
                        "measure more precisely, smooth the points, or sample more densely",
                        std::move(result_.findings));
    throw SampleError("the sample is too sparse for its shape: " + what, what_would_do(), std::move(result_.findings));
  }

  /// Disagreement falls as 1 / n, which tells the density that would do; where stars agree, nothing does.
  std::string what_would_do() const {
    std::string advice = "sample more densely at the places named";
    if (inconsistent_ > note_stars) {
      const double more = std::max(2.0, inconsistent_ / warn_stars);
      const auto wanted = static_cast<std::size_t>(std::ceil(more * static_cast<double>(sample_.size()) / 1000) * 1000);
      advice = "about " + std::to_string(wanted) + " points as evenly spread would do (now " +
               std::to_string(sample_.size()) + "), most of them at the places named";
    }
    const bool thinned = kept_.points.size() < sample_.size();
    return thinned ? advice + "; or keep all points (decimator none)" : advice;
  }

  void close_up(std::vector<Triangle> faces) { finish(result_, std::move(faces), kept_, sample_, boundary_); }

  const PointSample& sample_;
  const Tangents& tangents_;
  const BoundaryRule boundary_;
  const bool allow_stars_;
  RunContext& context_;
  const KeptPoints kept_;
  std::vector<double> phi_;
  std::optional<OpenSheets> sheets_;
  double inconsistent_ = 0;
  Gathered all_;
  Reconstruction result_;
};

}  // namespace

Reconstruction DelaunayCut::reconstruct(const PointSample& sample, const Tangents& tangents, const Control& control,
                                        std::span<const Index> kept, RunContext& context) const {
  context.throw_if_cancelled();
  return Reconstructing(sample, tangents, control, settings_.boundary, settings_.allow_stars, kept, context).run();
}

}  // namespace geodrome
