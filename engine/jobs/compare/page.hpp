// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace geodrome {

/// The page of a comparison: an HTML file that is complete but for the data, for which it holds a marker.
class ComparisonPage {
 public:
  /// Reads the template `file`; empty: the one that came with the engine, which is found from where the engine lies.
  /// Throws CapabilityError if it is missing or has not one marker.
  explicit ComparisonPage(std::filesystem::path file = {});

  /// The page with `json` as its data: whatever the data hold, they stay data.
  std::string with(std::string_view json) const;

 private:
  std::string before_, after_;
};

}  // namespace geodrome
