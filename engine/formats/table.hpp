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

/// How sure the content of a file is of a format. The strongest evidence wins.
enum class Evidence {
  none,
  keyword,  ///< the file begins as the format says
  size,     ///< the file has just the size that its header announces
};

/// What a format holds, with remarks for help texts; no remark: it is not read, or not written.
struct Use {
  Content content;
  std::optional<std::string_view> read = std::nullopt, written = std::nullopt;
};

/// What a writer turns into bytes: points, and of a mesh triangles too.
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

  /// Of a mesh or of points: what the content tells; null if it never tells.
  Evidence (*evidence)(const input::SourceFile& file) = nullptr;
  /// Reads a mesh or points. Throws InputError, naming the line or element, for what is not of the format.
  input::Soup (*read)(const input::SourceFile& file) = nullptr;
  /// The same with the numbers of a property of the faces, which must be there if there are faces.
  input::Soup (*read_weighted)(const input::SourceFile& file, std::string_view property) = nullptr;
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

/// The same for a mesh, which must be of a format that holds weights if it is `weighted`: OptionError otherwise.
const Format& mesh_format_to_write(const std::filesystem::path& file, bool weighted);

}  // namespace geodrome
