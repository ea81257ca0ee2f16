// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "engine/smooth/charts.hpp"
#include "engine/smooth/error_estimate.hpp"
#include "engine/smooth/newton_step.hpp"
#include "engine/smooth/node_placing.hpp"
#include "geodrome/engine/distances.hpp"

namespace geodrome {

/// What became of a flat path.
struct SmoothLength {
  double length = 0;  ///< on the smooth surface where that is trusted, else of the flat path; >= the straight line
  double flat = 0;    ///< of the flat path
  double smooth = 0;  ///< of the flat path, on trusted faces
  LengthError error;  ///< estimate
  bool moved = true;  ///< false if a part of the curve stayed above the flat path, because a step made it no shorter
};

/// Turns flat paths into geodesics on a smooth surface, many at a time. The runs of a path on trusted faces get nodes,
/// their ends stay, steps of Newton's method move the others across the run; between the runs the path stays flat.
/// The lengths are of fourth order in the spacing of the nodes, and no upper bounds. Where smooth and flat faces meet
/// the curve leaps from one surface to the other, and the leap does not count: the flat faces are what is too low.
/// Owns its buffers: one per thread. `charts` must outlive it.
class Shortening {
 public:
  explicit Shortening(const SmoothCharts& charts) : charts_(charts) {}

  /// Adds a path, from its source or to it: surface points whose consecutive pairs lie in a common face. Throws
  /// NumericalError for others.
  void add(std::span<const SurfacePoint> path);

  /// The number of nodes that wait: what `run` is to work on is best kept to a few thousand.
  std::size_t nodes() const { return nodes_.size(); }

  /// Shortens what was added since the last run, and returns what became of it, path by path; valid until the next
  /// `add`.
  std::span<const SmoothLength> run();

  std::span<const SmoothLength> lengths() const { return lengths_; }

  struct SmoothCurve {
    std::span<const CurveNode> nodes;
    std::span<const SmoothPoint> points;
  };
  /// The nodes of a path of the last run, if all of it is smooth and as short as steps make it; valid as `run`'s
  /// result.
  std::optional<SmoothCurve> smooth_curve(std::size_t path);

  /// Appends the curve of a path of the last run: its nodes, above `points` at `positions`.
  void curve(std::size_t path, std::vector<SurfacePoint>& points, std::vector<Vec3>& positions);

 private:
  struct Section {
    std::size_t path;
    bool smooth;
    std::size_t first, end;  // in nodes_, or in flat_
    double length = 0;       // smooth: of the curve so far
    double farthest = 0;     // smooth: that a node moved in the last step, in spacings
  };

  void start_batch();
  void ask(std::span<Section* const> sections, std::vector<SmoothPoint>& answers);
  void find_next();
  void shift(const Section& section, double times);
  bool step(Section& section);
  bool accept(Section& section);
  void measure(const Section& section);
  void estimate_flat(LengthError& error) const;
  void bound_from_below();
  Vec3 position(const Section& section, std::size_t i) const;
  template <class Value>
  static std::span<Value> part(std::vector<Value>& all, const Section& section);

  const SmoothCharts& charts_;
  NewtonStep newton_;
  std::vector<FlatPiece> pieces_;
  std::vector<Section> sections_;
  std::vector<Section*> moving_;  // those that a step may still make shorter
  std::vector<SmoothLength> lengths_;
  std::vector<CurveNode> nodes_;
  std::vector<SurfacePoint> flat_;
  std::vector<SmoothPlace> places_;
  std::vector<SmoothPoint> answers_, at_, next_;  // at_: the curves so far, node by node
  std::vector<double> moves_;
  bool done_ = false;
};

}  // namespace geodrome
