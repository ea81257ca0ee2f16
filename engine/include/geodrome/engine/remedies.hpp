// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "geodrome/errors.hpp"
#include "geodrome/remedy.hpp"

namespace geodrome {

/// The sentence that the engine says to a code of a remedy. "{0}" stands for the first parameter; members and functions
/// stand between backquotes.
struct RemedySentence {
  std::string_view code, sentence;
};

/// All codes that the engine gives (plugins may give others), for programs that word them in their own way: see
/// `Observer::words`. The same in every call; valid for the life of the process.
std::span<const RemedySentence> remedy_sentences() noexcept;

/// `sentence` with the parameters in their places. A place without a parameter stays as it is.
std::string filled(std::string_view sentence, std::span<const std::string> parameters);

/// An error as its `what`, but with `words` in place of the remedy's sentence.
std::string text_of(const Error& error, const std::string& words);

}  // namespace geodrome
