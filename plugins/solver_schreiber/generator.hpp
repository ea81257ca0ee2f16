// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "geodrome/geometry.hpp"
#include "plugins/common/exact/bisector.hpp"
#include "plugins/solver_schreiber/motion.hpp"

namespace geodrome::schreiber {

/// A source image of a wavefront: a pseudo-source unfolded into the plane of a face, with the wedge between two rays
/// that contains its straight paths. The nearer generator counts where wedges overlap. The outer ray of the first and
/// of the last generator of a front is a real path. Wedges inside a front are wider than their real paths; the
/// neighbours keep them in check (`right_has`). Images are at y <= 0 in the frame of a half-edge, and wedges open
/// upwards; `low` is the ray on the side of the half-edge's start.
struct Generator {
  double x, y, sigma;     ///< the image; the distance travelled before it
  double low_x, low_y;    ///< unit direction
  double high_x, high_y;  ///< unit direction
  double key;             ///< a lower bound of the distance at which it dies between its neighbours (lifetime.hpp)
  Index origin;           ///< the pseudo-source: a vertex, or `vertex count + i` for source i of the request

  Generator moved(const Motion& motion) const {
    Generator g = *this;
    std::tie(g.x, g.y) = motion(x, y);
    std::tie(g.low_x, g.low_y) = motion.turn(low_x, low_y);
    std::tie(g.high_x, g.high_y) = motion.turn(high_x, high_y);
    return g;
  }
  /// Returns the generator as seen from a half-edge of `length` that runs the other way, with the face on the same
  /// side.
  Generator mirrored(double length) const {
    return {length - x, y, sigma, -high_x, high_y, -low_x, low_y, key, origin};
  }

  double away(double px, double py) const { return std::sqrt((px - x) * (px - x) + (py - y) * (py - y)); }
  double to(double px, double py) const { return sigma + away(px, py); }
  double at(double px) const { return to(px, 0); }

  /// Tell whether a point is on the inner side of a ray, or on it.
  bool inside_low(double px, double py) const { return low_x * (py - y) - low_y * (px - x) <= 0; }
  bool inside_high(double px, double py) const { return high_x * (py - y) - high_y * (px - x) >= 0; }
  bool covers(double px, double py) const { return inside_low(px, py) && inside_high(px, py) && is_ahead(px, py); }
  /// Tell whether a point is inside a ray up to rounding: the path to a point beyond the ray, bent where the ray meets
  /// the half-edge, is no longer than the straight one.
  bool reaches_low(double px, double py) const {
    return is_reached(low_x * (py - y) - low_y * (px - x), low_x, low_y, px, py);
  }
  bool reaches_high(double px, double py) const {
    return is_reached(high_y * (px - x) - high_x * (py - y), high_x, high_y, px, py);
  }
  bool reaches(double px, double py) const { return reaches_low(px, py) && reaches_high(px, py) && is_ahead(px, py); }
  /// Tell whether the wedge has rays to the left or right of a point.
  bool has_left(double px, double py) const { return low_x * (py - y) - low_y * (px - x) < 0; }
  bool has_right(double px, double py) const { return high_x * (py - y) - high_y * (px - x) > 0; }

  /// Tell whether a ray meets the half-edge beyond a place, by more than rounding of places. A ray that climbs little
  /// is near a place far beyond which it meets the half-edge: if the end of that is on the next edge too, as in a face
  /// without area, only the place tells that the ray passes it.
  bool passes_low(double place) const { return low_y * (place - x) + low_x * y > rounding(place, low_y); }
  bool passes_high(double place) const { return high_y * (x - place) - high_x * y > rounding(place, high_y); }

  /// Tells whether the image lies on the line of a half-edge of `length`, beyond an end of it, up to rounding: its rays
  /// cross the half-edge at no place, however wide the wedge.
  bool is_on_line_beside(double length) const {
    return -y <= rounding(length) && (x < -rounding(length) || x > length + rounding(length));
  }

  /// Tells whether the two rays are one, up to rounding.
  bool is_sliver() const {
    return high_x * low_x + high_y * low_y > 0 &&
           high_x * low_y - high_y * low_x <= 4 * std::numeric_limits<double>::epsilon();
  }

  /// Return where the rays meet a half-edge of `length`, or its nearer end. The other ray is beyond the end on its side
  /// if only one climbs; both are beyond one end if neither does.
  double low(double length) const {
    if (climbs(low_y)) return place(low_x, low_y, length);
    return climbs(high_y) || low_x < 0 ? 0 : low_x > 0 ? length : std::clamp(x, 0.0, length);
  }
  double high(double length) const {
    if (climbs(high_y)) return place(high_x, high_y, length);
    return climbs(low_y) || high_x > 0 ? length : high_x < 0 ? 0 : std::clamp(x, 0.0, length);
  }

  void set_low(double px, double py) { aim(low_x, low_y, px, py); }
  void set_high(double px, double py) { aim(high_x, high_y, px, py); }

 private:
  /// Tells whether a point is ahead of the image. A wedge without a width has both sides of its line inside.
  bool is_ahead(double px, double py) const {
    return low_x * (px - x) + low_y * (py - y) > 0 || high_x * (px - x) + high_y * (py - y) > 0 || !is_sliver();
  }
  double rounding(double place) const {
    return 2 * std::numeric_limits<double>::epsilon() * (std::abs(place) + std::abs(x) + std::abs(y));
  }
  /// Returns the rounding of a place as the distance from a ray with this climb that meets the half-edge there.
  double rounding(double place, double dy) const { return climbs(dy) ? dy * rounding(place) : rounding(place); }
  /// Tells whether a point is reached that is at distance `beyond` from a ray, on its outer side if positive.
  bool is_reached(double beyond, double dx, double dy, double px, double py) const {
    constexpr double too_far = 1e-7;  // for its square, at least by which the bent way is longer, to be rounding
    if (beyond <= 0) return true;
    if (beyond > too_far * (std::abs(px - x) + std::abs(py - y)) || !(dy > 0)) return false;
    const double along = -y / dy, off = px - (x + along * dx);
    return along + std::sqrt(off * off + py * py) <= (1 + equal_share) * away(px, py);
  }
  /// Tells whether a ray crosses the line of the half-edge. One that climbs less than the rounding of some motions runs
  /// along the half-edge and crosses it at no place.
  static bool climbs(double dy) { return dy > std::numeric_limits<double>::epsilon(); }
  double place(double dx, double dy, double length) const {
    return std::clamp(x + dx * (std::max(0.0, -y) / dy), 0.0, length);
  }
  /// Turns a ray to a point. A point at the image itself, up to rounding, leaves the ray as it is.
  void aim(double& dx, double& dy, double px, double py) const {
    constexpr double same_place = 3e-11;
    const double size = away(px, py);
    if (size > same_place * (std::abs(px) + std::abs(x) + std::abs(y))) dx = (px - x) / size, dy = (py - y) / size;
  }
};

}  // namespace geodrome::schreiber
