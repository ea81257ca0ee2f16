// SPDX-License-Identifier: MIT
#include "tools/shapes/fuzz_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "tools/shapes/hostile.hpp"
#include "tools/shapes/mutations.hpp"
#include "tools/shapes/random.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::shapes {
namespace {

struct Base {
  const char* name;
  SurfaceMesh (*make)(Random& random);
};

std::uint64_t any_seed(Random& random) { return random.index(1'000'000'000); }
/// From `low` to `high`.
Index between(Index low, Index high, Random& random) {
  return low + static_cast<Index>(random.index(std::size_t{high} - low + 1));
}
SurfaceMesh of_kind(const char* kind, Index low, Index high, Random& random) {
  const Index faces = between(low, high, random);
  return mesh(kind, faces, any_seed(random));
}

const Base bases[] = {
    {"jittered-torus", [](Random& r) { return of_kind("jittered-torus", 100, 1500, r); }},
    {"noisy-sphere", [](Random& r) { return of_kind("noisy-sphere", 80, 1280, r); }},
    {"bumpy", [](Random& r) { return of_kind("bumpy", 80, 1280, r); }},
    {"icosphere", [](Random& r) { return of_kind("icosphere", 80, 1280, r); }},
    {"plane", [](Random& r) { return of_kind("plane", 100, 1500, r); }},
    {"cut-torus", [](Random& r) { return of_kind("cut-torus", 200, 1500, r); }},
    {"torus", [](Random& r) { return of_kind("torus", 100, 1500, r); }},
    {"genus2", [](Random& r) { return of_kind("genus2", 1200, 1500, r); }},
    {"terrain",
     [](Random& r) {
       const double height = std::pow(10, r.uniform(-1, 2));
       const Index n = between(8, 28, r);
       return terrain(n, height, any_seed(r));
     }},
    {"near-flat",
     [](Random& r) {
       const double jitter = r.uniform() < 0.5 ? 0 : 0.2;
       const Index n = between(8, 28, r);
       return near_flat(n, jitter, any_seed(r));
     }},
    {"box",
     [](Random& r) {
       const Index x = between(1, 12, r), y = between(1, 12, r), z = between(1, 12, r);
       return lattice_box(std::max<Index>(x, 3), std::max<Index>(y, 3), z);
     }},
    {"octahedron", [](Random& r) { return octahedron(between(2, 4, r)); }},
    {"pillow", [](Random& r) { return pillow(2 * between(3, 10, r)); }},
    {"needle-cone",
     [](Random& r) {
       const Index degree = between(5, 80, r);
       return needle_cone(degree, between(0, 3, r));
     }},
    {"needle-cylinder",
     [](Random& r) {
       const Index around = between(10, 150, r);
       return needle_cylinder(around, between(1, 5, r));
     }},
    {"graded-grid",
     [](Random& r) {
       const Index n = between(8, 28, r);
       return graded_grid(n, any_seed(r));
     }},
    {"stretched-waves",
     [](Random& r) {
       const double aspect = std::pow(10, r.uniform(0, 3));
       const Index n = between(8, 28, r);
       return stretched_waves(n, aspect, any_seed(r));
     }},
    {"spiral-corridor", [](Random& r) { return spiral_corridor(between(1, 5, r)); }},
    {"spiral-stair", [](Random& r) { return spiral_stair(between(1, 6, r)); }},
};

/// Applies mutations, each with a chance, and writes down which.
class Mutator {
 public:
  Mutator(Soup& soup, std::string& recipe, Random& random) : soup_(soup), recipe_(recipe), random_(random) {}

  template <class Mutation>
  void maybe(double chance, const char* name, Mutation mutation) {
    if (random_.uniform() >= chance) return;
    mutation(soup_, random_);
    recipe_ += std::string(", ") + name;
  }

  /// A mutation that is done up to `most` times.
  template <class Mutation>
  void maybe_some(double chance, const char* name, std::size_t most, Mutation mutation) {
    if (random_.uniform() >= chance) return;
    const std::size_t count = 1 + random_.index(most);
    mutation(soup_, count, random_);
    recipe_ += std::string(", ") + name + " " + std::to_string(count);
  }

 private:
  Soup& soup_;
  std::string& recipe_;
  Random& random_;
};

const Base& any_base(Random& random) { return bases[random.index(std::size(bases))]; }

void scale(Soup& soup, std::string& recipe, Random& random) {
  const double factor = random.uniform() < 0.5 ? 1e-6 : 1e6;
  for (Vec3& p : soup.positions) p = factor * p;
  recipe += factor < 1 ? ", scale 1e-06" : ", scale 1e+06";
}

void move_away(Soup& soup, std::string& recipe) {
  double extent = 0;
  for (const Vec3& p : soup.positions) extent = std::max(extent, norm(p));
  for (Vec3& p : soup.positions) p = p + 100 * extent * Vec3{1, -0.7, 0.3};
  recipe += ", far from the origin";
}

}  // namespace

FuzzMesh fuzz_mesh(std::uint64_t seed) {
  Random random(seed);
  const Base& base = any_base(random);
  Soup soup(base.make(random));
  std::string recipe = base.name;
  if (random.uniform() < 0.1) {
    const Base& second = any_base(random);
    append(soup, Soup(second.make(random)));
    recipe += std::string(" and ") + second.name;
  }
  Mutator mutator(soup, recipe, random);
  mutator.maybe(0.25, "stretched", stretch);
  mutator.maybe(0.25, "jittered", jitter);
  mutator.maybe_some(0.35, "needles", 12, pull_needles);
  mutator.maybe_some(0.2, "holes", 20, cut_holes);
  mutator.maybe_some(0.1, "stars cut", 4, cut_stars);
  mutator.maybe_some(0.12, "touching fans", 4, leave_touching_fans);
  mutator.maybe_some(0.12, "bow-ties", 4, tie_bows);
  mutator.maybe(0.3, "renumbered", renumber);
  if (random.uniform() < 0.15) scale(soup, recipe, random);
  if (random.uniform() < 0.05) move_away(soup, recipe);
  return {soup.mesh(), recipe};
}

}  // namespace geodrome::shapes
