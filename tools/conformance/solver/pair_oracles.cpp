// SPDX-License-Identifier: MIT
// The answers of a pair oracle, and the oracle that was saved and read.
#include <algorithm>
#include <sstream>
#include <thread>

#include "tools/conformance/solver/solver_trial.hpp"

namespace geodrome::conformance {
namespace {

using Points = std::vector<SurfacePoint>;

constexpr double scale = 15;  ///< about the largest distance on the usual mesh

MeshPtr usual_mesh() { return terrain(9, 1.5, 31); }

/// An oracle with all that it lives on.
struct Oracle {
  std::unique_ptr<PreparedSurface> prepared;
  std::unique_ptr<PairOracle> oracle;

  /// Built, or read from `payload`. Leaves the demand if the solver has none.
  Oracle(const SolverTrial& t, const MeshPtr& mesh, RunContext& context, const std::string* payload = nullptr) {
    t.needs(Provides::pair_queries);
    prepared = t.plugin.object->prepare(mesh, context);
    std::istringstream stream(payload ? *payload : "");
    oracle = prepared->pair_oracle(payload ? &stream : nullptr, context);
    if (!oracle) throw PluginError("pair_oracle gave none, though pair_queries is provided");
  }
  Oracle(const SolverTrial& t, const MeshPtr& mesh, RunContext&& context = QuietContext()) : Oracle(t, mesh, context) {}

  double operator()(const SurfacePoint& from, const SurfacePoint& to) const { return oracle->distance(from, to); }
  std::string saved() const {
    std::ostringstream out;
    oracle->save(out);
    return out.str();
  }
  /// All pairs of the points, row by row.
  std::vector<double> table(const Points& points) const {
    std::vector<double> values;
    for (const SurfacePoint& from : points)
      for (const SurfacePoint& to : points) values.push_back(oracle->distance(from, to));
    return values;
  }
};

Points some_vertices(const SurfaceMesh& mesh, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Points points;
  while (points.size() < count) {
    const Triangle& f = mesh.triangles()[random() % mesh.face_count()];
    points.push_back(mesh.at_vertex(f[random() % 3]));
  }
  return points;
}

Points some_points(const SurfaceMesh& mesh, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Points points;
  for (int i = 0; i < count; ++i) points.push_back(random_point(mesh, random));
  return points;
}

/// All pairs of the points against the reference: nowhere shorter, and within the factor if that is promised of them.
void within_factor(SolverTrial& t, const MeshPtr& mesh, const Points& points, bool promised) {
  const Oracle oracle(t, mesh);
  Running truth(t.reference(), mesh);
  for (const SurfacePoint& from : points) {
    const ShortestPathMap& map = truth.map({{from}});
    for (const SurfacePoint& to : points) {
      const double wanted = map.at(to).value, value = oracle(from, to);
      t.at_least(value, wanted - rounding * scale, "from face ", from.face, " to ", to.face);
      if (promised && t.has_factor())
        t.at_most(value, t.plugin.factor * wanted + rounding * scale, "from face ", from.face, " to ", to.face);
    }
  }
}

void vertices(SolverTrial& t) {
  t.needs(Provides::pair_queries);
  const MeshPtr mesh = usual_mesh();
  within_factor(t, mesh, some_vertices(*mesh, 25, 1), true);
}

void any_points(SolverTrial& t) {
  t.needs(Provides::pair_queries);
  const bool promised = t.has(Provides::factor_any_point);
  const MeshPtr mesh = usual_mesh(), torus = bumpy_torus(18, 9, 0.08, 5);
  within_factor(t, mesh, some_points(*mesh, 20, 2), promised);
  within_factor(t, torus, some_points(*torus, 15, 3), promised);
}

/// Pairs that a region of the surface holds both ends of, often answered in another way than others.
void neighbours(SolverTrial& t) {
  t.needs(Provides::pair_queries);
  Points points;
  for (const Index face : {40u, 41u, 42u, 43u})
    for (const double b : {0.02, 0.3, 0.9}) points.push_back({face, {b, 0.4 * (1 - b), 1 - b - 0.4 * (1 - b)}});
  within_factor(t, usual_mesh(), points, t.has(Provides::factor_any_point));
}

void symmetry(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh();
  const Oracle oracle(t, mesh);
  const Points points = t.has(Provides::factor_any_point) ? some_points(*mesh, 20, 4) : some_vertices(*mesh, 20, 4);
  for (const SurfacePoint& a : points)
    for (const SurfacePoint& b : points)
      t.at_most(oracle(a, b), t.factor_or_one() * oracle(b, a) + rounding * scale, "faces ", a.face, " and ", b.face);
}

void zero(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh();
  const Oracle oracle(t, mesh);
  for (const SurfacePoint& point : some_points(*mesh, 40, 5))
    t.near(oracle(point, point), 0, rounding * scale, "face ", point.face);
}

void names_of_a_vertex(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh();
  const Oracle oracle(t, mesh);
  const SurfacePoint from = mesh->at_vertex(3);
  for (Index face = 0; face < mesh->face_count(); face += 7)
    for (int corner = 0; corner < 3; ++corner) {
      SurfacePoint here{face, {}};
      here.b[corner] = 1;
      const SurfacePoint usual = mesh->at_vertex(mesh->triangles()[face][corner]);
      t.near(oracle(here, usual), 0, rounding * scale, "face ", face, ", corner ", corner);
      t.near(oracle(from, here), oracle(from, usual), rounding * scale, "face ", face, ", corner ", corner);
    }
}

void components(SolverTrial& t) {
  const MeshPtr mesh = both(octahedron(), mapped(octahedron(), [](const Vec3& p) { return p + Vec3{5, 0, 0}; }));
  t.needs(Provides::pair_queries);
  t.needs_fit(mesh);
  const Oracle oracle(t, mesh);
  for (Index from = 0; from < 16; ++from)
    for (Index to = 0; to < 16; ++to)
      for (const auto& b : {std::array<double, 3>{1, 0, 0}, {0, 0.25, 0.75}, {0.5, 0.25, 0.25}})
        t.holds(std::isfinite(oracle({from, {0.25, 0.25, 0.5}}, {to, b})) == ((from < 8) == (to < 8)),
                "infinite between components alone", "faces ", from, " and ", to);
}

void off_the_mesh(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh();
  const Oracle oracle(t, mesh);
  const SurfacePoint good = mesh->at_vertex(0), bad{static_cast<Index>(mesh->face_count()), {1, 0, 0}};
  t.throws<InputError>([&] { oracle(good, bad); }, "to a face that is not there");
  t.throws<InputError>([&] { oracle(bad, good); }, "from a face that is not there");
}

void saved_and_read(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh();
  QuietContext quiet;
  const Oracle first(t, mesh);
  const std::string payload = first.saved();
  const Oracle second(t, mesh, quiet, &payload);
  const Points points = some_points(*mesh, 20, 6);
  t.holds(same_bytes(first.table(points), second.table(points)), "the same answers");
  t.holds(second.saved() == payload, "the same bytes when saved again");
}

void truncated(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh();
  QuietContext quiet;
  const std::string payload = Oracle(t, mesh).saved();
  t.holds(!payload.empty(), "something is saved");
  const auto refused = [&](std::size_t size) {
    const std::string part = payload.substr(0, size);
    t.throws<InputError>([&] { Oracle(t, mesh, quiet, &part); }, size, " of ", payload.size(), " bytes");
  };
  if (payload.empty()) return;
  for (std::size_t k = 0; k < 20; ++k) refused(std::min(k, payload.size() - 1)), refused(payload.size() * k / 20);
  refused(payload.size() - 1);
}

void foreign(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh();
  QuietContext quiet;
  const auto refused = [&](const std::string& payload, const char* what) {
    t.throws<InputError>([&] { Oracle(t, mesh, quiet, &payload); }, what);
  };
  refused(Oracle(t, terrain(5, 1, 9)).saved(), "of another mesh");
  std::mt19937_64 random(7);
  for (int k = 0; k < 50; ++k) {
    std::string noise(1 + random() % 3000, '\0');
    for (char& c : noise) c = static_cast<char>(random());
    refused(noise, "noise");
  }
  refused(std::string(2000, '\0'), "zeros");
  refused(std::string(2000, '\xff'), "ones");
}

/// The engine's checksum finds such bytes before; a plugin that is asked otherwise may be deceived but must not crash.
void wrong_byte(SolverTrial& t) {
  const MeshPtr mesh = usual_mesh();
  QuietContext quiet;
  const std::string payload = Oracle(t, mesh).saved();
  std::mt19937_64 random(8);
  for (int k = 0; k < 100 && !payload.empty(); ++k) {
    std::string wrong = payload;
    wrong[k < 50 ? std::min<std::size_t>(k, payload.size() - 1) : random() % payload.size()] ^= '\x81';
    try {
      Oracle(t, mesh, quiet, &wrong);
    } catch (const InputError&) {
    }
    t.holds(true, "read or refused");
  }
}

void threads(SolverTrial& t) {
  Threads two(2);
  const MeshPtr mesh = usual_mesh();
  const Points points = some_points(*mesh, 30, 9);
  const Oracle oracle(t, mesh);
  const std::vector<double> alone = oracle.table(points);
  t.holds(same_bytes(alone, Oracle(t, mesh, two).table(points)), "the same bytes when built by two threads");
  std::vector<double> a, b;
  std::thread one([&] { a = oracle.table(points); }), other([&] { b = oracle.table(points); });
  one.join(), other.join();
  t.holds(same_bytes(a, alone) && same_bytes(b, alone), "the same bytes when two threads ask at once");
}

void cancelled(SolverTrial& t) {
  t.needs(Provides::pair_queries);
  QuietContext quiet;
  const auto prepared = t.plugin.object->prepare(usual_mesh(), quiet);
  CancelAfter at_once(0);
  t.throws<Cancelled>([&] { prepared->pair_oracle(nullptr, at_once); });
  t.holds(prepared->pair_oracle(nullptr, quiet) != nullptr, "it can be built afterwards");
}

void none_if_not_provided(SolverTrial& t) {
  if (t.has(Provides::pair_queries)) throw NotApplicable{"the solver provides pair_queries"};
  const MeshPtr mesh = usual_mesh();
  t.needs_fit(mesh);
  QuietContext quiet;
  t.holds(t.plugin.object->prepare(mesh, quiet)->pair_oracle(nullptr, quiet) == nullptr, "no oracle");
}

}  // namespace

DemandTable pair_oracle_demands() {
  return {
      solver_demand<vertices>("pairs.vertices", "an oracle's answers keep the factor between vertices"),
      solver_demand<any_points>("pairs.any_points",
                                "between any points they are not short, and keep the factor if that is stated"),
      solver_demand<neighbours>("pairs.neighbours", "so they do within one face and between neighbours"),
      solver_demand<symmetry>("pairs.symmetry", "they are symmetric within the factor"),
      solver_demand<zero>("pairs.zero", "a point is at distance 0 from itself"),
      solver_demand<names_of_a_vertex>("pairs.names", "the face that names a vertex does not matter"),
      solver_demand<components>("pairs.components", "they are infinite between components alone"),
      solver_demand<off_the_mesh>("pairs.off_the_mesh", "a point off the mesh is refused"),
      solver_demand<saved_and_read>("pairs.saved", "an oracle that was saved and read answers with the same bytes"),
      solver_demand<truncated>("pairs.truncated", "a truncated one is refused"),
      solver_demand<foreign>("pairs.foreign", "one of another mesh, or noise, is refused"),
      solver_demand<wrong_byte>("pairs.wrong_byte", "a wrong byte crashes nothing"),
      solver_demand<threads>("pairs.threads", "threads change no byte"),
      solver_demand<cancelled>("pairs.cancelled", "building can be cancelled"),
      solver_demand<none_if_not_provided>("pairs.not_provided", "there is no oracle where none is provided"),
  };
}

}  // namespace geodrome::conformance
