// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace geodrome::bench {

/// The solvers of a list separated by commas, each as `PluginHost::load` takes it. A part that is `key=value` without a
/// name before it is one more option of the solver in front of it: "aleksandrov:delta=0.1,placement=published,cgal" are
/// two solvers.
std::vector<std::string> split_solvers(std::string_view list);

/// The choice without one of its options: what "aleksandrov:delta=0.1" and "aleksandrov:delta=0.2" share.
std::string without_option(std::string_view solver, std::string_view key);

}  // namespace geodrome::bench
