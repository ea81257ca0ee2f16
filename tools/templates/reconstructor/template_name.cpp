// A reconstructor to start from: the convex hull of the kept points, made point by point (Kallay 1984), which is right
// for samples of convex surfaces. A sample with points inside their hull, in a plane or on a line is refused, with the
// places. O(n^2). Replace `Hull` by your method; what is checked behind it stays true for any.
#include <algorithm>
#include <geodrome/plugin.hpp>
#include <set>

using namespace geodrome;

namespace {

/// Above 0 where `p` lies on the side that the triangle's normal points to: six times a volume.
double side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) { return dot(cross(b - a, c - a), p - a); }

/// The convex hull of the points added so far, faces outwards.
class Hull {
 public:
  /// The tetrahedron of four points, named by their indices, that do not lie in a plane.
  Hull(const std::vector<Vec3>& points, std::array<Index, 4> start) : points_(points) {
    auto& [a, b, c, d] = start;
    if (side(points[a], points[b], points[c], points[d]) > 0) std::swap(a, b);
    faces_ = {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
  }

  /// The faces that see the point give way to those between it and the horizon.
  void add(Index p) {
    const auto [first, last] = std::ranges::partition(faces_, [&](const Triangle& f) { return !sees(f, p); });
    std::set<std::pair<Index, Index>> edges;
    for (auto face = first; face != last; ++face)
      for (int i = 0; i < 3; ++i) edges.emplace((*face)[i], (*face)[(i + 1) % 3]);
    faces_.erase(first, last);
    for (const auto& [a, b] : edges)
      if (!edges.contains({b, a})) faces_.push_back({a, b, p});
  }

  const std::vector<Triangle>& faces() const { return faces_; }

 private:
  bool sees(const Triangle& f, Index p) const {
    return side(points_[f[0]], points_[f[1]], points_[f[2]], points_[p]) > 0;
  }

  const std::vector<Vec3>& points_;
  std::vector<Triangle> faces_;
};

/// Refuses the sample; the elements are sample points, the worst first.
[[noreturn]] void refuse(const char* code, const std::string& why, std::size_t count, std::vector<Index> places) {
  places.resize(std::min<std::size_t>(places.size(), 10));
  throw SampleError(why, "choose another reconstructor",
                    {{Finding::Severity::refusal, code, why + ".", count, std::move(places), {}}});
}

/// The index in `points` where `value` is largest.
template <class Value>
Index farthest(const std::vector<Vec3>& points, Value&& value) {
  return static_cast<Index>(std::ranges::max_element(points, {}, value) - points.begin());
}

/// Four points that span as much as can be found quickly.
std::array<Index, 4> corners_of(const std::vector<Vec3>& points, std::span<const Index> kept) {
  const Vec3 a = points[0];
  const Index at_b = farthest(points, [&](const Vec3& p) { return squared_distance(p, a); });
  const Vec3 b = points[at_b] - a;
  const Index at_c = farthest(points, [&](const Vec3& p) { return squared_norm(cross(b, p - a)); });
  const Vec3 normal = cross(b, points[at_c] - a);
  const Index at_d = farthest(points, [&](const Vec3& p) { return std::abs(dot(normal, p - a)); });
  constexpr double flat = 1e-9;  // height over length, far above rounding
  if (std::abs(dot(normal, points[at_d] - a)) <= flat * norm(normal) * norm(b))
    refuse("flat", "the points lie in a plane", kept.size(), {kept.begin(), kept.end()});
  return {0, at_b, at_c, at_d};
}

class TemplateName : public SurfaceReconstructor {
 public:
  Reconstruction reconstruct(const PointSample& sample, const Tangents&, const Control&, std::span<const Index> kept,
                             RunContext& context) const override {
    context.throw_if_cancelled();
    if (kept.size() < 4) refuse("few_points", "fewer than four points have no hull", kept.size(), {});
    std::vector<Vec3> points;
    for (const Index i : kept) points.push_back(sample.points[i]);
    const std::array<Index, 4> start = corners_of(points, kept);
    Hull hull(points, start);
    for (Index p = 0; p < points.size(); ++p) {
      context.throw_if_cancelled();
      if (std::ranges::find(start, p) == start.end()) hull.add(p);
      context.progress(static_cast<double>(p + 1) / static_cast<double>(points.size()));
    }
    refuse_points_inside(hull, kept);
    Reconstruction made;
    made.mesh = std::make_shared<const SurfaceMesh>(std::move(points), hull.faces());
    made.sample_of_vertex.assign(kept.begin(), kept.end());
    if (!made.mesh->manifold() || !made.mesh->oriented() || !made.mesh->closed())
      refuse("rounding", "points lie too close to a plane for this method", kept.size(), {kept.begin(), kept.end()});
    return made;
  }

 private:
  static void refuse_points_inside(const Hull& hull, std::span<const Index> kept) {
    std::vector<bool> used(kept.size());
    for (const Triangle& face : hull.faces())
      for (const Index corner : face) used[corner] = true;
    std::vector<Index> inside;
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (!used[i]) inside.push_back(kept[i]);
    const std::size_t count = inside.size();
    if (count > 0)
      refuse("inside_hull", std::to_string(count) + " points lie inside the convex hull", count, std::move(inside));
  }
};

}  // namespace

GEODROME_PLUGIN(TemplateName, .name = "template_name", .summary = "the convex hull (Kallay 1984)", .licence = "MIT")
