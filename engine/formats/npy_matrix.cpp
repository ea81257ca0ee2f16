// SPDX-License-Identifier: MIT
#include "engine/formats/npy_matrix.hpp"

#include <bit>
#include <charconv>
#include <optional>
#include <regex>

#include "engine/formats/matrix_format.hpp"
#include "engine/formats/source_file.hpp"

namespace geodrome {

static_assert(std::endian::native == std::endian::little, "entries are read as they lie in the file");

namespace {

constexpr std::string_view magic = "\x93NUMPY";
constexpr const char* remedy = "save a two-dimensional array of float64 or float32 with numpy.save";

/// More than any header holds, so that no memory is reserved on the word of a length.
constexpr std::uint32_t longest_header = 1 << 16;

/// A dimension; none if it is no number of 64 bits.
std::optional<std::uint64_t> to_size(const std::string& digits) {
  std::uint64_t size = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), size);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return size;
}

/// The value that a header gives for a key, by a pattern with one group.
std::string value_of(const std::string& header, const char* pattern) {
  std::smatch match;
  return std::regex_search(header, match, std::regex(pattern)) ? match[1].str() : "";
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
  const std::string type = value_of(header, R"('descr'\s*:\s*'([^']*)')"),
                    order = value_of(header, R"('fortran_order'\s*:\s*(True|False))"),
                    shape = value_of(header, R"('shape'\s*:\s*(\([^)]*\)))");
  if (order.empty() || shape.empty()) reject(InputFault::syntax, "its .npy header is damaged", remedy);
  if (type != "<f8" && type != "<f4")
    reject(InputFault::unsupported,
           "its entries are " + (type.empty() ? "of a compound type" : input::quoted(type)) + ", not '<f8' or '<f4'",
           remedy);
  if (order == "True") reject(InputFault::unsupported, "is in Fortran order", "save numpy.ascontiguousarray(it)");
  std::smatch sizes;
  const bool is_matrix = std::regex_match(shape, sizes, std::regex(R"(\(\s*(\d+)\s*,\s*(\d+)\s*,?\s*\))"));
  const auto rows = is_matrix ? to_size(sizes[1]) : std::nullopt, columns = is_matrix ? to_size(sizes[2]) : rows;
  if (!rows || !columns) reject(InputFault::unsupported, "has shape " + shape + ", which is no matrix", remedy);
  rows_ = *rows, columns_ = *columns;
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
