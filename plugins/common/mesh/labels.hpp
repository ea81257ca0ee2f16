// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

#include "geodrome/geometry.hpp"
#include "plugins/common/mesh/for_listed_or_all.hpp"

namespace geodrome {

/// An angle as a unit vector, so that turning costs no trigonometry.
struct Angle {
  double cosine = 1, sine = 0;

  friend Angle operator+(const Angle& a, const Angle& b) {
    return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
  }
  friend Angle operator-(const Angle& a, const Angle& b) {
    return {a.cosine * b.cosine + a.sine * b.sine, a.sine * b.cosine - a.cosine * b.sine};
  }
};

/// Returns the angle of the direction (x, y), from the x axis; if there is no direction, the angle 0.
inline Angle angle_of(double x, double y) {
  const double size = std::sqrt(x * x + y * y);
  return size > 0 ? Angle{x / size, y / size} : Angle{};
}

inline constexpr Angle no_angle{0, 0};

/// The label of a vertex: the shortest path to it that was found so far.
struct Label {
  double distance = infinity;
  /// The side from which the path comes: this angle counterclockwise from half-edge `corner`, which starts at the
  /// vertex. The side is known at saddles only. The vertex is a source if there is no corner.
  Angle side;
  Index corner = no_index;
  Index source = no_index;  ///< of the request

  /// Tells whether the path comes from so near that the vertex emits to all sides; written as an angle that is none.
  bool all_sides() const { return side.cosine == 0 && side.sine == 0; }
};

/// The labels of all vertices, and their steps if paths are wanted: a solver's own `Step`, default constructible, says
/// how a path goes on from a vertex. Forgetting a run costs what it touched.
template <class Step>
class Labels {
 public:
  explicit Labels(std::size_t vertex_count) : labels_(vertex_count) {}

  const Label& operator[](Index vertex) const { return labels_[vertex]; }
  double distance(Index vertex) const { return labels_[vertex].distance; }
  const Step& step(Index vertex) const { return steps_[vertex]; }
  const std::vector<Index>& touched() const { return touched_; }

  void reset(bool with_steps) {
    for_listed_or_all(touched_, labels_.size(), [this](Index v) { labels_[v] = {}; });
    touched_.clear();
    if (with_steps && steps_.empty()) steps_.resize(labels_.size());
    with_steps_ = with_steps;
  }

  /// Replaces the label of a vertex and, if steps are kept, its step. A vertex that emits to all sides still does if
  /// the new distance is lower by next to nothing; otherwise the side of `label` counts. Precondition: label.distance
  /// is lower than the present one.
  void set(Index vertex, const Label& label, const Step& step) {
    constexpr double next_to_nothing = 1e-9;
    const Label present = labels_[vertex];
    if (present.source == no_index) touched_.push_back(vertex);
    labels_[vertex] = label;
    if (present.all_sides() && label.distance >= present.distance * (1 - next_to_nothing)) widen(vertex);
    if (with_steps_) steps_[vertex] = step;
  }

  /// Lets a vertex emit to all sides. Precondition: the vertex has a label.
  void widen(Index vertex) { labels_[vertex].side = no_angle; }

  std::size_t bytes() const {
    return labels_.size() * sizeof(Label) + steps_.size() * sizeof(Step) + touched_.capacity() * sizeof(Index);
  }

 private:
  std::vector<Label> labels_;
  std::vector<Step> steps_;
  std::vector<Index> touched_;
  bool with_steps_ = false;
};

}  // namespace geodrome
