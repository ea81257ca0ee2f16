// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>

#include <string>

#include "geodrome/errors.hpp"

namespace geodrome {

/// CGAL's failures become NumericalErrors.
template <class Function>
auto guarded(Function&& function) {
  CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  try {
    return function();
  } catch (const CGAL::Failure_exception& failure) {
    throw NumericalError(std::string("CGAL failed: ") + failure.what(), "choose another plugin for this stage");
  }
}

}  // namespace geodrome
