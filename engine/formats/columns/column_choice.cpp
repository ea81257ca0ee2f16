// SPDX-License-Identifier: MIT
#include "engine/formats/columns/column_choice.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "engine/formats/columns/table_row.hpp"
#include "engine/formats/ending.hpp"
#include "engine/formats/remedies.hpp"
#include "engine/formats/text.hpp"

namespace geodrome::input {
namespace {

std::vector<std::string> words_of(std::string_view text, Separator separator) {
  std::vector<std::string_view> fields;
  split_row(text, separator, fields);
  std::vector<std::string> words;
  for (const std::string_view field : fields) words.emplace_back(unquoted(field));
  return words;
}

/// The place of a name, whatever its case; none if it is not there, or not once.
std::optional<std::size_t> place_of(std::string_view name, const std::vector<std::string>& names) {
  const auto same = [&](const std::string& other) { return lower_case(other) == lower_case(name); };
  const auto found = std::ranges::find_if(names, same);
  if (found == names.end() || std::ranges::count_if(names, same) > 1) return std::nullopt;
  return found - names.begin();
}

std::optional<Columns> named_axes(const std::vector<std::string>& names) {
  const auto x = place_of("x", names), y = place_of("y", names), z = place_of("z", names);
  if (!x || !y || !z) return std::nullopt;
  return Columns{*x, *y, *z};
}

std::string first_names(const std::vector<std::string>& names) {
  constexpr std::size_t shown = 3;
  std::string list;
  for (std::size_t i = 0; i < std::min(shown, names.size()); ++i) append_word(list, quoted(std::string_view(names[i])));
  return list + (names.size() > shown ? ", ..." : "");
}

}  // namespace

std::vector<std::string> parse_columns(std::string_view text) {
  const std::vector<std::string> columns = text.empty() ? std::vector<std::string>{} : words_of(text, Separator::comma);
  const bool differ =
      columns.size() == 3 && columns[0] != columns[1] && columns[1] != columns[2] && columns[2] != columns[0];
  if (text.empty() || (differ && std::ranges::none_of(columns, &std::string::empty))) return columns;
  throw OptionError(quoted(text) + " does not name three different columns",
                    "name those of x, y and z, by names or by numbers from 1, as x,y,z or 2,3,4");
}

std::vector<std::string> NameLine::names(std::size_t columns) const {
  const Separator usual = separator_of(text);
  std::vector<std::string> names = words_of(text, usual);
  if (names.size() == columns + 1 && names.back().empty()) names.pop_back();
  if (names.size() == columns || usual != Separator::blanks) return names;
  const std::vector<std::string> by_tabs = words_of(text, Separator::tab);
  return by_tabs.size() == columns ? by_tabs : names;
}

std::size_t ColumnChoice::chosen_column(const std::string& wanted, std::size_t count) const {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
  if (error == std::errc() && end == wanted.data() + wanted.size()) {
    if (number >= 1 && number <= count) return number - 1;
    throw OptionError(
        file_.path.string() + ": there is no column " + wanted + ": the lines have " + std::to_string(count),
        "count columns from 1");
  }
  std::string known;
  for (const NameLine& line : lines_) {
    const std::vector<std::string> names = line.names(count);
    if (names.size() != count) continue;
    if (std::ranges::count(names, wanted) == 1) return std::ranges::find(names, wanted) - names.begin();
    if (const auto place = place_of(wanted, names)) return *place;
    known = ", whose columns are " + first_names(names);
  }
  throw OptionError(
      file_.path.string() + ": names no column " + input::quoted(wanted) + (known.empty() ? "" : " once" + known),
      "choose columns by their numbers, from 1");
}

Columns ColumnChoice::chosen(std::size_t count) const {
  Columns columns{};
  for (std::size_t i = 0; i < 3; ++i) columns[i] = chosen_column(wanted_[i], count);
  if (columns[0] == columns[1] || columns[1] == columns[2] || columns[2] == columns[0])
    throw OptionError(file_.path.string() + ": one column is chosen for two of x, y and z");
  return columns;
}

/// Rejects a line of names that are not those of the columns, or do not tell x, y and z.
void ColumnChoice::check_names(const NameLine& line, std::size_t count) const {
  const std::vector<std::string> names = line.names(count);
  const std::string place = "line " + std::to_string(line.line) + " names ";
  const bool unnamed_first = names.size() + 1 == count;  // the names of rows, as R writes them
  if (names.size() != count)
    reject(file_, InputFault::syntax,
           place + counted(names.size(), "column", "columns") + " (" + first_names(names) + "), the points have " +
               std::to_string(count),
           remedies::choose_columns(unnamed_first ? "2,3,4" : "1,2,3"));
  if (!named_axes(names))
    reject(file_, InputFault::unsupported,
           place + "the columns " + first_names(names) + ", and not x, y and z once each",
           remedies::choose_columns("1,2,3"));
}

/// A comment that seems to speak of columns, but not of as many as there are.
void ColumnChoice::tell_doubt(std::size_t count, std::vector<Finding>& findings) const {
  for (const NameLine& line : lines_) {
    const std::vector<std::string> names = line.names(count);
    const auto places = named_axes(names);
    if (!places || *places == Columns{0, 1, 2}) continue;
    const std::string what = "the comment in line " + std::to_string(line.line) + " names " +
                             std::to_string(names.size()) + " columns (" + first_names(names) + "), the points have " +
                             std::to_string(count);
    if (std::ranges::max(*places) == 2) reject(file_, InputFault::syntax, what, remedies::choose_columns("1,2,3"));
    findings.push_back({Finding::Severity::warning,
                        "column_names_not_used",
                        "The first three columns were taken: " + what + ".",
                        1,
                        {},
                        remedies::choose_columns("1,2,3")});
  }
}

Columns ColumnChoice::choose(std::size_t count, std::vector<Finding>& findings) {
  Columns columns{0, 1, 2};
  made_ = true;
  if (!wanted_.empty()) {
    columns = chosen(count);
  } else {
    std::optional<Columns> named;
    for (const NameLine& line : lines_) {
      if (!line.is_comment) check_names(line, count);
      const std::vector<std::string> names = line.names(count);
      if (const auto places = named_axes(names); places && names.size() == count) named = places;
    }
    made_ = named.has_value();
    if (!made_) tell_doubt(count, findings);
    columns = named.value_or(columns);
  }
  if (columns != Columns{0, 1, 2})
    findings.push_back({Finding::Severity::note,
                        "columns",
                        "x, y and z are columns " + std::to_string(columns[0] + 1) + ", " +
                            std::to_string(columns[1] + 1) + " and " + std::to_string(columns[2] + 1) + " of " +
                            std::to_string(count) + ".",
                        count,
                        {}});
  return columns;
}

}  // namespace geodrome::input
