// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstring>

#include "engine/formats/bytes.hpp"
#include "engine/formats/line_reader.hpp"
#include "engine/formats/ply_header.hpp"
#include "engine/formats/ply_reader.hpp"
#include "engine/formats/remedies.hpp"

namespace geodrome::input {
namespace {

// The two sources of values, text and binary, look the same to the loops below.
class TextValues {
 public:
  TextValues(const SourceFile& file, const PlyHeader& header)
      : file_(file), lines_(file, {}, header.body_offset, header.lines) {}

  void start_row(const PlyElement& element, std::uint64_t row) {
    if (!lines_.next())
      reject(file_, InputFault::truncated,
             "the file ends after " + std::to_string(row) + " of " + std::to_string(element.count) + " rows of " +
                 input::quoted(element.name));
  }
  void end_row() {
    if (!lines_.word().empty()) lines_.reject(InputFault::syntax, "the line has more values than the header announces");
  }
  double number(PlyType) { return lines_.number(); }
  long long integer(PlyType) { return lines_.integer(); }
  bool at_end() { return lines_.is_last(); }

 private:
  const SourceFile& file_;
  LineReader lines_;
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
  bool at_end() const { return at_ == end_; }

 private:
  template <class Number>
  Number value() {
    if (static_cast<std::size_t>(end_ - at_) < sizeof(Number))
      reject(file_, InputFault::truncated,
             "the file ends inside row " + std::to_string(row_) + " of " + input::quoted(element_->name) + ", of " +
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
void read_list(const SourceFile& file, const PlyHeader& header, const PlyProperty& property, Values& values,
               Soup& soup) {
  const long long length = values.integer(*property.count_type);
  if (length < 0)
    reject(file, InputFault::syntax,
           "the list " + input::quoted(property.name) + " of face " + std::to_string(soup.face_count()) +
               " has a negative length");
  for (long long i = 0; i < length; ++i) {
    if (property.role == PlyRole::corners)
      soup.corners.push_back(
          checked_corner(file, soup.face_count(), values.integer(property.type), header.vertex_count));
    else
      values.number(property.type);
  }
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
                                 "The faces have a property " + input::quoted(property.name) + ", which was not used.",
                                 element.count,
                                 {},
                                 remedies::use_weights(printable(property.name))});
}

template <class Values>
void read_rows(const SourceFile& file, const PlyHeader& header, const PlyElement& element, Values& values, Soup& soup) {
  const bool weighted = has_weight(element);
  for (std::uint64_t row = 0; row < element.count; ++row) {
    values.start_row(element, row);
    double number[ply_role_count];
    for (const PlyProperty& property : element.properties) {
      if (property.count_type)
        read_list(file, header, property, values, soup);
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
Soup read_body(const SourceFile& file, const PlyHeader& header) {
  Soup soup;
  Values values(file, header);
  for (const PlyElement& element : header.elements) {
    if (element.properties.empty()) continue;  // its rows take no bytes, however many there are
    if (element.name == "vertex") soup.positions.reserve(element.count);
    if (element.name == "face") soup.face_end.reserve(element.count);
    read_rows(file, header, element, values, soup);
  }
  if (!values.at_end()) note_trailing_data(soup);
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
