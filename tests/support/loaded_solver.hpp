// SPDX-License-Identifier: MIT
#pragma once

#include <dlfcn.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "geodrome/abi.hpp"
#include "geodrome/shortest_path_solver.hpp"

namespace geodrome::test {

/// A solver plugin of the build with its default options, loaded from its file as the engine would, without the engine:
/// plugins for tests wrap one without linking its inside. The library stays loaded.
class LoadedSolver : public ShortestPathSolver {
 public:
  /// Throws std::runtime_error if the file is no solver plugin.
  explicit LoadedSolver(const std::string& file) {
    void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) throw std::runtime_error(dlerror());
    const auto entry = reinterpret_cast<PluginEntry>(dlsym(library, plugin_entry));
    if (!entry) throw std::runtime_error(file + " is no plugin");
    const PluginDescriptor& plugin = *entry();
    if (std::string(plugin.stage) != stage) throw std::runtime_error(file + " is no solver");
    const OptionValues values({plugin.options, plugin.option_count});
    std::string message = file + " made nothing";
    const ErrorSink sink{
        &message, [](void* receiver, bool, const char* text) noexcept { *static_cast<std::string*>(receiver) = text; }};
    void* made = plugin.create(&values, &sink);
    if (!made) throw std::runtime_error(message);
    solver_ = {static_cast<ShortestPathSolver*>(made), plugin.destroy};
  }

  std::unique_ptr<PreparedSurface> prepare(MeshPtr mesh, RunContext& context) const override {
    return solver_->prepare(std::move(mesh), context);
  }

 private:
  std::unique_ptr<ShortestPathSolver, void (*)(void*) noexcept> solver_{nullptr, nullptr};
};

}  // namespace geodrome::test
