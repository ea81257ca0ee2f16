// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "plugins/reconstructor_delaunay_cut/delaunay_cut.hpp"
#include "plugins/tangent_jet/smooth/smooth_fit.hpp"
#include "tests/support/sample_stages.hpp"
#include "tests/support/shape_equations.hpp"
#include "tests/support/threads_context.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::test {

/// A sample, the surface that stages 1 to 4 make of it, and the smooth one over it.
struct FittedSurface {
  PointSample sample;
  Tangents tangents;
  MeshPtr mesh;
  std::unique_ptr<SmoothSurface> smooth;

  SmoothPoint at(const SmoothPlace& place) const {
    SmoothPoint point;
    smooth->evaluate({&place, 1}, {&point, 1});
    return point;
  }
  bool trusted(Index face) const { return smooth->deviation(face) < infinity; }
};

inline std::unique_ptr<SmoothSurface> fitted_to(const MeshPtr& mesh, const PointSample& sample,
                                                const Tangents& tangents, unsigned threads = 2) {
  ThreadsContext context(threads);
  return fit_smooth_surface(JetTangents(OptionValues(jet_options, "")), {mesh, sample, tangents}, context);
}

inline FittedSurface fitted(const PointSample& sample, bool decimate = true) {
  ThreadsContext context(2);
  Staged made = staged(sample, decimate);
  FittedSurface result{sample, made.tangents, {}, {}};
  result.mesh = DelaunayCut(OptionValues(DelaunayCut::options, ""))
                    .reconstruct(made.sample, made.tangents, made.control, made.kept, context)
                    .mesh;
  result.smooth = fitted_to(result.mesh, sample, result.tangents);
  return result;
}

inline FittedSurface fitted(const std::string& shape, const shapes::SampleSpec& spec) {
  return fitted(shapes::sample(shape, spec));
}

/// A place with the direction of the face's first edge.
inline SmoothPlace place_on(const SurfaceMesh& mesh, Index face, const std::array<double, 3>& b) {
  const auto [p, q, r] = mesh.corners(face);
  return {{face, b}, (q - p) / norm(q - p)};
}

/// The middle of a face and those of its edges.
inline constexpr std::array<std::array<double, 3>, 4> middles{
    {{1.0 / 3, 1.0 / 3, 1.0 / 3}, {0.5, 0.5, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}}};

inline double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// Largest errors over the middles of a thousand trusted faces, or more, against the equation of the shape.
struct ShapeErrors {
  std::vector<double> position, normal, flat, deviation;
};

inline ShapeErrors errors_of(const FittedSurface& surface, const std::string& shape) {
  ShapeErrors errors;
  const auto stride = static_cast<Index>(surface.mesh->face_count() / 1000);  // the equations are slow
  for (Index f = 0; f < surface.mesh->face_count(); f += std::max(stride, Index{1})) {
    if (!surface.trusted(f)) continue;
    double position = 0, normal = 0, flat = 0;
    for (const auto& b : middles) {
      const SmoothPlace place = place_on(*surface.mesh, f, b);
      const SmoothPoint point = surface.at(place);
      const Vec3 gradient = shape_gradient(shape, point.position);
      position = std::max(position, distance_off_shape(shape, point.position));
      normal = std::max(normal, norm(cross(gradient, point.normal)) / norm(gradient));
      flat = std::max(flat, distance_off_shape(shape, surface.mesh->position(place.at)));
    }
    errors.position.push_back(position), errors.normal.push_back(normal), errors.flat.push_back(flat);
    errors.deviation.push_back(surface.smooth->deviation(f));
  }
  return errors;
}

}  // namespace geodrome::test
