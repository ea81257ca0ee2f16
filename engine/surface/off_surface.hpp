// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/surface/selection.hpp"

/// Points that users name by their coordinates and that lie off the surface: the closest surface points stand for them,
/// which nobody may learn from a distance alone.
namespace geodrome {

/// The length of the diagonal of the box around the faces; 0 if there are none. O(F).
double surface_diagonal(const SurfaceMesh& mesh);

/// Beside the surface by no more than this share of its diagonal is on it: so much do six printed digits leave.
constexpr double share_of_rounding = 1e-6;

/// Beside the surface by more than this share of its diagonal is told as a warning.
constexpr double share_of_warning = 1e-2;

/// A point that lies off the surface.
struct OffPlace {
  std::string entry;  ///< "far.txt: line 1", or the entry itself where the list is no file
  Vec3 named;
  double distance = 0;         ///< from the surface, in units of the input
  bool could_be_rows = false;  ///< three whole numbers, each a row of the input
};

/// What a job's lists name by coordinates, and how far off the surface it lies.
struct OffSurface {
  double diagonal = 0;             ///< of the surface
  double tolerated = 0;            ///< the distance above which a place is told as a warning
  std::size_t named = 0;           ///< how many points were named by coordinates
  std::size_t off = 0;             ///< of these: not on the surface
  std::size_t warned = 0;          ///< of these: farther than `tolerated`
  std::size_t warned_as_rows = 0;  ///< of these: could be rows
  std::vector<OffPlace> farthest;  ///< up to ten that are off, farthest first
};

/// Collects them from the lists of a job. A row of a cloud never counts, though decimation may have left it beside the
/// surface: the sample report has its distance. For the same reason a point beside the surface of a cloud is warned of
/// only if it also lies farther from it than every point of the sample does.
class OffSurfaceFinder {
 public:
  /// Both must outlive it.
  OffSurfaceFinder(const Input& input, const PlacedSurface& surface) : input_(input), surface_(surface) {}

  /// `points`: those that `selection` names, or `pairs`, as `resolve` gives them. O(entries), and once O(F).
  void add(const Selection& selection, const std::vector<NamedPoint>& points);
  void add(const PairSelection& selection, const PairList& pairs);

  const OffSurface& found() const { return found_; }

 private:
  void add(const PointEntry& entry, const NamedPoint& point, const std::string& file);

  const Input& input_;
  const PlacedSurface& surface_;
  OffSurface found_;
};

}  // namespace geodrome
