// SPDX-License-Identifier: MIT
// A pair oracle that is exact and simple, or one that has the fault it is told to have: distances of all pairs of
// vertices from searches, kept in a table; other points by a search each.
#include <algorithm>
#include <cstring>
#include <istream>
#include <ostream>

#include "geodrome/plugin.hpp"
#include "tests/plugins_for_tests/exact_solver.hpp"

namespace {

using namespace geodrome;

constexpr std::uint32_t payload_format = 1;

struct Settings {
  double stretch = 1;
  int rounds = 1;
  std::string fault;
};

constexpr auto options = settings_table(
    option("stretch", &Settings::stretch, "1", 1, 9, "", "distances are so many times too long: the factor"),
    option("rounds", &Settings::rounds, "1", 1, 9, "", "changes nothing"),
    option("fault", &Settings::fault, "none",
           "none|no_oracle|nan|negative|short|everywhere_inf|never_inf|away_from_itself|throws|save_throws",
           "what is wrong with the oracle"));

double factor(const OptionValues* values) noexcept { return options.parsed(*values).stretch; }

class Oracle final : public PairOracle {
 public:
  Oracle(MeshPtr mesh, std::shared_ptr<const PreparedSurface> exact, Settings settings)
      : mesh_(std::move(mesh)), exact_(std::move(exact)), settings_(std::move(settings)) {}

  void build(RunContext& context) {
    const auto search = exact_->make_search();
    const auto n = static_cast<Index>(mesh_->vertex_count());
    table_.assign(std::size_t{n} * n, std::numeric_limits<double>::infinity());
    for (Index v = 0; v < n; ++v) {
      context.throw_if_cancelled();
      if (mesh_->first_half_edge(v) == no_index) continue;
      const Source source{mesh_->at_vertex(v), 0};
      std::ranges::copy(search->run({&source, 1}, {}, context).vertices(), table_.begin() + std::size_t{v} * n);
      context.progress((v + 1.0) / n);
    }
  }

  void read(std::istream& in) {
    std::uint32_t format = 0;
    std::uint64_t vertices = 0;
    in.read(reinterpret_cast<char*>(&format), sizeof format);
    in.read(reinterpret_cast<char*>(&vertices), sizeof vertices);
    if (!in || format != payload_format || vertices != mesh_->vertex_count())
      throw InputError(InputFault::syntax, "no table of this mesh");
    table_.resize(vertices * vertices);
    in.read(reinterpret_cast<char*>(table_.data()), static_cast<std::streamsize>(table_.size() * sizeof(double)));
    if (!in) throw InputError(InputFault::truncated, "the table ends too early");
  }

  void save(std::ostream& out) const override {
    if (settings_.fault == "save_throws") throw std::runtime_error("the table is gone");
    const std::uint64_t vertices = mesh_->vertex_count();
    out.write(reinterpret_cast<const char*>(&payload_format), sizeof payload_format);
    out.write(reinterpret_cast<const char*>(&vertices), sizeof vertices);
    out.write(reinterpret_cast<const char*>(table_.data()),
              static_cast<std::streamsize>(table_.size() * sizeof(double)));
  }

  double distance(const SurfacePoint& from, const SurfacePoint& to) const override {
    if (std::max(from.face, to.face) >= mesh_->face_count()) throw InputError(InputFault::index, "no such face");
    const double value = exact(from, to);
    const std::string& fault = settings_.fault;
    if (fault == "nan") return std::numeric_limits<double>::quiet_NaN();
    if (fault == "negative") return -value - 1;
    if (fault == "short") return 0.5 * value;
    if (fault == "everywhere_inf") return std::numeric_limits<double>::infinity();
    if (fault == "never_inf") return std::min(value, 1e3);
    if (fault == "away_from_itself") return value + 1;
    if (fault == "throws") throw std::runtime_error("a pair too far");
    return settings_.stretch * value;
  }

 private:
  double exact(const SurfacePoint& from, const SurfacePoint& to) const {
    const Index a = mesh_->vertex_at(from), b = mesh_->vertex_at(to);
    if (a != no_index && b != no_index) return table_[std::size_t{a} * mesh_->vertex_count() + b];
    if (from == to) return 0;
    QuietContext context;
    const auto search = exact_->make_search();
    const Source source{from, 0};
    return search->run({&source, 1}, {.targets = {&to, 1}}, context).at(to).value;
  }

  MeshPtr mesh_;
  std::shared_ptr<const PreparedSurface> exact_;
  Settings settings_;
  std::vector<double> table_;  // per source, per target
};

class Surface final : public PreparedSurface {
 public:
  Surface(MeshPtr mesh, std::shared_ptr<const PreparedSurface> exact, Settings settings)
      : mesh_(std::move(mesh)), exact_(std::move(exact)), settings_(std::move(settings)) {}

  std::unique_ptr<Search> make_search() const override { return exact_->make_search(); }
  std::size_t bytes() const override { return exact_->bytes(); }
  std::unique_ptr<PairOracle> pair_oracle(std::istream* saved, RunContext& context) const override {
    if (settings_.fault == "no_oracle") return nullptr;
    auto oracle = std::make_unique<Oracle>(mesh_, exact_, settings_);
    saved ? oracle->read(*saved) : oracle->build(context);
    return oracle;
  }

 private:
  MeshPtr mesh_;
  std::shared_ptr<const PreparedSurface> exact_;
  Settings settings_;
};

class Solver : public ShortestPathSolver {
 public:
  explicit Solver(const OptionValues& values) : settings_(options.parsed(values)) {}

  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override {
    return std::make_unique<Surface>(mesh, exact_.prepare(mesh, context), settings_);
  }

 private:
  Settings settings_;
  test::ExactSolver exact_;
};

}  // namespace

GEODROME_PLUGIN(Solver, .name = "test_pairs", .summary = "a table of all pairs of vertices", .licence = "MIT",
                .provides = test::ExactSolver::provides | Provides::pair_queries, .options = options, .factor = factor)
