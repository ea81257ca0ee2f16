// SPDX-License-Identifier: MIT
#include "engine/output/partial_footer.hpp"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "engine/formats/remedies.hpp"
#include "engine/formats/text.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "matrix files are written in the machine's own byte order");

constexpr std::array<char, 8> magic = {'G', 'E', 'O', 'D', 'R', 'O', 'M', 'E'};
constexpr std::uint32_t footer_version = 1;
constexpr int most_differences = 8;  // that a message tells

struct Trailer {
  std::array<char, 8> magic;
  std::uint32_t version, scalar_bytes;
  std::uint64_t rows, columns, fingerprint_bytes, fingerprint_checksum;
  std::uint64_t checksum;  ///< of all that stands before it
  std::uint64_t reserved;
};
static_assert(sizeof(Trailer) == DenseLayout::trailer_bytes);

std::uint64_t checksum_of(const Trailer& trailer) { return XXH3_64bits(&trailer, offsetof(Trailer, checksum)); }

/// The spec of a trailer, its fingerprint only as long as it is to be; nothing if those bytes are no whole trailer.
std::optional<MatrixFile::Spec> spec_of(const std::array<char, sizeof(Trailer)>& bytes, std::uint64_t file_size) {
  const auto trailer = std::bit_cast<Trailer>(bytes);
  if (trailer.magic != magic || trailer.version != footer_version || trailer.checksum != checksum_of(trailer) ||
      trailer.fingerprint_bytes > file_size || (trailer.scalar_bytes != 8 && trailer.scalar_bytes != 4))
    return std::nullopt;
  MatrixFile::Spec spec;
  spec.rows = trailer.rows, spec.columns = trailer.columns;
  spec.scalar = trailer.scalar_bytes == 8 ? ScalarType::float64 : ScalarType::float32;
  spec.fingerprint.resize(trailer.fingerprint_bytes);
  return spec;
}

/// Nothing where no file can hold a matrix of that shape.
std::optional<DenseLayout> possible_layout(const DenseFormat& format, const MatrixFile::Spec& spec) {
  try {
    return layout_of(format, spec);
  } catch (const RefusedError&) {
    return std::nullopt;
  }
}

[[noreturn]] void refuse_damaged(const PosixFile& file) {
  throw RefusedError(file.path().string() + " is damaged, or no unfinished matrix", remedies::start_anew("remove it"));
}

/// Fit to show, whatever the file holds.
std::string shortened(std::string text) {
  constexpr std::size_t limit = 60;
  if (text.size() > limit) text = text.substr(0, limit - 3) + "...";
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '?';
  return text;
}

void add_difference(std::string& text, const std::string& what, const std::string& was, const std::string& is) {
  append_word(text, shortened(what) + " was " + shortened(was) + " and is " + shortened(is));
}

/// A fingerprint as JSON. Null if it is none or nests deeper than any that is written: members are compared by
/// recursion.
json parsed(const std::string& fingerprint) {
  constexpr int deepest = 20;
  bool too_deep = false;
  const auto watch = [&](int depth, json::parse_event_t, json&) {
    too_deep |= depth > deepest;
    return !too_deep;
  };
  const json value = json::parse(fingerprint, watch, false);
  return too_deep ? json() : value;
}

std::string fingerprint_differences(const std::string& stored, const std::string& now) {
  const json a = parsed(stored), b = parsed(now);
  std::string text;
  if (!a.is_object() || !b.is_object()) {
    add_difference(text, "the fingerprint", stored, now);
    return text;
  }
  const json was = a.flatten(), is = b.flatten();
  std::set<std::string> members;
  for (const auto& item : was.items()) members.insert(item.key());
  for (const auto& item : is.items()) members.insert(item.key());
  const auto shown = [](const json& values, const std::string& member) {
    return values.contains(member) ? values[member].dump(-1, ' ', false, json::error_handler_t::replace) : "absent";
  };
  int told = 0;
  for (const std::string& member : members) {
    if (shown(was, member) == shown(is, member)) continue;
    if (told++ == most_differences) return text + ", ...";
    add_difference(text, member, shown(was, member), shown(is, member));
  }
  return text;
}

}  // namespace

DenseLayout layout_of(const DenseFormat& format, const MatrixFile::Spec& spec) {
  return {format, {spec.rows, spec.columns, spec.scalar}, spec.fingerprint.size()};
}

void write_footer(const PosixFile& file, const MatrixFile::Spec& spec, const DenseLayout& layout) {
  const std::string& fingerprint = spec.fingerprint;
  file.write_at(layout.fingerprint(), fingerprint.data(), fingerprint.size());
  Trailer trailer{magic,
                  footer_version,
                  static_cast<std::uint32_t>(bytes_of(spec.scalar)),
                  spec.rows,
                  spec.columns,
                  fingerprint.size(),
                  XXH3_64bits(fingerprint.data(), fingerprint.size()),
                  0,
                  0};
  trailer.checksum = checksum_of(trailer);
  file.write_at(layout.trailer(), &trailer, sizeof(Trailer));
  file.sync();
}

std::optional<MatrixFile::Spec> read_footer(const PosixFile& file, const DenseFormat& format) {
  const std::uint64_t size = file.size();
  if (size == 0) return std::nullopt;
  if (size < 2 * sizeof(Trailer)) refuse_damaged(file);
  std::array<char, sizeof(Trailer)> first, last;
  file.read_at(0, first.data(), first.size());
  file.read_at(size - last.size(), last.data(), last.size());
  const auto zero = [](char byte) { return byte == 0; };
  // The header is written after the trailer, so a file that has neither was given up before the first row.
  if (std::ranges::all_of(first, zero) && std::ranges::all_of(last, zero)) return std::nullopt;

  std::optional<MatrixFile::Spec> spec = spec_of(last, size);
  if (!spec) refuse_damaged(file);
  const std::optional<DenseLayout> layout = possible_layout(format, *spec);
  if (!layout || layout->end() != size) refuse_damaged(file);
  std::string& fingerprint = spec->fingerprint;
  file.read_at(layout->fingerprint(), fingerprint.data(), fingerprint.size());
  if (XXH3_64bits(fingerprint.data(), fingerprint.size()) != std::bit_cast<Trailer>(last).fingerprint_checksum)
    refuse_damaged(file);
  return spec;
}

void save_footer(const PosixFile& file, const DenseLayout& layout, const std::filesystem::path& to) {
  std::vector<char> footer(layout.end() - layout.footer());
  file.read_at(layout.footer(), footer.data(), footer.size());
  const PosixFile saved(to, true);
  saved.write_at(0, footer.data(), footer.size());
  saved.sync();
}

void restore_footer(const PosixFile& file, const DenseFormat& format, const std::filesystem::path& from) {
  if (!file_exists(from)) return;
  const PosixFile saved(from, false);
  std::vector<char> footer(saved.size());
  std::array<char, sizeof(Trailer)> last;
  if (footer.size() < last.size()) return;
  saved.read_at(0, footer.data(), footer.size());
  std::copy(footer.end() - last.size(), footer.end(), last.begin());
  const std::optional<MatrixFile::Spec> spec = spec_of(last, footer.size());
  if (!spec) return;
  const std::optional<DenseLayout> layout = possible_layout(format, *spec);
  if (!layout) return;
  const std::uint64_t begin = layout->footer(), end = layout->end();
  if (footer.size() != end - begin || file.size() < begin || file.size() > end) return;
  std::string header(layout->header().size(), '\0');
  file.read_at(0, header.data(), header.size());
  if (header != layout->header()) return;  // the footer of another shape would be written over rows
  file.write_at(begin, footer.data(), footer.size());
  file.sync();
}

std::string differences(const MatrixFile::Spec& stored, const MatrixFile::Spec& now) {
  std::string text;
  if (stored.fingerprint != now.fingerprint) text = fingerprint_differences(stored.fingerprint, now.fingerprint);
  const auto compare = [&](const char* what, std::uint64_t was, std::uint64_t is) {
    if (was != is) add_difference(text, what, std::to_string(was), std::to_string(is));
  };
  compare("the number of rows", stored.rows, now.rows);
  compare("the number of columns", stored.columns, now.columns);
  compare("the bytes of an entry", bytes_of(stored.scalar), bytes_of(now.scalar));
  return text;
}

}  // namespace geodrome
