// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>  // defines the standard library's own macros

#include "geodrome/capabilities.hpp"
#include "geodrome/options.hpp"

/// The border between engine and plugin: one C function, `geodrome_plugin`, returns a pointer to plain data that the
/// engine reads before it makes any C++ call into the plugin.
namespace geodrome {

/// The version of the border that these headers describe. It is raised whenever a type that crosses the border changes,
/// or the descriptor gets a member at its end. New abilities need neither: they come as extensions.
/// 2: `Error` and `Finding` carry their remedy as a code with parameters; the descriptor has `extension`.
inline constexpr std::uint32_t interface_version = 2;

/// The oldest version whose plugins a host of this version still loads. It is raised to `interface_version` when a
/// type changes its layout or its virtual functions, and stays when the descriptor only grows at its end.
/// 2: plugins of version 1 throw an `Error` of another layout.
inline constexpr std::uint32_t oldest_interface_version = 2;
static_assert(oldest_interface_version <= interface_version);

#if defined(__SANITIZE_ADDRESS__)
#define GEODROME_SANITIZER "asan"
#elif defined(__SANITIZE_THREAD__)
#define GEODROME_SANITIZER "tsan"
#else
#define GEODROME_SANITIZER "plain"
#endif
#if defined(_LIBCPP_VERSION)
#define GEODROME_STANDARD_LIBRARY "libc++"
#elif defined(_GLIBCXX_DEBUG)
#define GEODROME_STANDARD_LIBRARY "libstdc++-debug"
#elif defined(_GLIBCXX_USE_CXX11_ABI) && _GLIBCXX_USE_CXX11_ABI
#define GEODROME_STANDARD_LIBRARY "libstdc++-cxx11"
#else
#define GEODROME_STANDARD_LIBRARY "libstdc++-old"
#endif

/// The properties that both sides must share for C++ objects to cross: standard library, sanitizer, scalar type.
inline constexpr char build_tag[] = GEODROME_STANDARD_LIBRARY " " GEODROME_SANITIZER " double";

/// Name of the entry, type `const PluginDescriptor* (*)()`.
inline constexpr char plugin_entry[] = "geodrome_plugin";

/// Where `create` tells why it returned null. The message is copied before `report` returns.
struct ErrorSink {
  void* receiver;
  void (*report)(void* receiver, bool is_option_error, const char* message) noexcept;
};

/// The descriptor of a plugin. The first three members never change place, so that hosts of any version can read them.
/// Members are only ever added at the end: those beyond `size` are absent, which a host of a later version takes for
/// null.
struct PluginDescriptor {
  std::uint32_t size;               ///< sizeof(PluginDescriptor) where the plugin was built
  std::uint32_t interface_version;  ///< geodrome::interface_version there
  const char* build_tag;            ///< geodrome::build_tag there
  const char *stage, *name, *summary, *licence;
  Needs needs;
  Provides provides;
  const OptionSpec* options;
  std::size_t option_count;
  double (*factor)(const OptionValues*) noexcept;                   ///< 1 exact, 1 + delta proven, +inf none
  void* (*create)(const OptionValues*, const ErrorSink*) noexcept;  ///< an object of the stage's interface, or null
  void (*destroy)(void*) noexcept;
  /// The table of functions of the extension `id`, which lives as long as the library; null if the plugin does not know
  /// the id. May itself be null: no extensions. Thread-safe.
  const void* (*extension)(const char* id) noexcept;
};

/// The smallest descriptor of an accepted version: all that stands before `extension`.
inline constexpr std::size_t smallest_descriptor = offsetof(PluginDescriptor, extension);

/// The type of the entry.
using PluginEntry = const PluginDescriptor* (*)();

}  // namespace geodrome
