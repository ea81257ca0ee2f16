// SPDX-License-Identifier: MIT
// geodrome-vet FILE: loads one plugin and prints what it is as one JSON object to standard output. Whatever the plugin
// does to the process stays in this process; the host runs it under a time limit and takes any bad end for a refusal.
//
//   {"interface_version":2,"build_tag":"...","plugin":{...}}      status 0
//   {"interface_version":2,"build_tag":"...","refused":"why"}     status 1
#define BOOST_DLL_USE_STD_FS
#include <sys/prctl.h>

#include <boost/dll/shared_library.hpp>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>

#include "engine/host/answer.hpp"
#include "engine/host/crashes_are_signals.hpp"
#include "engine/host/handshake.hpp"
#include "engine/host/loader_words.hpp"
#include "engine/host/plugin_json.hpp"
#include "tools/vet/descriptor.hpp"

namespace {

using namespace geodrome;

const Answer* output = nullptr;

/// Prints the answer and ends the process.
[[noreturn]] void answer(const char* key, const nlohmann::json& value) {
  const nlohmann::json json = {{"interface_version", interface_version}, {"build_tag", build_tag}, {key, value}};
  output->end(json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n",
              std::string_view(key) == "plugin" ? 0 : 1);
}

std::string what_was_thrown() {
  try {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "an exception of unknown type";
  }
}

void vet(const std::filesystem::path& file) {
  boost::dll::shared_library library;
  try {
    using namespace boost::dll::load_mode;
    library.load(std::filesystem::absolute(file), rtld_now | rtld_local);
  } catch (const std::system_error& error) {
    answer("refused", "cannot be loaded: " + loader_words(error.what()));
  } catch (...) {
    answer("refused", "threw while being loaded: " + what_was_thrown());
  }
  if (!library.has(plugin_entry)) answer("refused", "no entry " + std::string(plugin_entry));
  const PluginDescriptor* plugin = library.get<const PluginDescriptor*()>(plugin_entry)();
  if (const auto fault = handshake_fault(plugin)) answer("refused", *fault);
  try {
    answer("plugin", checked_info(whole_descriptor(*plugin)));
  } catch (const PluginError& error) {
    answer("refused", "its descriptor is wrong: " + std::string(error.what()));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 || argv[1][0] == '-') {
    std::cerr << "usage: geodrome-vet PLUGIN.so\nPrints what a Geodrome plugin says of itself as JSON.\n";
    return 2;
  }
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // a plugin that hangs must not outlive the host
  const Answer own("geodrome-vet");
  output = &own;
  std::set_terminate([] {
    answer("refused",
           std::current_exception() ? "threw while being loaded: " + what_was_thrown() : "called std::terminate");
  });
  vet(argv[1]);
}
