// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "geodrome/engine/remedies.hpp"
#include "geodrome/errors.hpp"

namespace geodrome::cli {

/// What the command line says to the codes of the engine's remedies: flags where the library speaks of members.
std::span<const RemedySentence> sentences_of_flags() noexcept;

/// A remedy for users of the command line; the library's sentence where the command line has none for its code.
std::string words(const Remedy& remedy);

/// An error for users of the command line: plugin, message and remedy.
std::string text_of(const Error& error);

}  // namespace geodrome::cli
