// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geodrome/finding.hpp"
#include "geodrome/geometry.hpp"
#include "geodrome/surface.hpp"

namespace geodrome {

enum class InputKind { points, mesh };

struct ReadOptions {
  std::optional<InputKind> as;  ///< default: a mesh if the file holds faces
  bool weld = false;            ///< merge vertices of a mesh at exactly the same place
  bool drop_nonfinite = false;  ///< drop points of a cloud that are not finite, instead of refusing
  /// Weights of the faces of a mesh: "property:NAME", a property of the faces of a PLY file, or the name of a text file
  /// with one number a line for each face of the file, in its order ('#' starts a comment); empty: all weigh 1. The
  /// length of a path is its length in each face times the face's weight; along an edge the lowest weight of its faces.
  std::string weights;
  /// The columns of x, y and z of a table of points (XYZ, CSV): three names, as "x,y,z", which the file must give above
  /// its points, or three numbers from 1, as "2,3,4"; empty: those named x, y and z, else the first three.
  std::string columns;
};

/// The file that the options name for weights; empty if they name none. Throws OptionError as `read_input`.
std::filesystem::path weights_file(const ReadOptions& options);

/// Counts of the input check, over the elements as used (after merging and dropping).
struct InputFacts {
  std::size_t rows = 0;  ///< vertices or points in the file (STL: after exact welding)
  std::size_t merged = 0, dropped = 0;
  std::size_t faces_in_file = 0, polygons_split = 0, degenerate_faces_dropped = 0;
  std::size_t zero_area_faces = 0;      ///< area at most 1e-14 times the longest edge squared
  std::size_t duplicate_faces = 0;      ///< faces that name the same vertices as an earlier one
  std::size_t duplicate_positions = 0;  ///< mesh vertices at the same place as an earlier one (not welded)
  std::size_t isolated_vertices = 0;
  std::size_t nonmanifold_edges = 0, nonmanifold_vertices = 0;
  std::size_t components = 0, boundary_edges = 0,
              boundary_loops = 0;                            ///< components: joined by vertices; isolated ones apart
  bool manifold = true, oriented = true, orientable = true;  ///< orientable: across the edges that have two faces
  std::optional<long> euler_number,
      genus;  ///< without isolated vertices; genus: summed over components, if manifold, orientable
  double bounding_box_diagonal = 0;
};

/// An input after reading and checking. Nothing is lost: every row of the file (or entry of the arrays) has an entry in
/// `element_of_row`.
struct Input {
  std::filesystem::path file;  ///< empty for an input from memory
  std::string format;          ///< "off", "obj", "ply", "stl", "xyz", "csv", "arrays"
  std::string hash;  ///< of the bytes of the file, unpacked, or arrays: 32 hexadecimal digits (XXH3, 128 bits)
  InputKind kind = InputKind::points;
  std::vector<Vec3> positions;          ///< the points or vertices used: finite; those of a cloud pairwise distinct
  std::vector<Index> element_of_row;    ///< row of the file -> entry of `positions`; no_index if dropped
  std::vector<Triangle> triangles;      ///< of a mesh: each with three different vertices
  std::vector<Index> face_of_triangle;  ///< triangle -> face in the file
  std::vector<double> weights;          ///< of a mesh: per triangle that of its face; empty if none are given
  std::string weights_from;             ///< as `ReadOptions::weights`
  std::string weights_hash;             ///< of the numbers in `weights`; empty if there are none
  std::vector<Finding> findings;        ///< warnings and notes, told to the user; nothing here stops the run
  InputFacts facts;
};

/// Reads OFF, OBJ, PLY (ascii, both endians), STL (ascii, binary), XYZ or CSV, also compressed by gzip, the format told
/// by the content where the content tells and by the name otherwise, and checks it. Polygons are split into triangles.
/// Throws InputError, naming file and element (line, vertex or face, from 0), for what cannot be used, weights that are
/// missing, not positive or not finite among it; OptionError for `options.weights` without a name and `options.columns`
/// that are not there. O(n log n).
Input read_input(const std::filesystem::path& file, const ReadOptions& options = {});

/// A mesh or points as a program has them in memory. `make_input` copies what it needs.
struct Arrays {
  std::span<const Vec3> positions;
  std::span<const Triangle> faces;  ///< corners as places in `positions`; empty: the input is points
  std::span<const double> weights;  ///< one for each face, as `ReadOptions::weights`; empty: all weigh 1
  std::span<const std::uint8_t> vertex_mask, face_mask;  ///< reserved: must be empty
};

/// The input from memory, after the same check as `read_input`; its rows are the entries of `positions`, its faces
/// those of `faces`. `file` is empty, `format` is "arrays". Throws InputError, naming the entry as "positions[17]" or
/// "faces[3]", for what cannot be used; OptionError if `options` name weights of a file; CapabilityError for a mask.
/// O(n log n).
Input make_input(const Arrays& arrays, const ReadOptions& options = {});

/// Writes OFF, OBJ, PLY (binary, double) or STL by the name's ending, so that reading gives the same numbers (STL:
/// float). Weights become the property "weight" of PLY. Throws InputError (io) if it cannot be written, OptionError for
/// an unknown ending, or one that cannot hold the weights that the mesh has.
void write_mesh(const std::filesystem::path& file, const SurfaceMesh& mesh);

/// Writes points as XYZ, PLY or OFF by the name's ending. Errors as `write_mesh`.
void write_points(const std::filesystem::path& file, const std::vector<Vec3>& points);

}  // namespace geodrome
