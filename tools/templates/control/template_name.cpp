// A control function to start from: phi is 0.8 times the distance of a point's sixth neighbour, psi the Lipschitz
// envelope of phi, psi(s) = max over s' of phi(s') - 1.19/22 |ss'| (equation (1) of the paper). O(n^2): every point
// is compared with every other. Replace `phi_of` by your method.
#include <algorithm>
#include <cmath>
#include <geodrome/plugin.hpp>

using namespace geodrome;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double slope = 1.19 / 22;     // below the 1/18 that the contract allows
constexpr std::size_t neighbour = 6;    // its distance tells how densely the sample lies
constexpr double spacing_factor = 0.8;  // wide enough that no hole is seen between neighbours

/// The points that take part: those that no stage before has dropped.
std::vector<Vec3> live_points(const PointSample& sample, const Tangents& tangents) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < sample.size(); ++i)
    if (tangents.state[i] != PointState::dropped) points.push_back(sample.points[i]);
  return points;
}

double phi_of(const Vec3& point, const std::vector<Vec3>& points) {
  std::vector<double> distances;
  for (const Vec3& other : points) distances.push_back(squared_distance(point, other));
  const std::size_t rank = std::min(neighbour, points.size() - 1);  // the point itself has rank 0
  std::ranges::nth_element(distances, distances.begin() + static_cast<std::ptrdiff_t>(rank));
  return spacing_factor * std::sqrt(distances[rank]);
}

class TemplateName : public ControlFunction {
 public:
  Control evaluate(const PointSample& sample, const Tangents& tangents, RunContext& context) const override {
    const std::vector<Vec3> points = live_points(sample, tangents);
    if (points.size() == 1) throw SampleError("a single point has no neighbours");
    std::vector<double> phi;
    for (const Vec3& point : points) {
      context.throw_if_cancelled();
      phi.push_back(phi_of(point, points));
      context.progress(0.5 * static_cast<double>(phi.size()) / static_cast<double>(points.size()));
    }
    Control control{std::vector(sample.size(), nan), std::vector(sample.size(), nan), tangents.state};
    for (std::size_t i = 0, live = 0; i < sample.size(); ++i) {
      context.throw_if_cancelled();
      if (tangents.state[i] == PointState::dropped) continue;
      control.phi[i] = phi[live++];
      control.psi[i] = 0;
      for (std::size_t j = 0; j < points.size(); ++j)
        control.psi[i] = std::max(control.psi[i], phi[j] - slope * distance(sample.points[i], points[j]));
    }
    context.progress(1);
    return control;
  }
};

}  // namespace

GEODROME_PLUGIN(TemplateName, .name = "template_name",
                .summary = "the distance of the sixth neighbour and its Lipschitz envelope", .licence = "MIT")
