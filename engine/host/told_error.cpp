// SPDX-License-Identifier: MIT
#include "engine/host/told_error.hpp"

#include <new>

#include "geodrome/errors.hpp"

namespace geodrome {

namespace {

constexpr const char *of_the_standard = "exception", *of_memory = "memory";

template <class Kind>
[[noreturn]] void throw_as(const std::string& message, Remedy remedy, const std::string& plugin) {
  Kind error(message, std::move(remedy));
  if (!plugin.empty()) error.attribute_to(plugin);
  throw error;
}

[[noreturn]] void throw_input_error(const std::string& code, const std::string& message, Remedy remedy,
                                    const std::string& plugin) {
  auto fault = InputFault::io;
  while (geodrome::code(fault) != code) fault = static_cast<InputFault>(static_cast<int>(fault) + 1);
  InputError error(fault, message.substr(name(fault).size() + 2), std::move(remedy));  // it begins with "fault: "
  if (!plugin.empty()) error.attribute_to(plugin);
  throw error;
}

}  // namespace

std::vector<std::string> told(const std::exception& exception) {
  if (dynamic_cast<const std::bad_alloc*>(&exception) != nullptr) return {of_memory};
  const auto* error = dynamic_cast<const Error*>(&exception);
  if (error == nullptr) return {of_the_standard, exception.what()};
  const Remedy& remedy = error->coded_remedy();
  std::vector<std::string> words{std::string(error->code()), error->message(), error->plugin(), remedy.text,
                                 remedy.code};
  words.insert(words.end(), remedy.parameters.begin(), remedy.parameters.end());
  return words;
}

void throw_told(const std::vector<std::string>& told) {
  const std::string& code = told[0];
  if (code == of_memory) throw std::bad_alloc();
  if (code == of_the_standard) throw std::runtime_error(told[1]);
  if (code == Cancelled().code()) throw Cancelled();
  const std::string &message = told[1], &plugin = told[2];
  const Remedy remedy(told[4], {told.begin() + 5, told.end()}, told[3]);
  if (code.starts_with("input.")) throw_input_error(code, message, remedy, plugin);
  if (code == "option") throw_as<OptionError>(message, remedy, plugin);
  if (code == "capability") throw_as<CapabilityError>(message, remedy, plugin);
  if (code == "sample") throw_as<SampleError>(message, remedy, plugin);
  if (code == "refused") throw_as<RefusedError>(message, remedy, plugin);
  if (code == "plugin") throw_as<PluginError>(message, remedy, plugin);
  if (code == "numerical") throw_as<NumericalError>(message, remedy, plugin);
  throw_as<Error>(message, remedy, plugin);
}

}  // namespace geodrome
