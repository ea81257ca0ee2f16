// A tangent estimator to start from: the plane that fits a point and its k nearest neighbours best (principal
// components, Pearson 1901), through the point itself. Where these lie on a line, twice as many are taken. O(n^2):
// every point is compared with every other. Replace what is in `estimate` by your method.
#include <algorithm>
#include <cmath>
#include <geodrome/plugin.hpp>
#include <optional>

using namespace geodrome;

namespace {

struct TemplateNameSettings {
  std::size_t k;
};

constexpr auto options = settings_table(
    option("k", &TemplateNameSettings::k, "20", 3, 400, "points", "neighbours that the plane is fitted to"));

/// A symmetric matrix by its rows.
using Matrix = std::array<Vec3, 3>;

Matrix product(const Matrix& a, const Matrix& b) {  // of two that commute
  Matrix c;
  for (int i = 0; i < 3; ++i) c[i] = {dot(a[i], b[0]), dot(a[i], b[1]), dot(a[i], b[2])};
  return c;
}

Matrix scaled(const Matrix& a, double factor) { return {a[0] * factor, a[1] * factor, a[2] * factor}; }

double trace(const Matrix& a) { return a[0].x + a[1].y + a[2].z; }

/// The unit normal of the plane that fits `points` best, seen from their centre; nothing if they lie on a line.
///
/// It is the eigenvector of the covariance's smallest eigenvalue, and so that of the largest one of its adjugate, which
/// repeated squaring leaves alone. On a line the adjugate vanishes.
std::optional<Vec3> normal_of(std::span<const Vec3> points, const Vec3& centre) {
  Matrix covariance{};
  for (const Vec3& p : points) {
    const Vec3 d = p - centre;
    covariance[0] = covariance[0] + d.x * d, covariance[1] = covariance[1] + d.y * d;
    covariance[2] = covariance[2] + d.z * d;
  }
  covariance = scaled(covariance, 1 / trace(covariance));
  const auto& [x, y, z] = covariance;
  Matrix adjugate{cross(y, z), cross(z, x), cross(x, y)};
  constexpr double vanishes = 1e-12;
  if (!(trace(adjugate) > vanishes)) return std::nullopt;
  for (int i = 0; i < 12; ++i) {
    adjugate = scaled(adjugate, 1 / trace(adjugate));
    adjugate = product(adjugate, adjugate);
  }
  const Vec3 longest = *std::ranges::max_element(adjugate, {}, squared_norm);
  return longest / norm(longest);
}

/// Root mean square distance from the plane through `centre`.
double residual_of(std::span<const Vec3> points, const Vec3& centre, const Vec3& normal) {
  double sum = 0;
  for (const Vec3& p : points) sum += dot(p - centre, normal) * dot(p - centre, normal);
  return std::sqrt(sum / static_cast<double>(points.size()));
}

class TemplateName : public TangentEstimator {
 public:
  explicit TemplateName(const OptionValues& values) : settings_(options.parsed(values)) {}

  Tangents estimate(const PointSample& sample, RunContext& context) const override {
    if (sample.size() < 3) throw SampleError("fewer than three points span no plane");
    Tangents tangents;
    for (std::size_t i = 0; i < sample.size(); ++i) {
      context.throw_if_cancelled();
      tangents.plane.push_back(plane_at(sample, i));
      context.progress(static_cast<double>(i + 1) / static_cast<double>(sample.size()));
    }
    tangents.state.assign(sample.size(), PointState::ok);
    return tangents;
  }

 private:
  TangentPlane plane_at(const PointSample& sample, std::size_t i) const {
    std::vector<Vec3> around = sample.points;
    const auto distance_to_i = [&](const Vec3& p) { return squared_distance(p, sample.points[i]); };
    for (std::size_t k = settings_.k;; k *= 2) {
      const std::size_t count = std::min(k + 1, around.size());  // with the point itself
      std::ranges::nth_element(around, around.begin() + static_cast<std::ptrdiff_t>(count - 1), {}, distance_to_i);
      const std::span<const Vec3> nearest(around.data(), count);
      Vec3 centre;
      for (const Vec3& p : nearest) centre = centre + (p - sample.points[i]) / static_cast<double>(count);
      centre = centre + sample.points[i];
      if (const auto normal = normal_of(nearest, centre))
        return {sample.points[i], *normal, residual_of(nearest, centre, *normal)};
      if (count == around.size())
        throw SampleError("the points lie on a line, as seen from point " + std::to_string(i));
    }
  }

  TemplateNameSettings settings_;
};

}  // namespace

GEODROME_PLUGIN(TemplateName, .name = "template_name", .summary = "least-squares planes (Pearson 1901)",
                .licence = "MIT", .options = options)
