// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace geodrome::input {

enum class Separator : char { blanks = ' ', tab = '\t', comma = ',', semicolon = ';' };

/// The separator of a line: a semicolon if there is one outside of quotes, else a comma, else blanks (tabs among them).
Separator separator_of(std::string_view line);

/// Splits a line into its fields, without the blanks around them. A field in double quotes may hold separators; the
/// quotes stay.
void split_row(std::string_view line, Separator separator, std::vector<std::string_view>& fields);

/// A line without the comment at its end, which '#' outside of quotes begins.
std::string_view without_comment(std::string_view line);

/// A field without the quotes around it, single or double.
std::string_view unquoted(std::string_view field);

}  // namespace geodrome::input
