// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <new>
#include <utility>

#include "geodrome/engine/plugin_info.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {

/// Marks, for the current thread, the plugin whose code is about to run, so that a crash can be laid at its door.
/// Nests; restores the previous mark.
class PluginScope {
 public:
  explicit PluginScope(const PluginInfo& plugin) noexcept;
  ~PluginScope();
  PluginScope(const PluginScope&) = delete;
  PluginScope& operator=(const PluginScope&) = delete;

 private:
  const PluginInfo* previous_;
};

/// What to do where memory does not suffice.
inline constexpr const char* out_of_memory_remedy = "ask for less, or use a machine with more memory";

/// Installs handlers for SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT and std::terminate that write which plugin and stage
/// was running on that thread (or else, for a thread that a plugin started, on any), and what to do, to standard error
/// and end the process with status 5 (1 if no plugin was running; 4 for std::terminate where memory ran out). Also told
/// are stack overflows on threads that enter plugins through `cross_boundary`. For programs, not for libraries: call it
/// once, in main or before the objects that are made ahead of main.
void install_crash_handlers() noexcept;

/// Runs `function`, which calls into `plugin`: the only way the engine does so. A geodrome::Error keeps its type and
/// gains the plugin's name; std::bad_alloc becomes a RefusedError, any other exception a PluginError, that says plugin,
/// stage and what was thrown.
template <class Function>
decltype(auto) cross_boundary(const PluginInfo& plugin, Function&& function) {
  const PluginScope scope(plugin);
  const auto fail = [&](const std::string& what) -> PluginError {
    PluginError error(
        "stage " + plugin.stage + " failed: " + what,
        "choose another " + plugin.stage + " plugin, or report this to the author of " + plugin.file.string());
    error.attribute_to(plugin.full_name());
    return error;
  };
  try {
    return std::forward<Function>(function)();
  } catch (Error& error) {
    error.attribute_to(plugin.full_name());
    throw;
  } catch (const std::bad_alloc&) {
    RefusedError error("stage " + plugin.stage + " ran out of memory", out_of_memory_remedy);
    error.attribute_to(plugin.full_name());
    throw error;
  } catch (const std::exception& error) {
    throw fail(error.what());
  } catch (...) {
    throw fail("an exception of unknown type");
  }
}

}  // namespace geodrome
