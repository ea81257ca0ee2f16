// SPDX-License-Identifier: MIT
#include <filesystem>
#include <new>

#include "geodrome/engine/jobs.hpp"

namespace geodrome {

int exit_status(const std::exception& error) noexcept {
  const auto is = [&]<class... E>() { return (... || (dynamic_cast<const E*>(&error) != nullptr)); };
  if (is.operator()<OptionError>()) return 2;
  if (is.operator()<InputError, CapabilityError, std::filesystem::filesystem_error>()) return 3;
  if (is.operator()<SampleError, RefusedError, std::bad_alloc>()) return 4;
  if (is.operator()<PluginError, NumericalError>()) return 5;
  if (is.operator()<Cancelled>()) return 130;
  return 1;
}

}  // namespace geodrome
