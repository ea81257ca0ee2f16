// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

#include "engine/formats/bytes.hpp"
#include "engine/formats/line_reader.hpp"
#include "engine/formats/ply_header.hpp"
#include "engine/formats/ply_reader.hpp"
#include "engine/formats/ply_strips.hpp"
#include "engine/formats/remedies.hpp"
#include "engine/formats/row_lines.hpp"

namespace geodrome::input {
namespace {

// The two sources of values, text and binary, look the same to the loops below. Text is a stream of numbers: rows may
// lie on lines in any way, but must then come out exactly.
class TextValues {
 public:
  TextValues(const SourceFile& file, const PlyHeader& header)
      : file_(file), lines_(file, {.across = true}, header.body_offset, header.lines) {}

  void start_row(const PlyElement& element, std::uint64_t row) {
    if (!lines_.seek())
      reject(file_, InputFault::truncated,
             "the file ends after " + std::to_string(row) + " of " + std::to_string(element.count) + " rows of '" +
                 element.name + "'");
    rows_.begin(lines_);
  }
  void end_row() { rows_.end(lines_); }
  double number(PlyType) { return lines_.number(); }
  long long integer(PlyType) { return lines_.integer(); }
  void skip(PlyType) { lines_.unused_number(); }

  /// What failed in a stream whose rows are torn is no fault of the place where it failed.
  void rethrow_if_torn() const {
    if (rows_.torn() != 0) reject_line(rows_.torn());
  }
  void finish(Soup& soup) {
    if (lines_.seek() && rows_.shared() != 0) reject_line(rows_.shared());
    if (!lines_.at_line_end()) note_trailing_data(soup);
    if (rows_.torn() != 0)
      soup.findings.push_back({Finding::Severity::warning,
                               "rows_across_lines",
                               "Rows begin and end within lines, the first in line " + std::to_string(rows_.torn()) +
                                   "; the numbers were read one after the other.",
                               1,
                               {}});
  }

 private:
  [[noreturn]] void reject_line(std::size_t line) const {
    reject(file_, InputFault::syntax,
           "line " + std::to_string(line) +
               ": a row begins here that shares its line with another, and the numbers do not come out as the header "
               "announces: there are too many or too few in this line or before it");
  }

  const SourceFile& file_;
  LineReader lines_;
  RowLines rows_;
};

class BinaryValues {
 public:
  BinaryValues(const SourceFile& file, const PlyHeader& header)
      : file_(file),
        order_(header.encoding == PlyEncoding::big_endian ? std::endian::big : std::endian::little),
        at_(file.bytes.data() + header.body_offset),
        end_(file.bytes.data() + file.bytes.size()) {}

  void start_row(const PlyElement& element, std::uint64_t row) { element_ = &element, row_ = row; }
  void end_row() {}
  double number(PlyType type) {
    if (type == PlyType::float64) return value<double>();
    return type == PlyType::float32 ? value<float>() : static_cast<double>(integer(type));
  }
  long long integer(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return value<std::int8_t>();
      case PlyType::uint8:
        return value<std::uint8_t>();
      case PlyType::int16:
        return value<std::int16_t>();
      case PlyType::uint16:
        return value<std::uint16_t>();
      case PlyType::int32:
        return value<std::int32_t>();
      default:
        return value<std::uint32_t>();
    }
  }
  void skip(PlyType type) { number(type); }
  void rethrow_if_torn() const {}
  void finish(Soup& soup) const {
    if (at_ != end_) note_trailing_data(soup);
  }

 private:
  template <class Number>
  Number value() {
    if (static_cast<std::size_t>(end_ - at_) < sizeof(Number))
      reject(file_, InputFault::truncated,
             "the file ends inside row " + std::to_string(row_) + " of '" + element_->name + "', of " +
                 std::to_string(element_->count));
    const Number number = load<Number>(at_, order_);
    at_ += sizeof(Number);
    return number;
  }

  const SourceFile& file_;
  std::endian order_;
  const char *at_, *end_;
  const PlyElement* element_ = nullptr;
  std::uint64_t row_ = 0;
};

template <class Values>
void read_list(const SourceFile& file, const PlyHeader& header, const PlyProperty& property, std::uint64_t row,
               Values& values, Soup& soup) {
  const long long length = values.integer(*property.count_type);
  if (length < 0)
    reject(file, InputFault::syntax,
           "the list '" + property.name + "' of row " + std::to_string(row) + " has a negative length");
  std::optional<StripReader> strip;
  if (property.role == PlyRole::strip) strip.emplace(file, row, header.vertex_count, soup);
  for (long long i = 0; i < length; ++i) {
    if (property.role == PlyRole::corners)
      soup.corners.push_back(
          checked_corner(file, soup.face_count(), values.integer(property.type), header.vertex_count));
    else if (strip)
      strip->add(values.integer(property.type));
    else
      values.skip(property.type);
  }
  if (strip) strip->end_run();
}

bool has_weight(const PlyElement& element) {
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [](const PlyProperty& property) { return property.role == PlyRole::weight; });
}

bool is_called_weight(std::string name) {
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return name.find("weight") != name.npos;
}

/// Nobody should believe that weights were used because they are there.
void note_unused_weights(const PlyHeader& header, Soup& soup) {
  for (const PlyElement& element : header.elements)
    for (const PlyProperty& property : element.properties)
      if (element.name == "face" && !property.count_type && property.role == PlyRole::unused &&
          is_called_weight(property.name))
        soup.findings.push_back({Finding::Severity::note,
                                 "weights_not_used",
                                 "The faces have a property '" + property.name + "', which was not used.",
                                 element.count,
                                 {},
                                 remedies::use_weights(property.name)});
}

template <class Values>
void read_rows(const SourceFile& file, const PlyHeader& header, const PlyElement& element, Values& values, Soup& soup) {
  const bool weighted = has_weight(element);
  for (std::uint64_t row = 0; row < element.count; ++row) {
    values.start_row(element, row);
    double number[ply_role_count];
    for (const PlyProperty& property : element.properties) {
      if (property.count_type)
        read_list(file, header, property, row, values, soup);
      else if (property.role == PlyRole::unused)
        values.skip(property.type);
      else
        number[static_cast<std::size_t>(property.role)] = values.number(property.type);
    }
    values.end_row();
    if (element.name == "vertex") soup.positions.push_back({number[0], number[1], number[2]});
    if (element.name == "face") soup.face_end.push_back(soup.corners.size());
    if (weighted) soup.face_weights.push_back(number[static_cast<std::size_t>(PlyRole::weight)]);
  }
}

template <class Values>
void read_elements(const SourceFile& file, const PlyHeader& header, Values& values, Soup& soup) {
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;  // its rows take no bytes, however many there are
    if (element.name == "vertex") soup.positions.reserve(element.count);
    if (element.name == "face") soup.face_end.reserve(element.count);
    read_rows(file, header, element, values, soup);
  }
}

template <class Values>
Soup read_body(const SourceFile& file, const PlyHeader& header) {
  Soup soup;
  Values values(file, header);
  try {
    read_elements(file, header, values, soup);
  } catch (const InputError&) {
    values.rethrow_if_torn();
    throw;
  }
  values.finish(soup);
  return soup;
}

}  // namespace

Soup read_ply(const SourceFile& file, std::string_view weight_property) {
  const PlyHeader header = read_ply_header(file, weight_property);
  Soup soup = header.encoding == PlyEncoding::ascii ? read_body<TextValues>(file, header)
                                                    : read_body<BinaryValues>(file, header);
  note_unused_weights(header, soup);
  return soup;
}

}  // namespace geodrome::input
