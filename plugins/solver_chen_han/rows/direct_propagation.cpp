// SPDX-License-Identifier: MIT
// What a propagation does in a direct run alone.
#include <cmath>

#include "plugins/solver_chen_han/propagation.hpp"

namespace geodrome::chen_han {

void Propagation::begin_direct(DirectRun& direct, Index source, double limit) {
  begin(false, limit);
  direct.reset(source);
  direct_ = &direct;
  wavefront_.mark_mirrored(static_cast<Index>(unknown_bearing));
  seed({surface_.mesh().at_vertex(surface_.original_vertex(source))}, 0);
}

/// In a direct run only the source sends windows; what other vertices do to bounds stands in for theirs.
void Propagation::go_on_from(Index vertex) {
  if (vertex == direct_->source()) emit(vertex);
  direct_->lower_near(vertex, [this](Index near, double bound) { wavefront_.push_vertex(near, bound); });
}

/// Notes in which direction the path by window i to the apex leaves the source; it comes from the image of the source
/// straight, or over (x, 0) if that is not below it.
void Propagation::note_exit(const Apex& apex, const WindowArrays& w, std::size_t i, double x) {
  const bool straight = x == w.x()[i];
  const double dx = (straight ? apex.x : x) - w.x()[i], dy = (straight ? apex.y : 0) - w.y()[i];
  direct_->set_exit(apex.vertex(), DirectRun::direction(DirectRun::bearing(w.names()[i]), dx, dy));
}

/// Returns where a path by window i bends in a direct run: beside (x, 0) if the image is there, for the x of the image
/// itself stands for a path that is straight.
double Propagation::bend_at(const WindowArrays& w, std::size_t i, double x) const {
  return direct_ && x == w.x()[i] ? std::nextafter(x, infinity) : x;
}

/// Lets paths go on to all sides from an apex whose path bends at (x, 0) in nearly the same place: from where it comes
/// depends on rounding. An emission sends windows into whole faces, which hides that; lists go by the direction alone.
void Propagation::widen_if_bent_near(const Apex& apex, bool bent, double x, double distance) {
  const bool near = std::hypot(x - apex.x, apex.y) <= close_share * apex.length;
  if (bent && near && labels_.distance(apex.vertex()) == distance) labels_.widen(apex.vertex());
}

void Propagation::note_exit_along_edge(Index vertex, Index from) {
  direct_->set_exit(vertex, from == direct_->source() ? direct_->exit_along_edge(vertex) : direct_->exit(from));
}

}  // namespace geodrome::chen_han
