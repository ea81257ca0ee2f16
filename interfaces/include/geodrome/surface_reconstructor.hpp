// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geodrome/control_function.hpp"
#include "geodrome/finding.hpp"
#include "geodrome/surface.hpp"

namespace geodrome {

/// The way in which a sample point became a vertex.
enum class Insertion : std::uint8_t {
  existing,  ///< it is one already: the mesh is the reconstruction's own
  cavity,    ///< all faces around it whose sphere holds it gave way to its star
  partial,   ///< some of them had to stay, or the surface would have lost a vertex, its topology or its orientation
  extended   ///< it lies beyond the boundary, which now runs through it
};

/// A surface that has one more sample point as a vertex.
struct Inserted {
  MeshPtr mesh;
  Index vertex = no_index;
  Insertion how = Insertion::existing;
};

/// Makes S_conf + s_src surfaces (Section 2.4) from a reconstruction.
class GEODROME_VISIBLE PointInserter {
 public:
  virtual ~PointInserter() = default;

  /// The surface with sample point `sample` as a vertex; the reconstruction itself is not changed. Either its own mesh,
  /// or one whose vertices are those of it with the new one behind them, as manifold, oriented and closed as it. Faces
  /// should keep their index where they stay: what is known of them is then used again. Thread-safe.
  virtual Inserted with(Index sample) const = 0;
};

/// `sample_of_vertex`: the sample point of each vertex of `mesh`, no_index for a vertex that is none.
/// `inserter` is null where the reconstructor cannot insert.
struct Reconstruction {
  MeshPtr mesh;
  std::vector<Index> sample_of_vertex;
  std::vector<Finding> findings;
  std::unique_ptr<PointInserter> inserter;
};

/// Stage 4: a triangle mesh with the kept points as vertices (Section 2.3).
class GEODROME_VISIBLE SurfaceReconstructor {
 public:
  static constexpr const char* stage = "reconstructor";
  virtual ~SurfaceReconstructor() = default;

  /// `sample` holds the origins of `tangents`; `kept`: ascending indices into it. The mesh is a 2-manifold, closed or
  /// bordered, oriented; where none can be had SampleError gives the reasons: nothing wrong is returned quietly.
  /// Thread-safe.
  virtual Reconstruction reconstruct(const PointSample& sample, const Tangents& tangents, const Control& control,
                                     std::span<const Index> kept, RunContext& context) const = 0;
};

}  // namespace geodrome
