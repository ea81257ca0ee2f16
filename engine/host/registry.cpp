// SPDX-License-Identifier: MIT
#include "engine/host/registry.hpp"

#define BOOST_DLL_USE_STD_FS
#include <boost/dll/shared_library.hpp>
#include <list>
#include <map>
#include <mutex>
#include <new>

#include "engine/host/handshake.hpp"
#include "engine/host/loader_words.hpp"
#include "geodrome/engine/boundary.hpp"

namespace geodrome {
namespace {

struct Registry {
  std::mutex mutex;
  std::map<std::filesystem::path, LoadedPlugin> plugins;  // addresses stay valid as others are added
  std::list<boost::dll::shared_library> libraries;
};

/// Intentionally leaked: static destructors must find the plugins still there, and no library is ever unloaded.
Registry& registry() {
  static Registry& forever = *new Registry;
  return forever;
}

[[noreturn]] void refuse(const PluginInfo& info, const std::string& why) {
  throw PluginError("plugin " + info.file.string() + " " + why);
}

PluginDescriptor open(const PluginInfo& info, boost::dll::shared_library& library) {
  using namespace boost::dll::load_mode;
  try {
    const PluginScope scope(info);
    library.load(info.file, rtld_now | rtld_local);
    const PluginDescriptor* plugin = library.get<const PluginDescriptor*()>(plugin_entry)();
    if (const auto fault = handshake_fault(plugin)) refuse(info, "is refused: " + *fault);
    const PluginDescriptor whole = whole_descriptor(*plugin);
    if (whole.stage != info.stage || whole.name != info.name) refuse(info, "changed while it was being loaded");
    return whole;
  } catch (const std::system_error& error) {
    refuse(info, "cannot be loaded: " + loader_words(error.what()));
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {
    refuse(info, "threw while being loaded, though it had not when it was tested");
  }
}

}  // namespace

const LoadedPlugin* find_loaded(const std::filesystem::path& file) {
  Registry& loaded = registry();
  const std::lock_guard lock(loaded.mutex);
  const auto found = loaded.plugins.find(file);
  return found == loaded.plugins.end() ? nullptr : &found->second;
}

const LoadedPlugin& load_for_good(const PluginInfo& info) {
  Registry& loaded = registry();
  const std::lock_guard lock(loaded.mutex);
  const auto found = loaded.plugins.find(info.file);
  if (found != loaded.plugins.end()) return found->second;
  const PluginDescriptor descriptor = open(info, loaded.libraries.emplace_back());
  return loaded.plugins.emplace(info.file, LoadedPlugin{info, descriptor}).first->second;
}

}  // namespace geodrome
