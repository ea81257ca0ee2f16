// SPDX-License-Identifier: MIT
#include "geodrome/engine/plugin_host.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <tuple>
#include <utility>

#include "engine/formats/number_text.hpp"
#include "engine/formats/text.hpp"
#include "engine/host/installed.hpp"
#include "engine/host/plugin_choice.hpp"
#include "engine/host/registry.hpp"
#include "engine/host/vetting.hpp"
#include "engine/host/whole_path.hpp"

namespace geodrome {
namespace {

namespace fs = std::filesystem;

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

/// The folders of GEODROME_PLUGIN_PATH. An empty entry is left out: it does not mean the working directory.
std::vector<fs::path> folders_of_environment() {
  std::vector<fs::path> folders;
  const char* value = std::getenv("GEODROME_PLUGIN_PATH");
  std::string_view rest = value ? value : "";
  while (!rest.empty()) {
    const std::string_view entry = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(rest.size(), entry.size() + 1));
    if (!entry.empty()) folders.emplace_back(entry);
  }
  return folders;
}

/// The files of a folder that are called *.so, by name. A folder that is not there has none.
std::vector<fs::path> candidates(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().extension() == ".so" && !is_folder(entry->path())) files.push_back(entry->path());
  std::sort(files.begin(), files.end());
  return files;
}

bool carries_its_name(const PluginInfo& plugin) { return plugin.file.stem() == plugin.full_name(); }

/// Keeps the plugin that `load` would take of those that offer the same: see the search order in the header.
void keep_first_of_each(PluginListing& listing) {
  std::stable_partition(listing.usable.begin(), listing.usable.end(), carries_its_name);
  std::map<std::string, fs::path> taken;
  std::vector<PluginInfo> kept;
  for (PluginInfo& plugin : listing.usable) {
    const auto [first, is_new] = taken.emplace(plugin.full_name(), plugin.file);
    if (is_new)
      kept.push_back(std::move(plugin));
    else
      listing.refused.push_back(
          {plugin.file, "hidden by " + first->second.string() + ", which also offers " + first->first});
  }
  std::sort(kept.begin(), kept.end(), [](const PluginInfo& a, const PluginInfo& b) {
    return std::tie(a.stage, a.name) < std::tie(b.stage, b.name);
  });
  listing.usable = std::move(kept);
}

std::string names_of(const PluginListing& listing, std::string_view stage) {
  std::string names;
  for (const PluginInfo& plugin : listing.usable)
    if (plugin.stage == stage) append_word(names, plugin.name);
  return names.empty() ? "none" : names;
}

OptionError unknown_name(std::string_view stage, const std::string& name, const PluginListing& listing,
                         const std::vector<fs::path>& folders) {
  std::string remedy = "valid names: " + names_of(listing, stage) + "; folders searched:";
  for (const fs::path& folder : folders) remedy += " " + folder.string();
  for (const PluginRefusal& refusal : listing.refused)
    if (refusal.file.stem() == std::string(stage) + "_" + name)
      remedy += "; " + refusal.file.string() + " is refused: " + refusal.reason;
  return OptionError("there is no " + std::string(stage) + " plugin '" + name + "'", remedy);
}

/// Where `create` leaves its reason.
struct Complaint {
  bool is_option_error = false;
  std::string message;

  static void take(void* receiver, bool is_option_error, const char* message) noexcept {
    auto& complaint = *static_cast<Complaint*>(receiver);
    complaint.is_option_error = is_option_error;
    complaint.message = message ? message : "";
  }
};

[[noreturn]] void fail_to_create(const Complaint& complaint) {
  if (complaint.is_option_error) throw OptionError(complaint.message);
  throw PluginError("cannot be set up: " +
                    (complaint.message.empty() ? "it gives no object and no reason" : complaint.message));
}

std::shared_ptr<const void> create(const LoadedPlugin& plugin, const OptionValues& options) {
  Complaint complaint;
  const ErrorSink sink{&complaint, &Complaint::take};
  void* object = plugin.descriptor.create(&options, &sink);
  if (object == nullptr) fail_to_create(complaint);
  return {object, [&plugin](const void* dead) {
            const PluginScope scope(plugin.info);
            plugin.descriptor.destroy(const_cast<void*>(dead));
          }};
}

/// The plugin as it is with options that may change its factor: a finite one implies that no distance is too short.
PluginInfo with_factor(PluginInfo plugin, Provides stated, double factor) {
  plugin.provides = stated;
  if (std::isfinite(factor)) plugin.provides |= Provides::never_shorter;
  return plugin;
}

}  // namespace

PluginHost::PluginHost(std::vector<fs::path> extra_folders) {
  for (const fs::path& folder : extra_folders)
    if (!is_folder(folder))
      throw OptionError("the plugin folder '" + folder.string() + "' is not there", "give a folder that holds plugins");
  const auto add = [this](const fs::path& folder) {
    const fs::path known = whole_path(folder);
    if (std::find(folders_.begin(), folders_.end(), known) == folders_.end()) folders_.push_back(known);
  };
  for (const fs::path& folder : extra_folders) add(folder);
  for (const fs::path& folder : folders_of_environment()) add(folder);
  add(engine_folder() / "geodrome");
}

PluginListing PluginHost::list() const {
  PluginListing listing;
  for (const fs::path& folder : folders_)
    for (const fs::path& file : candidates(folder)) {
      auto result = vet(file);
      if (auto* plugin = std::get_if<PluginInfo>(&result))
        listing.usable.push_back(std::move(*plugin));
      else
        listing.refused.push_back(std::get<PluginRefusal>(std::move(result)));
    }
  keep_first_of_each(listing);
  return listing;
}

PluginInfo PluginHost::inspect(const fs::path& file) const {
  const fs::path whole = whole_path(file);
  if (!is_file(whole)) throw OptionError("plugin " + whole.string() + " is not there", "name another file");
  auto result = vet(whole);
  if (auto* plugin = std::get_if<PluginInfo>(&result)) return std::move(*plugin);
  throw PluginError("plugin " + whole.string() + " is refused: " + std::get<PluginRefusal>(result).reason,
                    "rebuild or remove it, or choose another plugin");
}

std::vector<PluginInfo> PluginHost::named(const std::string& name) const {
  if (name.find('/') != std::string::npos) return {inspect(name)};
  std::vector<PluginInfo> found;
  std::string names;
  for (PluginInfo& plugin : list().usable) {
    append_word(names, plugin.full_name());
    if (plugin.name == name || plugin.full_name() == name) found.push_back(std::move(plugin));
  }
  if (!found.empty()) return found;
  throw OptionError("no plugin '" + name + "'", "there are: " + (names.empty() ? "nothing" : names));
}

PluginInfo PluginHost::find(std::string_view stage, const std::string& name) const {
  const std::string file_name = std::string(stage) + "_" + name + ".so";
  for (const fs::path& folder : folders_) {
    const fs::path file = folder / file_name;
    if (!is_file(file)) continue;
    PluginInfo plugin = known_or_inspected(file);
    if (plugin.stage == stage && plugin.name == name) return plugin;
  }
  PluginListing listing = list();
  for (PluginInfo& plugin : listing.usable)
    if (plugin.stage == stage && plugin.name == name) return std::move(plugin);
  throw unknown_name(stage, name, listing, folders_);
}

PluginInfo PluginHost::known_or_inspected(const fs::path& file) const {
  const LoadedPlugin* loaded = find_loaded(file);
  return loaded ? loaded->info : inspect(file);
}

PluginHost::Loaded PluginHost::load_object(std::string_view stage, std::string_view text) const {
  const PluginChoice choice = parse_choice(stage, text);
  const PluginInfo info = choice.file.empty() ? find(stage, choice.name) : known_or_inspected(choice.file);
  if (info.stage != stage)
    throw OptionError(info.file.string() + " is a " + info.stage + " plugin, a " + std::string(stage) + " is needed");
  const LoadedPlugin& plugin = load_for_good(info);
  const PluginDescriptor& descriptor = plugin.descriptor;
  return cross_boundary(plugin.info, [&]() -> Loaded {
    OptionValues options({descriptor.options, descriptor.option_count}, choice.options);
    auto object = create(plugin, options);
    const double factor = descriptor.factor(&options);
    if (!(factor >= 1)) throw PluginError("its factor with these options is " + number_text(factor) + ", below 1");
    return {std::move(object), with_factor(plugin.info, descriptor.provides, factor), std::move(options), factor,
            descriptor.extension};
  });
}

}  // namespace geodrome
