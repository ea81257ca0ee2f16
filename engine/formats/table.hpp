// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/formats/matrix_format.hpp"
#include "engine/formats/soup.hpp"
#include "geodrome/engine/formats.hpp"
#include "geodrome/surface.hpp"

namespace geodrome {

struct PathResult;

/// The evidence that the content of a file gives for a format. The strongest wins.
enum class Evidence {
  none,
  keyword,  ///< the file begins as the format says
  size,     ///< the file has just the size that its header announces
};

/// A content that a format can hold, with remarks for help texts; without a remark it is not read, or not written.
struct Use {
  Content content;
  std::optional<std::string_view> read = std::nullopt, written = std::nullopt;
};

/// The data that a writer turns into bytes: points, and of a mesh triangles too.
struct MeshToWrite {
  std::filesystem::path file;  ///< for messages
  std::span<const Vec3> positions;
  std::span<const Triangle> triangles;
  std::span<const double> weights;  ///< of the triangles; empty if there are none, or the format holds none
};

/// A format, stated once, beside its readers and writers. Functions are null where no use needs them.
struct Format {
  std::string_view name;                  ///< "PLY"
  std::vector<std::string_view> endings;  ///< lower case; the first one is that of files that are written
  std::vector<Use> uses;

  /// Returns the evidence that a file of a mesh or of points is of this format; null if the content never tells.
  Evidence (*evidence)(const input::SourceFile& file) = nullptr;
  /// Reads a mesh or points. Throws InputError, naming the line or element, for what is not of the format.
  input::Soup (*read)(const input::SourceFile& file) = nullptr;
  /// Reads a mesh, as `read` does, with the numbers of a property of the faces, which must be there if there are faces.
  input::Soup (*read_weighted)(const input::SourceFile& file, std::string_view property) = nullptr;
  /// Reads points, as `read` does, from the columns of a table (`input::parse_columns`).
  input::Soup (*read_columns)(const input::SourceFile& file, std::string_view columns) = nullptr;
  /// The bytes of a mesh or of points. Throws InputError (range) for numbers that the format cannot hold.
  std::string (*write)(const MeshToWrite& mesh) = nullptr;
  std::string (*write_path)(const PathResult& path) = nullptr;
  const MatrixFormat* matrix = nullptr;

  const Use* use(Content content) const;
  bool reads(Content content) const;
  bool writes(Content content) const;
};

/// All formats, in the order in which help texts name them.
std::span<const Format> formats();

/// The format of a file to be written, by its ending. Throws OptionError, naming the valid endings, for another one.
const Format& format_to_write(const std::filesystem::path& file, Content content);

/// The format of a mesh to be written, as `format_to_write`. Throws OptionError too if the mesh is `weighted` and the
/// format holds no weights.
const Format& mesh_format_to_write(const std::filesystem::path& file, bool weighted);

}  // namespace geodrome
