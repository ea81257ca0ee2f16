// SPDX-License-Identifier: MIT
#include "geodrome/engine/matrix_file.hpp"
#include "engine/formats/remedies.hpp"

#include <xxhash.h>

#include <atomic>
#include <optional>
#include <stdexcept>

#include "engine/formats/csv.hpp"
#include "engine/formats/npy.hpp"
#include "engine/output/float32_row.hpp"
#include "engine/output/partial_footer.hpp"
#include "engine/output/posix_file.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t most_csv_entries = 1'000'000;

fs::path with_suffix(fs::path path, const char* suffix) { return path += suffix; }

bool is_csv(const MatrixFile::Spec& spec) { return spec.out.extension() == ".csv"; }

void check_ending(const MatrixFile::Spec& spec) {
  if (!is_csv(spec) && spec.out.extension() != ".npy")
    throw OptionError("cannot write a matrix to " + spec.out.string(), "choose a name that ends in .npy or .csv");
  if (is_csv(spec) && spec.columns > 0 && spec.rows > most_csv_entries / spec.columns)
    throw OptionError(spec.out.string() + " would have more than " + std::to_string(most_csv_entries) + " entries",
                      "choose a name that ends in .npy");
}

[[noreturn]] void refuse_room(const MatrixFile::Spec& spec, std::uint64_t needed, std::uint64_t available) {
  throw RefusedError(spec.out.string() + " needs " + std::to_string(needed) + " bytes more on disk, of which " +
                         std::to_string(available) + " are available",
                     "make room, write elsewhere, ask for fewer sources or targets, or store float32");
}

std::uint64_t available_room(const fs::path& out) {
  std::error_code error;
  const fs::space_info room = fs::space(out.has_parent_path() ? out.parent_path() : ".", error);
  if (error)
    throw InputError(InputFault::io, "cannot write " + out.string() + ": " + error.message(), "check the path");
  return room.available;
}

/// Bytes that are still to be found on the disk, beside those that `file` has already.
std::uint64_t needed_room(const MatrixFile::Spec& spec, std::uint64_t allocated) {
  const std::uint64_t partial = partial_bytes(spec);
  const std::uint64_t text = is_csv(spec) ? spec.rows * spec.columns * csv_bytes_per_entry : 0;
  return (partial > allocated ? partial - allocated : 0) + text;
}

/// Opens and locks the partial. Another process may rename it between the two, when it is no longer ours to write.
PosixFile open_locked(const fs::path& partial) {
  for (;;) {
    PosixFile file(partial, false);
    if (!file.try_lock())
      throw RefusedError(partial.string() + " is being written by another run",
                         "wait for it, or choose another output");
    if (file.is_at_its_path()) return file;
  }
}

}  // namespace

struct MatrixFile::Impl {
  Impl(Spec wanted, PosixFile opened)
      : spec(std::move(wanted)),
        file(std::move(opened)),
        header(npy_header(spec.rows, spec.columns, spec.scalar)),
        row_bytes(spec.columns * bytes_of(spec.scalar)),
        checksums(new std::atomic<std::uint64_t>[spec.rows] {}) {}

  std::uint64_t row_offset(std::uint64_t row) const { return header.size() + row * row_bytes; }

  /// Never 0, which stands for "not there"; depends on the row, so that one row is not taken for another.
  static std::uint64_t checksum(std::uint64_t row, const void* data, std::size_t size) {
    const std::uint64_t value = XXH3_64bits_withSeed(data, size, row);
    return value == 0 ? 1 : value;
  }

  void start() {
    file.resize(0);
    const std::uint64_t size = partial_bytes(spec);
    file.resize(size);
    if (!file.reserve(size)) refuse_room(spec, needed_room(spec, file.allocated()), available_room(spec.out));
    write_footer(file, spec);
    file.write_at(0, header.data(), header.size());
  }

  /// Goes on with the partial of `stored`: a row counts as done if what is on the disk matches its checksum.
  void adopt(const Spec& stored) {
    if (const std::string text = differences(stored, spec); !text.empty())
      throw RefusedError(file.path().string() + " was started by a different run: " + text,
                         remedies::start_anew("restore the options"));
    if (!file.reserve(partial_bytes(spec)))
      refuse_room(spec, needed_room(spec, file.allocated()), available_room(spec.out));
    file.write_at(0, header.data(), header.size());
    std::vector<std::uint64_t> claimed(spec.rows);
    file.read_at(checksum_offset(spec, 0), claimed.data(), claimed.size() * sizeof(std::uint64_t));
    std::vector<char> row_data(row_bytes);
    for (std::uint64_t row = 0; row < spec.rows; ++row) {
      if (claimed[row] == 0) continue;
      file.read_at(row_offset(row), row_data.data(), row_data.size());
      if (checksum(row, row_data.data(), row_data.size()) != claimed[row]) continue;
      checksums[row] = claimed[row];
      ++done;
    }
  }

  /// A partial that is exactly the finished .npy and has no saved footer: nothing tells which run it is of.
  void refuse_if_without_footer() const {
    std::string begin(header.size(), '\0');
    if (file.size() != bytes(spec)) return;
    file.read_at(0, begin.data(), begin.size());
    if (begin == header)
      throw RefusedError(file.path().string() + " is a whole matrix, but nothing tells which run it is of",
                         remedies::start_anew("rename it to " + spec.out.string() + " if you know"));
  }

  /// The name is given last, so that OUT is whole whenever it is there. From the cut to the renaming the fingerprint
  /// and the checksums are in a file of their own, for a run that resumes after an end in between.
  void write_npy() const {
    save_footer(file, spec, saved_footer(spec));
    file.resize(bytes(spec));
    file.sync();
    rename_durably(file.path(), spec.out);
    std::error_code ignored;
    fs::remove(saved_footer(spec), ignored);
  }

  void write_csv() const {
    const fs::path temporary = text_file(spec);
    try {
      const PosixFile text_out(temporary, true);
      std::string text;
      std::uint64_t written = 0;
      for (std::uint64_t row = 0; row < spec.rows; ++row, text.clear()) {
        append_csv_row(text, read(row), spec.scalar);
        text_out.write_at(written, text.data(), text.size());
        written += text.size();
      }
      text_out.sync();
      rename_durably(temporary, spec.out);
    } catch (...) {
      std::error_code ignored;
      fs::remove(temporary, ignored);
      throw;
    }
    fs::remove(file.path());
  }

  std::vector<double> read(std::uint64_t row) const {
    const std::uint64_t expected = row < spec.rows ? checksums[row].load() : 0;
    if (expected == 0) throw std::out_of_range("matrix row " + std::to_string(row) + " is not there");
    const auto load = [&](auto values) {
      file.read_at(row_offset(row), values.data(), row_bytes);
      if (checksum(row, values.data(), row_bytes) != expected)
        throw InputError(InputFault::io, file.path().string() + ": row " + std::to_string(row) + " changed on disk",
                         remedies::go_on_after_repair());
      return std::vector<double>(values.begin(), values.end());
    };
    if (spec.scalar == ScalarType::float64) return load(std::vector<double>(spec.columns));
    return load(std::vector<float>(spec.columns));
  }

  static fs::path saved_footer(const Spec& spec) { return with_suffix(spec.out, ".partial-footer"); }
  static fs::path text_file(const Spec& spec) { return with_suffix(spec.out, ".partial-text"); }

  Spec spec;
  PosixFile file;
  std::string header;
  std::uint64_t row_bytes;
  std::unique_ptr<std::atomic<std::uint64_t>[]> checksums;  ///< per row; 0: not there
  std::atomic<std::uint64_t> done = 0;
  bool finished = false;
};

MatrixFile::MatrixFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
MatrixFile::MatrixFile(MatrixFile&&) noexcept = default;
MatrixFile& MatrixFile::operator=(MatrixFile&&) noexcept = default;
MatrixFile::~MatrixFile() = default;

std::uint64_t MatrixFile::bytes(const Spec& spec) {
  // Half of what an offset can express leaves room for the footer.
  constexpr std::uint64_t most = std::uint64_t{1} << 62;
  std::uint64_t size = 0;
  if (spec.rows > most / 64 || __builtin_mul_overflow(spec.rows, spec.columns, &size) ||
      __builtin_mul_overflow(size, bytes_of(spec.scalar), &size) || size > most)
    throw RefusedError(std::to_string(spec.rows) + " rows of " + std::to_string(spec.columns) +
                           " distances are more than a file can hold",
                       "ask for fewer sources or targets");
  return npy_header(spec.rows, spec.columns, spec.scalar).size() + size;
}

MatrixFile MatrixFile::open(const Spec& spec, bool resume) {
  check_ending(spec);
  const fs::path partial = with_suffix(spec.out, ".partial");
  const std::uint64_t available = available_room(spec.out);
  if (const std::uint64_t all = needed_room(spec, 0); all > available && !fs::exists(partial))
    refuse_room(spec, all, available);  // before anything is created

  PosixFile file = open_locked(partial);
  if (const std::uint64_t needed = needed_room(spec, file.allocated()); needed > available)
    refuse_room(spec, needed, available);
  auto impl = std::make_unique<Impl>(spec, std::move(file));
  fs::remove(Impl::text_file(spec));  // of a run that died while it wrote the text
  std::optional<Spec> stored;
  if (resume) {
    restore_footer(impl->file, Impl::saved_footer(spec));
    impl->refuse_if_without_footer();
    stored = read_footer(impl->file);
  }
  fs::remove(Impl::saved_footer(spec));
  if (stored) {
    impl->adopt(*stored);
    return MatrixFile(std::move(impl));
  }
  try {
    impl->start();
  } catch (...) {
    std::error_code ignored;
    fs::remove(partial, ignored);  // nothing of worth is in it
    throw;
  }
  return MatrixFile(std::move(impl));
}

bool MatrixFile::has(std::uint64_t row) const { return row < impl_->spec.rows && impl_->checksums[row].load() != 0; }

std::uint64_t MatrixFile::rows_done() const { return impl_->done.load(); }

void MatrixFile::write(std::uint64_t row, std::span<const double> values) {
  Impl& m = *impl_;
  if (m.finished || row >= m.spec.rows || values.size() != m.spec.columns)
    throw std::logic_error("MatrixFile::write: row " + std::to_string(row) + " with " + std::to_string(values.size()) +
                           " values does not belong into this matrix");
  std::vector<float> narrow;
  const void* data = values.data();
  if (m.spec.scalar == ScalarType::float32) {
    narrow.resize(values.size());
    round_to_float32(values, narrow, row, m.spec.out.string());
    data = narrow.data();
  }
  // The data first: a row whose checksum is on record is whole, or found out on resume.
  m.file.write_at(m.row_offset(row), data, m.row_bytes);
  const std::uint64_t checksum = Impl::checksum(row, data, m.row_bytes);
  m.file.write_at(checksum_offset(m.spec, row), &checksum, sizeof(checksum));
  if (m.checksums[row].exchange(checksum) == 0) ++m.done;
}

std::vector<double> MatrixFile::read(std::uint64_t row) const { return impl_->read(row); }

void MatrixFile::finish() {
  Impl& m = *impl_;
  if (m.done.load() != m.spec.rows) throw std::logic_error("MatrixFile::finish: rows are missing");
  m.file.sync();
  is_csv(m.spec) ? m.write_csv() : m.write_npy();
  m.finished = true;
}

}  // namespace geodrome
