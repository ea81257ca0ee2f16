// SPDX-License-Identifier: MIT
#include "engine/formats/npy_matrix.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <optional>

#include "engine/formats/matrix_format.hpp"
#include "engine/formats/source_file.hpp"

namespace geodrome {

static_assert(std::endian::native == std::endian::little, "entries are read as they lie in the file");

namespace {

constexpr std::string_view magic = "\x93NUMPY";
constexpr const char* remedy = "save a two-dimensional array of float64 or float32 with numpy.save";

/// More than any header holds, so that no memory is reserved on the word of a length.
constexpr std::uint32_t longest_header = 1 << 16;

void skip_blanks(std::string_view& text) {
  text.remove_prefix(std::min(text.size(), text.find_first_not_of(" \t\r\n")));
}

/// Goes behind `sign` and the blanks before it; false, without a step, if another sign stands there.
bool skip(std::string_view& text, char sign) {
  std::string_view rest = text;
  skip_blanks(rest);
  if (!rest.starts_with(sign)) return false;
  text = rest.substr(1);
  return true;
}

/// What stands in a header behind a key and its colon; empty if the key is not there.
std::string_view behind(std::string_view header, std::string_view key) {
  for (std::size_t at = header.find(key); at != header.npos; at = header.find(key)) {
    header.remove_prefix(at + key.size());
    if (std::string_view rest = header; skip(rest, ':')) {
      skip_blanks(rest);
      return rest;
    }
  }
  return {};
}

/// The two sizes of "(2, 3)"; none if it is no pair of numbers of 64 bits.
std::optional<std::array<std::uint64_t, 2>> sizes_of(std::string_view shape) {
  std::array<std::uint64_t, 2> sizes{};
  if (!skip(shape, '(')) return std::nullopt;
  for (std::uint64_t& size : sizes) {
    skip_blanks(shape);
    const auto [end, error] = std::from_chars(shape.data(), shape.data() + shape.size(), size);
    if (error != std::errc()) return std::nullopt;
    shape.remove_prefix(static_cast<std::size_t>(end - shape.data()));
    if (!skip(shape, ',') && &size != &sizes.back()) return std::nullopt;
  }
  if (!skip(shape, ')')) return std::nullopt;
  return sizes;
}

/// The little-endian number of `bytes` bytes at a place.
std::uint32_t number_at(std::string_view text, std::size_t place, unsigned bytes) {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < bytes; ++i) value |= static_cast<std::uint32_t>(text[place + i] & 0xff) << (8 * i);
  return value;
}

}  // namespace

void NpyMatrix::reject(InputFault fault, const std::string& what, const std::string& what_to_do) const {
  throw InputError(fault, file_.string() + ": " + what, what_to_do);
}

NpyMatrix::NpyMatrix(const std::filesystem::path& file) : file_(file), source_(file) {
  const std::uint64_t bytes = source_.size();
  std::string start(std::min<std::uint64_t>(bytes, magic.size() + 6 + longest_header), '\0');
  source_.read_at(0, start.data(), start.size());
  if (start.size() < magic.size() + 2 || !start.starts_with(magic))
    reject(InputFault::syntax, "is no .npy file", remedy);
  const int major = start[magic.size()], minor = start[magic.size() + 1];
  if (major < 1 || major > 3)
    reject(InputFault::unsupported, "is of .npy version " + std::to_string(major) + "." + std::to_string(minor),
           remedy);
  const unsigned length_bytes = major == 1 ? 2 : 4;
  const std::size_t header = magic.size() + 2 + length_bytes;
  const std::uint32_t length =
      start.size() < header ? longest_header + 1 : number_at(start, magic.size() + 2, length_bytes);
  if (length > longest_header) reject(InputFault::syntax, "its .npy header is damaged", remedy);
  if (start.size() < header + length) reject(InputFault::truncated, "ends within its .npy header", "write it again");
  parse(start.substr(header, length));
  first_byte_ = header + length;
  std::uint64_t entries = 0, taken = 0;
  if (__builtin_mul_overflow(rows_, columns_, &entries) || __builtin_mul_overflow(entries, bytes_of(scalar_), &taken) ||
      taken != bytes - first_byte_)
    reject(InputFault::truncated,
           "has " + std::to_string(bytes - first_byte_) + " bytes of entries, not those that its shape " +
               shape_text() + " takes",
           "write it again");
}

void NpyMatrix::parse(const std::string& header) {
  const std::string_view descr = behind(header, "'descr'"), order = behind(header, "'fortran_order'"),
                         rest = behind(header, "'shape'"), shape = rest.substr(0, rest.find(')') + 1);
  const bool fortran = order.starts_with("True");
  if ((!fortran && !order.starts_with("False")) || !shape.starts_with('('))
    reject(InputFault::syntax, "its .npy header is damaged", remedy);
  const std::string_view type = descr.starts_with('\'') ? descr.substr(1, descr.find('\'', 1) - 1) : "";
  if (type != "<f8" && type != "<f4")
    reject(InputFault::unsupported,
           "its entries are " + (type.empty() ? "of a compound type" : input::quoted(type)) + ", not '<f8' or '<f4'",
           remedy);
  if (fortran) reject(InputFault::unsupported, "is in Fortran order", "save numpy.ascontiguousarray(it)");
  const auto sizes = sizes_of(shape);
  if (!sizes) reject(InputFault::unsupported, "has shape " + input::printable(shape) + ", which is no matrix", remedy);
  rows_ = (*sizes)[0], columns_ = (*sizes)[1];
  scalar_ = type == "<f8" ? ScalarType::float64 : ScalarType::float32;
}

std::string NpyMatrix::shape_text() const {
  return "(" + std::to_string(rows_) + ", " + std::to_string(columns_) + ")";
}

std::vector<double> NpyMatrix::read(std::uint64_t row) const {
  std::vector<double> values(columns_);
  const std::uint64_t row_bytes = columns_ * bytes_of(scalar_), place = first_byte_ + row * row_bytes;
  if (scalar_ == ScalarType::float64) {
    source_.read_at(place, reinterpret_cast<char*>(values.data()), row_bytes);
  } else {
    std::vector<float> single(columns_);
    source_.read_at(place, reinterpret_cast<char*>(single.data()), row_bytes);
    values.assign(single.begin(), single.end());
  }
  source_.demand_unchanged();
  return values;
}

}  // namespace geodrome
