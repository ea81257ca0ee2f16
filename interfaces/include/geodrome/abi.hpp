// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>  // defines the standard library's own macros

#include "geodrome/capabilities.hpp"
#include "geodrome/options.hpp"

/// The border between engine and plugin: one C function, `geodrome_plugin`, returns a pointer to plain data that the
/// engine reads before it makes any C++ call into the plugin.
namespace geodrome {

/// Changes whenever a type that crosses the border changes. The host loads only plugins of its own version.
inline constexpr std::uint32_t interface_version = 1;

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

/// What both sides must share for C++ objects to cross: standard library, sanitizer, scalar type.
inline constexpr char build_tag[] = GEODROME_STANDARD_LIBRARY " " GEODROME_SANITIZER " double";

/// Name of the entry, type `const PluginDescriptor* (*)()`.
inline constexpr char plugin_entry[] = "geodrome_plugin";

/// Where `create` tells why it returned null. The message is copied before `report` returns.
struct ErrorSink {
  void* receiver;
  void (*report)(void* receiver, bool is_option_error, const char* message) noexcept;
};

/// What a plugin is. The first three members never change place, so that hosts of any version can read them.
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
};

using PluginEntry = const PluginDescriptor* (*)();

}  // namespace geodrome
