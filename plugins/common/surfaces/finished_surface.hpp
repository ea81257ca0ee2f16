// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "geodrome/settings.hpp"
#include "geodrome/surface_reconstructor.hpp"

namespace geodrome {

/// The rule for boundaries of a surface: automatic where the sample shows one, never, or as expected.
enum class BoundaryRule { automatic, closed, open };

/// The option `boundary` of a reconstructor, bound to a member; `help` says what "auto", "closed" and "open" mean
/// there.
template <class Settings>
consteval auto boundary_option(BoundaryRule Settings::*member, const char* help) {
  return option("boundary", member, "auto", "auto|closed|open",
                {BoundaryRule::automatic, BoundaryRule::closed, BoundaryRule::open}, help);
}

/// Returns a finding about sample points, with the first few of `places` as elements.
Finding finding(Finding::Severity severity, const char* code, std::string message, std::size_t count,
                std::vector<Index> places = {});

/// Returns "1 face", "2 faces".
std::string counted(std::size_t count, const char* one, const char* many);

/// The kept points as a reconstructor works on them, and which sample points they are.
struct KeptPoints {
  std::vector<Vec3> points, normals;
  std::vector<double> psi;
  std::vector<Index> sample;
};

/// Packs the points that were not dropped. Normals are those of the tangent planes. Throws SampleError for fewer than
/// three points.
KeptPoints kept_points(const PointSample& sample, const Tangents& tangents, const Control& control,
                       std::span<const Index> kept);

/// Makes `faces` (corners: kept points) the mesh of `result`: puts them in an order that depends on nothing else,
/// leaves out points without a face, adds what is to be said of these, of boundary and components, and the inserter.
///
/// Throws SampleError if there are no faces, they are no oriented 2-manifold, more than 5 % of the points have none, or
/// there is a boundary that the rule forbids; it carries the findings made so far.
void finish(Reconstruction& result, std::vector<Triangle> faces, const KeptPoints& kept, const PointSample& sample,
            BoundaryRule rule);

}  // namespace geodrome
