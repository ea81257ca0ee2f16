// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geodrome/engine/input.hpp"
#include "geodrome/engine/observer.hpp"
#include "geodrome/engine/plugin_host.hpp"
#include "geodrome/engine/surface_locator.hpp"
#include "geodrome/plugin.hpp"
#include "geodrome/smooth_surface.hpp"

namespace geodrome {

/// Which plugin does each stage, as PluginHost::load takes it: "name[:key=value,...]". `solver_of_accuracy` names the
/// solver for an accuracy.
struct StageChoice {
  std::string tangent = "jet", control = "lipschitz", decimator = "greedy", reconstructor = "delaunay_cut",
              solver = "chen_han";
};

/// What is measured of a point sample: all of it, or the largest part that makes a surface by itself (`SurfacePart`).
enum class Part : std::uint8_t { whole, largest };

/// What distances are measured on. `flat`: the triangles. `smooth`: the smooth surface that the tangent estimator fits
/// to the sample, or to the vertices of a mesh, where that is trusted; the flat path to each target becomes a geodesic
/// of it. D is then the length of a curve on that surface, to fourth order in the spacing of its nodes, and no upper
/// bound; it is not below the straight line.
enum class Metric : std::uint8_t { flat, smooth };

/// The settings that every job has. `threads` 0 means one per core. No result depends on it.
struct RunSettings {
  StageChoice stages;
  ReadOptions read;
  Part part = Part::whole;
  Metric metric = Metric::flat;  ///< of all jobs with a solver and of the questions of a session
  std::vector<std::filesystem::path> plugin_path;
  unsigned threads = 0;
  std::uint64_t seed = 1;
};

/// The record of what one stage did, for the run report.
struct StageRecord {
  PluginInfo plugin;
  OptionValues options;
  double seconds = 0;
  std::map<std::string, double> measures;
};

/// Where a point of the input, or one the user named, lies on the surface.
struct Place {
  enum class State : std::uint8_t {
    on_surface,
    isolated,  ///< a vertex that no face uses: reaches only itself
    dropped,   ///< not finite or an outlier: its distances are NaN
    off_part   ///< not on the part of the sample that was asked for: its distances are NaN
  };

  /// False for a place whose distances are NaN.
  bool has_distances() const { return state == State::on_surface || state == State::isolated; }

  State state = State::dropped;
  SurfacePoint at;          ///< if on_surface
  Index vertex = no_index;  ///< the vertex there, if it is one
  Vec3 position;            ///< the point itself, which for a cloud may lie beside the surface
};

/// The sample stages' results, kept for the report; empty for a mesh as input.
struct SampleStages {
  Tangents tangents;
  PointSample smoothed;  ///< the origins of the tangent planes: what stages 2 to 4 worked on
  Control control;
  std::vector<Index> kept, sample_of_vertex;
};

/// The part of a sample that a surface was made of, and what was set aside; in points of the sample, each once.
struct SurfacePart {
  std::size_t points = 0, sample = 0;  ///< on the part; in the sample
  std::size_t no_surface = 0;          ///< set aside: their neighbourhoods are no surface that hangs together with it
  std::size_t other_pieces = 0;        ///< set aside: near other pieces of the surface
  std::size_t off_surface = 0;         ///< set aside: farther from the surface than three spacings
  std::size_t faces_left_out = 0;      ///< faces that span what the sample does not show
  Index row = no_index;                ///< a row in the middle of the part
  double spacing = 0;                  ///< of the points that the surface was made from, median, units of the input
  std::vector<double> reach;           ///< per vertex of the surface: how far from it a point may be to be on the part

  double share() const { return static_cast<double>(points) / static_cast<double>(sample); }
};

/// The smooth surface over the faces of a mesh.
struct FittedSurface {
  std::shared_ptr<const SmoothSurface> surface;
  StageRecord record;  ///< of the tangent estimator, which fitted it
  std::size_t trusted_faces = 0;
  double largest_deviation = 0, mean_deviation = 0;  ///< estimates, over trusted faces, units of the input
};

/// A surface, and on it a place for every row of the input.
struct PlacedSurface {
  InputKind made_from = InputKind::mesh;
  MeshPtr mesh;
  std::shared_ptr<const SurfaceLocator> locator;  ///< of a cloud's surface; null for a mesh, whose rows need none
  std::shared_ptr<const PointInserter> inserter;  ///< null where the reconstructor has none, and for a mesh
  std::vector<Place> places;
  std::optional<SampleStages> sample;
  std::optional<FittedSurface> smooth;  ///< if distances are measured on it: see `RunSettings::metric`
  std::optional<SurfacePart> part;      ///< if the surface is of a part of the sample: see `RunSettings::part`
  std::vector<StageRecord> stages;
  std::vector<Finding> findings;  ///< their elements are rows of the input
};

/// The outcome of trying to make a surface. `surface` holds what was learned up to the refusal if a stage refused the
/// sample: the results of the stages before it and the records up to its own, but neither mesh nor places.
struct SurfaceAttempt {
  PlacedSurface surface;
  std::optional<SampleError> refusal;  ///< the elements of its findings are rows of the input
};

/// Lines 3 to 7 of Algorithm 2: stages 1 to 4 for a cloud; for a mesh, the mesh. Places follow the corrected query
/// rule: the globally closest point of the surface. Errors: what the plugins throw, and PluginError for a result that
/// breaks the interface. Complexity: that of the plugins, and O(n log F) for the places. `settings.part` is not used:
/// jobs and sessions choose the part, and fit what is smooth.
PlacedSurface make_surface(const Input& input, const PluginHost& host, const RunSettings& settings, Observer& observer);

/// As `make_surface`, but a SampleError is returned with what was learned, for the sample report.
SurfaceAttempt try_surface(const Input& input, const PluginHost& host, const RunSettings& settings, Observer& observer);

/// The number of threads that `settings` asks for.
unsigned thread_count(const RunSettings& settings);

}  // namespace geodrome
