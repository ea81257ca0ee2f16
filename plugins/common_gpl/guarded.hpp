// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>

#include <string>

#include "geodrome/errors.hpp"

namespace geodrome {

/// Makes CGAL throw where it would abort. Once for the whole plugin, so that threads do not write it while others read.
inline void let_cgal_throw() {
  static const CGAL::Failure_behaviour before = CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  static_cast<void>(before);
}

/// Calls a function that uses CGAL. CGAL's failures become NumericalErrors with this remedy; other errors pass.
template <class Function>
decltype(auto) guarded(Function&& function, const char* remedy = "choose another plugin for this stage") {
  let_cgal_throw();
  try {
    return function();
  } catch (const CGAL::Failure_exception& failure) {
    throw NumericalError(std::string("CGAL failed: ") + failure.what(), remedy);
  }
}

}  // namespace geodrome
