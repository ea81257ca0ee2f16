// SPDX-License-Identifier: MIT
#include "engine/jobs/compare/page.hpp"

#include "engine/formats/remedies.hpp"
#include "engine/formats/source_file.hpp"
#include "engine/host/installed.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view marker = "<!--geodrome-comparison-->";

[[noreturn]] void fail(const std::string& what) {
  throw CapabilityError("the page of a comparison " + what, remedies::page_output());
}

fs::path installed_template() {
  try {
    return installed_data("compare.html");
  } catch (const PluginError& error) {
    fail("was not built: " + error.message());
  }
}

}  // namespace

ComparisonPage::ComparisonPage(fs::path file) {
  if (file.empty()) file = installed_template();
  std::error_code error;
  if (!fs::is_regular_file(file, error)) fail("was not built (looked for " + file.string() + ")");
  const std::string text = input::read_source(file).bytes;
  const std::size_t at = text.find(marker);
  if (at == std::string::npos || text.find(marker, at + 1) != std::string::npos)
    fail("has no place for the data, or several: " + file.string());
  before_ = text.substr(0, at), after_ = text.substr(at + marker.size());
}

std::string ComparisonPage::with(std::string_view json) const {
  std::string text = before_ + "<script type=\"application/json\" id=\"geodrome-comparison\">";
  text.reserve(text.size() + json.size() + json.size() / 64 + after_.size());
  // Without '<' no string in the data can end the element, or begin one.
  for (const char c : json) c == '<' ? text += "\\u003c" : text += c;
  return text + "</script>" + after_;
}

}  // namespace geodrome
