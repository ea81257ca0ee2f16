// SPDX-License-Identifier: MIT
#include "geodrome/engine/matrix_file.hpp"

#include <stdexcept>

#include "engine/formats/table.hpp"
#include "engine/output/float32_row.hpp"
#include "engine/output/partial_footer.hpp"
#include "engine/output/partial_matrix.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {
namespace fs = std::filesystem;
namespace {

fs::path text_file_of(const fs::path& out) { return fs::path(out) += ".partial-text"; }

const MatrixFormat& format_of(const MatrixFile::Spec& spec) {
  return *format_to_write(spec.out, Content::matrix).matrix;
}

std::string dense_endings() {
  std::string endings;
  for (const Format& format : formats())
    if (format.writes(Content::matrix) && !format.matrix->text)
      endings += (endings.empty() ? "" : " or ") + std::string(format.endings.front());
  return endings;
}

void check_entries(const MatrixFile::Spec& spec, const TextFormat& text) {
  if (spec.columns > 0 && spec.rows > text.most_entries / spec.columns)
    throw OptionError(spec.out.string() + " would have more than " + std::to_string(text.most_entries) + " entries",
                      "choose a name that ends in " + dense_endings());
}

}  // namespace

struct MatrixFile::Impl {
  Impl(const Spec& spec, const MatrixFormat& format, bool resume)
      : format(format), partial(spec, format.dense, text_room(spec, format), resume) {
    remove_if_there(text_file_of(spec.out));  // of a run that died while it wrote the text
  }

  static std::uint64_t text_room(const Spec& spec, const MatrixFormat& format) {
    return format.text ? spec.rows * spec.columns * format.text->most_bytes_per_entry : 0;
  }

  std::vector<double> read(std::uint64_t row) const {
    const auto load = [&](auto values) {
      partial.read(row, values.data());
      return std::vector<double>(values.begin(), values.end());
    };
    const Spec& spec = partial.spec();
    if (spec.scalar == ScalarType::float64) return load(std::vector<double>(spec.columns));
    return load(std::vector<float>(spec.columns));
  }

  void write_text() const {
    const Spec& spec = partial.spec();
    const fs::path temporary = text_file_of(spec.out);
    try {
      const PosixFile out(temporary, true);
      std::string text;
      std::uint64_t written = 0;
      for (std::uint64_t row = 0; row < spec.rows; ++row, text.clear()) {
        format.text->append_row(text, read(row), spec.scalar);
        out.write_at(written, text.data(), text.size());
        written += text.size();
      }
      out.sync();
      rename_durably(temporary, spec.out);
    } catch (...) {
      std::error_code ignored;
      fs::remove(temporary, ignored);
      throw;
    }
    partial.remove();
  }

  const MatrixFormat& format;
  PartialMatrix partial;
  bool finished = false;
};

MatrixFile::MatrixFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
MatrixFile::MatrixFile(MatrixFile&&) noexcept = default;
MatrixFile& MatrixFile::operator=(MatrixFile&&) noexcept = default;
MatrixFile::~MatrixFile() = default;

std::uint64_t MatrixFile::bytes(const Spec& spec) { return layout_of(format_of(spec).dense, spec).footer(); }

MatrixFile MatrixFile::open(const Spec& spec, bool resume) {
  const MatrixFormat& format = format_of(spec);
  if (format.text) check_entries(spec, *format.text);
  return MatrixFile(std::make_unique<Impl>(spec, format, resume));
}

bool MatrixFile::has(std::uint64_t row) const { return impl_->partial.has(row); }

std::uint64_t MatrixFile::rows_done() const { return impl_->partial.rows_done(); }

void MatrixFile::write(std::uint64_t row, std::span<const double> values) {
  const Spec& spec = impl_->partial.spec();
  if (impl_->finished || row >= spec.rows || values.size() != spec.columns)
    throw std::logic_error("MatrixFile::write: row " + std::to_string(row) + " with " + std::to_string(values.size()) +
                           " values does not belong into this matrix");
  if (spec.scalar == ScalarType::float64) return impl_->partial.write(row, values.data());
  std::vector<float> single(values.size());
  round_to_float32(values, single, row, spec.out.string());
  impl_->partial.write(row, single.data());
}

std::vector<double> MatrixFile::read(std::uint64_t row) const { return impl_->read(row); }

void MatrixFile::finish() {
  Impl& m = *impl_;
  if (m.partial.rows_done() != m.partial.spec().rows) throw std::logic_error("MatrixFile::finish: rows are missing");
  m.partial.sync();
  m.format.text ? m.write_text() : m.partial.publish();
  m.finished = true;
}

}  // namespace geodrome
