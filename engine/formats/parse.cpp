// SPDX-License-Identifier: MIT
#include <string_view>

#include "engine/formats/ending.hpp"
#include "engine/formats/gzip.hpp"
#include "engine/formats/table.hpp"
#include "engine/formats/text.hpp"

// The choice of a reader: by the content where that tells, else by the name.
namespace geodrome::input {
namespace {

void reject_compressed(const SourceFile& file) {
  struct Packing {
    std::string_view magic, name, remedy;
  };
  constexpr Packing packings[] = {
      {"\x1F\x8B", "gzip", "gunzip"},  // inside a gzip file
      {"BZh", "bzip2", "bunzip2"},    {"\xFD\x37zXZ", "xz", "unxz"},
      {"PK\x03\x04", "zip", "unzip"}, {"\x28\xB5\x2F\xFD", "zstd", "unzstd"},
  };
  for (const Packing& packing : packings)
    if (file.bytes.starts_with(packing.magic))
      reject(file, InputFault::syntax,
             std::string(file.unpacked ? "what it holds is " : "the file is ") + std::string(packing.name) +
                 "-compressed" + (file.unpacked ? " once more" : ""),
             "unpack it with " + std::string(packing.remedy));
}

const Format* format_by_content(const SourceFile& file) {
  const Format* best = nullptr;
  Evidence strongest = Evidence::none;
  for (const Format& format : formats()) {
    const Evidence found = format.evidence ? format.evidence(file) : Evidence::none;
    if (found > strongest) strongest = found, best = &format;
  }
  return best;
}

const Format* format_by_name(const SourceFile& file) {
  const std::filesystem::path name =
      file.unpacked && has_ending(file.path, gzip_ending) ? file.path.stem() : file.path.filename();
  const Format* best = nullptr;
  std::size_t longest = 0;
  for (const Format& format : formats()) {
    if (!format.read) continue;
    for (const std::string_view ending : format.endings)
      if (ending.size() > longest && has_ending(name, ending)) longest = ending.size(), best = &format;
  }
  return best;
}

/// The names of the formats that have a property, as "OFF, PLY".
template <class Property>
std::string names_of(Property property) {
  std::string names;
  for (const Format& format : formats())
    if (property(format)) append_word(names, std::string(format.name));
  return names;
}

void check_choice(const SourceFile& file, const Format& format, const ParseChoice& choice) {
  const auto names = [](auto property) { return names_of([&](const Format& f) { return f.*property != nullptr; }); };
  if (!choice.weight_property.empty() && !format.read_weighted)
    reject(
        file, InputFault::unsupported,
        "only faces of " + names(&Format::read_weighted) + " have properties such as " + quoted(choice.weight_property),
        "give the weights as a text file with one number a line for each face");
  if (!choice.columns.empty() && !format.read_columns)
    reject(file, InputFault::unsupported,
           "the file is " + std::string(format.name) + ", and only tables of points (" + names(&Format::read_columns) +
               ") have columns to choose",
           "leave the choice of columns out");
}

Soup read_as(const SourceFile& file, const Format& format, const ParseChoice& choice) {
  if (!choice.weight_property.empty()) return format.read_weighted(file, choice.weight_property);
  return choice.columns.empty() ? format.read(file) : format.read_columns(file, choice.columns);
}

}  // namespace

Soup parse(const SourceFile& file, const ParseChoice& choice) {
  reject_compressed(file);
  const Format *by_content = format_by_content(file), *by_name = format_by_name(file);
  if (!by_content && !by_name)
    reject(file, InputFault::unsupported, "neither content nor name tells the format",
           "use one of " + names_of([](const Format& f) { return f.read != nullptr; }) +
               ", and the ending of the format in the file's name");
  const Format& format = by_content ? *by_content : *by_name;
  check_choice(file, format, choice);
  Soup soup = read_as(file, format, choice);
  soup.format = lower_case(format.name);
  if (by_content && by_name && by_content != by_name)
    soup.findings.push_back({Finding::Severity::note,
                             "format_by_content",
                             "The content is " + soup.format + ", whatever the file's name says.",
                             1,
                             {}});
  return soup;
}

}  // namespace geodrome::input
