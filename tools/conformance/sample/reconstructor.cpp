// SPDX-License-Identifier: MIT
// Every reconstructor: an oriented manifold of the right shape, or a refusal that says where.
#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/checks/surface_facts.hpp"
#include "tools/conformance/sample/reconstructor_trial.hpp"
#include "tools/shapes/random.hpp"

namespace geodrome::conformance {
namespace {

/// The surface, checked for what every surface must be. A refusal must tell where; it leaves the demand.
Reconstruction sound(ReconstructorTrial& t, const Staged& s, const char* name) {
  Reconstruction made;
  try {
    made = t.reconstruct(s);
  } catch (const SampleError& refusal) {
    t.holds(!refusal.findings().empty(), "a refusal with findings", name, ": ", refusal.what());
    throw NotApplicable{text(name, ": the method refuses this sample, with findings: ", refusal.what())};
  }
  if (!made.mesh) throw PluginError("reconstruct gave no mesh");
  const SurfaceMesh& mesh = *made.mesh;
  t.holds(mesh.manifold(), "a manifold", name);
  t.holds(mesh.oriented(), "oriented", name);
  t.equal(made.sample_of_vertex.size(), mesh.vertex_count(), "names of vertices, ", name);
  for (Index v = 0; v < std::min(made.sample_of_vertex.size(), mesh.vertex_count()); ++v) {
    const Index sample = made.sample_of_vertex[v];
    t.holds(mesh.first_half_edge(v) != no_index, "no vertex without a face", name, ", vertex ", v);
    t.holds(sample == no_index || mesh.positions()[v] == s.sample.points[sample], "the place of its sample point", name,
            ", vertex ", v);
  }
  return made;
}

/// The one shape that every method must get right.
void sphere(ReconstructorTrial& t) {
  const Staged s = t.staged(shapes::small::sphere(1500, 9));
  const Reconstruction made = t.reconstruct(s);
  sound(t, s, "sphere");
  t.holds(made.mesh->closed(), "closed");
  t.equal(facts_of(*made.mesh).euler_number, 2L, "Euler number");
  t.near(volume(*made.mesh), 4.18879, 0.1, "volume, positive if faces look outwards");
}

void torus(ReconstructorTrial& t) {
  const PointSample sample = points_of(bumpy_torus(60, 24, 0.01, 3));
  const Reconstruction made = sound(t, t.staged(sample), "torus");
  t.holds(made.mesh->closed(), "closed");
  t.equal(facts_of(*made.mesh).euler_number, 0L, "Euler number");
  t.equal(made.mesh->vertex_count(), sample.size(), "vertices");
  const double wanted = 2 * std::numbers::pi * std::numbers::pi * 0.4 * 0.4;
  t.near(volume(*made.mesh), wanted, 0.1 * wanted, "volume, positive if faces look outwards");
}

void tube_with_boundary(ReconstructorTrial& t) {
  const Reconstruction made = sound(t, t.staged(points_of(prism(40, 12, 0.16))), "tube");
  t.equal(facts_of(*made.mesh).euler_number, 0L, "Euler number of a tube with two boundary loops");
  t.holds(!made.mesh->closed(), "open");
  t.holds(
      std::any_of(made.findings.begin(), made.findings.end(), [](const Finding& f) { return f.code == "boundary"; }),
      "a finding with the code 'boundary'");
}

void planar_grid(ReconstructorTrial& t) {
  const Reconstruction made = sound(t,
                                    t.staged(points_of(mapped(plane_grid(Index{12}),
                                                              [](const Vec3& p) {
                                                                return Vec3{p.x, 0.6 * p.y, 5 + 0.8 * p.y};
                                                              }))),
                                    "planar grid");
  t.equal(made.mesh->face_count(), std::size_t{2 * 12 * 12}, "faces");
  t.equal(facts_of(*made.mesh).euler_number, 1L, "Euler number of a disc");
}

void notch(ReconstructorTrial& t) {
  PointSample sample;
  const auto grid = plane_grid(Index{16});
  for (const Vec3& p : grid->positions())
    if (p.x <= 4 || p.y <= 4) sample.points.push_back(p);
  const Reconstruction made = sound(t, t.staged(sample), "notch");
  const SurfaceMesh& mesh = *made.mesh;
  for (Index h = 0; h < 3 * mesh.face_count(); ++h)
    t.at_most(distance(mesh.positions()[mesh.from(h)], mesh.positions()[mesh.to(h)]), 12, "length of half-edge ", h,
              "; the mouth of the notch is 12 sqrt(2) wide");
}

void clusters(ReconstructorTrial& t) {
  PointSample sample = shapes::small::torus(3000, 11);
  const PointSample other = moved(shapes::small::torus(3000, 12), 1, {4, 0, 0});
  sample.points.insert(sample.points.end(), other.points.begin(), other.points.end());
  const Reconstruction made = sound(t, t.staged(sample), "two tori");
  t.equal(facts_of(*made.mesh).components, std::size_t{2}, "components");
}

/// For samples that stages 1 to 3 would refuse themselves.
Staged unstaged(const PointSample& sample) {
  Staged s{sample, {}, {}, {}};
  for (Index i = 0; i < sample.size(); ++i) {
    s.tangents.plane.push_back({sample.points[i], {0, 0, 1}, 0});
    s.kept.push_back(i);
  }
  s.tangents.state.assign(sample.size(), PointState::ok);
  s.control = {std::vector<double>(sample.size(), 1), std::vector<double>(sample.size(), 1), s.tangents.state};
  return s;
}

void no_surface(ReconstructorTrial& t) {
  PointSample line;
  for (int i = 0; i < 30; ++i) line.points.push_back({0.1 * i, 0.2 * i, 0.3 * i});
  t.throws<SampleError>([&] { t.reconstruct(unstaged(line)); }, "points of a line");
  t.throws<SampleError>([&] { t.reconstruct(unstaged({{{0, 0, 0}, {1, 0, 0}}})); }, "two points");
}

void again(ReconstructorTrial& t) {
  const Staged s = t.staged(shapes::small::sphere(1000, 7));
  const Reconstruction a = sound(t, s, "sphere"), b = sound(t, s, "sphere");
  t.holds(std::ranges::equal(a.mesh->triangles(), b.mesh->triangles()), "the same faces");
}

/// The surface of a block of a cubic lattice: nothing but equal lengths and radii.
PointSample block_lattice(int steps) {
  PointSample sample;
  const auto is_end = [&](int i) { return i == 0 || i == steps; };
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j)
      for (int k = 0; k <= steps; ++k)
        if (is_end(i) || is_end(j) || is_end(k))
          sample.points.push_back({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
  return sample;
}

/// Between the calls memory of many sizes is taken and partly given back, so that addresses come in other orders.
void ties(ReconstructorTrial& t) {
  shapes::Random random(1);
  std::vector<std::vector<char>> held;
  for (const auto& [name, sample] :
       {std::pair("block lattice", block_lattice(4)), {"plane lattice", plane_lattice(12, 9)}}) {
    const Staged s = t.staged(sample);
    std::vector<Triangle> first;
    for (int call = 0; call < 12; ++call) {
      const Reconstruction made = sound(t, s, name);
      const auto faces = made.mesh->triangles();
      if (call == 0) first.assign(faces.begin(), faces.end());
      t.holds(std::ranges::equal(faces, first), "the same faces", name, ", call ", call);
      for (int i = 0; i < 500; ++i) held.emplace_back(1 + random.index(600));
      std::erase_if(held, [&](const auto&) { return random.uniform() < 0.5; });
    }
  }
}

void cancelled(ReconstructorTrial& t) {
  const Staged s = t.staged(points_of(bumpy_torus(30, 14, 0.02, 7)));
  SampleContext context;
  context.stop = true;
  t.throws<Cancelled>([&] { t.plugin.object->reconstruct(s.sample, s.tangents, s.control, s.kept, context); });
}

}  // namespace

DemandTable reconstructor_demands() {
  return {
      demand<ReconstructorTrial, sphere>("reconstructor.sphere",
                                         "a sphere comes out closed, of genus 0, facing outwards"),
      demand<ReconstructorTrial, torus>("reconstructor.torus", "a torus comes out closed, of genus 1, facing outwards"),
      demand<ReconstructorTrial, tube_with_boundary>("reconstructor.tube",
                                                     "a tube keeps its two boundary loops, and tells of them"),
      demand<ReconstructorTrial, planar_grid>("reconstructor.planar_grid", "a planar grid becomes a disc in its plane"),
      demand<ReconstructorTrial, notch>("reconstructor.notch", "a notch of a planar sample is not filled"),
      demand<ReconstructorTrial, clusters>("reconstructor.clusters", "two clusters become two components"),
      demand<ReconstructorTrial, no_surface>("reconstructor.no_surface", "a line and two points are refused"),
      demand<ReconstructorTrial, again>("reconstructor.again", "the same sample gives the same faces again"),
      demand<ReconstructorTrial, ties>("reconstructor.ties",
                                       "a lattice, in which all is equal, gives the same faces in every call"),
      demand<ReconstructorTrial, cancelled>("reconstructor.cancelled", "a cancelled run throws Cancelled"),
  };
}

}  // namespace geodrome::conformance
