// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "geodrome/smooth_surface.hpp"
#include "tests/support/series.hpp"

/// Smooth surfaces that are known by formulas: a point of space is put onto them (along a ray from the centre, from the
/// ring of the torus), and each has an outward gradient there. Both are templates of the number type.
namespace geodrome::test {

/// x^2 + (y / b)^2 + (z / c)^2 = 1.
struct Ellipsoid {
  double b = 1, c = 1;

  template <class T>
  Vector<T> onto(const Vector<T>& p) const {
    using std::sqrt;
    return T(1) / sqrt(dot(p, gradient(p))) * p;
  }
  template <class T>
  Vector<T> gradient(const Vector<T>& p) const {
    return {p.x, T(1 / (b * b)) * p.y, T(1 / (c * c)) * p.z};
  }
};

/// Around the z axis, R = 1.
struct Torus {
  double tube = 0.4;

  template <class T>
  Vector<T> onto(const Vector<T>& p) const {
    const Vector<T> ring = unit(Vector<T>{p.x, p.y, T(0)});
    return ring + T(tube) * unit(p - ring);
  }
  template <class T>
  Vector<T> gradient(const Vector<T>& p) const {
    return p - unit(Vector<T>{p.x, p.y, T(0)});
  }
};

/// Radius 1 + 0.12 sin(3 x + 1) cos(2 y) + 0.08 sin(4 x z + 0.5) over the point (x, y, z) of the unit sphere.
struct Star {
  template <class T>
  Vector<T> onto(const Vector<T>& p) const {
    const Vector<T> u = unit(p);
    return radius(u) * u;
  }
  template <class T>
  Vector<T> gradient(const Vector<T>& p) const {  // of |p| - radius(p / |p|)
    using std::cos, std::sin, std::sqrt;
    const Vector<T> u = unit(p);
    const T a = T(3) * u.x + T(1), b = T(4) * u.x * u.z + T(0.5);
    const Vector<T> slope{T(0.36) * cos(a) * cos(T(2) * u.y) + T(0.32) * u.z * cos(b),
                          T(-0.24) * sin(a) * sin(T(2) * u.y), T(0.32) * u.x * cos(b)};
    return u - T(1) / sqrt(dot(p, p)) * (slope - dot(slope, u) * u);
  }

 private:
  template <class T>
  static T radius(const Vector<T>& u) {
    using std::cos, std::sin;
    return T(1) + T(0.12) * sin(T(3) * u.x + T(1)) * cos(T(2) * u.y) + T(0.08) * sin(T(4) * u.x * u.z + T(0.5));
  }
};

/// The plane z = 0.
struct Plane {
  template <class T>
  Vector<T> onto(const Vector<T>& p) const {
    return {p.x, p.y, T(0)};
  }
  template <class T>
  Vector<T> gradient(const Vector<T>&) const {
    return {T(0), T(0), T(1)};
  }
};

/// The point of a shape that belongs to a point of space.
template <class Shape>
Vec3 onto(const Shape& shape, const Vec3& p) {
  const Vector<double> q = shape.onto(Vector<double>{p.x, p.y, p.z});
  return {q.x, q.y, q.z};
}

/// Where a shape stands: turned (about an axis that is none of the coordinates), scaled, shifted.
struct Pose {
  bool turned = false;
  double scale = 1;
  Vec3 shift{};

  Vec3 direction(const Vec3& p) const { return turned ? Vec3{dot(rows[0], p), dot(rows[1], p), dot(rows[2], p)} : p; }
  Vec3 back(const Vec3& p) const { return turned ? p.x * rows[0] + p.y * rows[1] + p.z * rows[2] : p; }
  Vec3 point(const Vec3& p) const { return scale * direction(p) + shift; }
  Vec3 point_back(const Vec3& p) const { return back(p - shift) / scale; }

 private:
  static constexpr Vec3 rows[] = {{2 / 7., 3 / 7., 6 / 7.}, {3 / 7., -6 / 7., 2 / 7.}, {6 / 7., 2 / 7., -3 / 7.}};
};

/// A shape in a pose, over a mesh whose vertices lie on it. Without `deviation` all faces are trusted.
template <class Shape>
class AnalyticSurface final : public SmoothSurface {
 public:
  using Deviation = std::function<double(Index face)>;

  explicit AnalyticSurface(MeshPtr mesh, Shape shape = {}, Deviation deviation = {}, Pose pose = {})
      : mesh_(std::move(mesh)), shape_(shape), deviation_(std::move(deviation)), pose_(pose) {}

  double deviation(Index face) const override { return deviation_ ? deviation_(face) : 0; }

  void evaluate(std::span<const SmoothPlace> places, std::span<SmoothPoint> points) const override {
    for (std::size_t i = 0; i < places.size(); ++i) points[i] = answer(places[i]);
  }

  std::size_t bytes() const override { return sizeof *this; }

 private:
  SmoothPoint answer(const SmoothPlace& place) const {
    const Vec3 at = pose_.point_back(mesh_->position(place.at));
    const Vector<Series> point = shape_.onto(moving(at, pose_.back(place.direction) / pose_.scale));
    Vector<Series> normal = unit(shape_.gradient(point));
    const auto [p, q, r] = mesh_->corners(place.at.face);
    if (dot(cross(q - p, r - p), pose_.direction(value(normal))) < 0) normal = Series(-1) * normal;
    return {pose_.point(value(point)), pose_.direction(value(normal)), pose_.scale * pose_.direction(first(point)),
            pose_.scale * pose_.direction(second(point)), pose_.direction(first(normal))};
  }

  MeshPtr mesh_;
  Shape shape_;
  Deviation deviation_;
  Pose pose_;
};

}  // namespace geodrome::test
