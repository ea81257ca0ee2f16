// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/output/dense_layout.hpp"
#include "engine/output/posix_file.hpp"
#include "geodrome/engine/matrix_file.hpp"

/// The footer of a matrix file that is not finished, behind the rows of the dense file:
///
///     8 bytes a row   checksum of the row; 0: the row is not there
///     fingerprint     text
///     padding         zeros, up to a multiple of 64 bytes
///     trailer         64 bytes: magic, version, shape, scalar, length of the fingerprint, checksums
///
/// The trailer stands at the end, so that a partial of another shape can be understood too. It is written last and lies
/// within one page: it is there as a whole or not at all, whenever the process dies.
namespace geodrome {

/// Where everything stands in the partial file of `spec`. Throws RefusedError as DenseLayout.
DenseLayout layout_of(const DenseFormat& format, const MatrixFile::Spec& spec);

/// Writes fingerprint and trailer into a file of `layout.end()` zeros and waits until they are on the disk.
void write_footer(const PosixFile& file, const MatrixFile::Spec& spec, const DenseLayout& layout);

/// The spec (without `out`) that a partial was started with. Nothing if its writer died before it had written the
/// trailer, and therefore any row. Throws RefusedError, naming the file, if it is damaged or no partial.
std::optional<MatrixFile::Spec> read_footer(const PosixFile& file, const DenseFormat& format);

/// Copies the footer of a partial into a file of its own. To be done before it is cut off.
void save_footer(const PosixFile& file, const DenseLayout& layout, const std::filesystem::path& to);

/// Puts a saved footer back at its place behind the matrix, if `from` is one, whole, and `file` is the matrix that it
/// was saved from as far as its size and header tell: without the footer, or with some of it. Otherwise does nothing.
/// Whether the rows are those of the footer is for their checksums to tell.
void restore_footer(const PosixFile& file, const DenseFormat& format, const std::filesystem::path& from);

/// In which respects two specs differ, each with both values shortened to 60 characters: "/seed was 1 and is 2". Empty
/// if they do not. The fingerprints are compared member by member if both are JSON, else as text.
std::string differences(const MatrixFile::Spec& stored, const MatrixFile::Spec& now);

}  // namespace geodrome
