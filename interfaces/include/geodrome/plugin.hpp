// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <exception>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>

#include "geodrome/abi.hpp"
#include "geodrome/control_function.hpp"
#include "geodrome/decimator.hpp"
#include "geodrome/settings.hpp"
#include "geodrome/shortest_path_solver.hpp"
#include "geodrome/surface_reconstructor.hpp"
#include "geodrome/tangent_estimator.hpp"

namespace geodrome {

/// `PluginTraits::factor` of a solver whose distances are exact up to rounding, whatever its options.
inline double exact_factor(const OptionValues*) noexcept { return 1; }
/// `PluginTraits::factor` of a solver that guarantees nothing, and of the plugins of all other stages.
inline double no_factor(const OptionValues*) noexcept { return std::numeric_limits<double>::infinity(); }

/// The description that an author gives of a plugin; the stage follows from the class.
struct PluginTraits {
  const char* name;     ///< without the stage: "chen_han"
  const char* summary;  ///< one line: method and source
  const char* licence;  ///< SPDX identifier
  Needs needs = Needs::nothing;
  Provides provides = Provides::nothing;
  std::span<const OptionSpec> options = {};
  double (*factor)(const OptionValues*) noexcept = no_factor;
  const void* (*extension)(const char* id) noexcept = nullptr;  ///< see `extensions`
};

/// Answers for the tables of functions that a plugin offers as extensions, each by the `id` of its class:
/// `.extension = geodrome::extensions<my_table>`. Null for any other id.
template <const auto&... Tables>
const void* extensions(const char* id) noexcept {
  const void* found = nullptr;
  ((std::string_view(id) == Tables.id ? void(found = &Tables) : void()), ...);
  return found;
}

namespace detail {

template <class P>
concept StagePlugin = std::derived_from<P, TangentEstimator> || std::derived_from<P, ControlFunction> ||
    std::derived_from<P, Decimator> || std::derived_from<P, SurfaceReconstructor> ||
    std::derived_from<P, ShortestPathSolver>;

template <StagePlugin P>
consteval auto interface_of() {
  if constexpr (std::derived_from<P, TangentEstimator>)
    return std::type_identity<TangentEstimator>();
  else if constexpr (std::derived_from<P, ControlFunction>)
    return std::type_identity<ControlFunction>();
  else if constexpr (std::derived_from<P, Decimator>)
    return std::type_identity<Decimator>();
  else if constexpr (std::derived_from<P, SurfaceReconstructor>)
    return std::type_identity<SurfaceReconstructor>();
  else
    return std::type_identity<ShortestPathSolver>();
}

template <StagePlugin P>
using InterfaceOf = typename decltype(interface_of<P>())::type;

/// No exception may leave an extern "C" border.
template <StagePlugin P>
void* create(const OptionValues* options, const ErrorSink* errors) noexcept {
  try {
    InterfaceOf<P>* made = nullptr;
    if constexpr (std::constructible_from<P, const OptionValues&>)
      made = new P(*options);
    else
      made = new P();
    return made;
  } catch (const OptionError& error) {
    errors->report(errors->receiver, true, error.what());
  } catch (const std::exception& error) {
    errors->report(errors->receiver, false, error.what());
  } catch (...) {
    errors->report(errors->receiver, false, "an exception of unknown type");
  }
  return nullptr;
}

template <StagePlugin P>
void destroy(void* object) noexcept {
  delete static_cast<InterfaceOf<P>*>(object);
}

template <StagePlugin P>
constexpr PluginDescriptor describe(const PluginTraits& traits) {
  return {sizeof(PluginDescriptor), interface_version, build_tag,    InterfaceOf<P>::stage, traits.name,
          traits.summary,           traits.licence,    traits.needs, traits.provides,       traits.options.data(),
          traits.options.size(),    traits.factor,     &create<P>,   &destroy<P>,           traits.extension};
}

}  // namespace detail
}  // namespace geodrome

/// Exports `Class`, which implements one of the five interfaces and has a constructor from `const OptionValues&` or
/// without arguments, as the plugin of this shared library:
///
///     GEODROME_PLUGIN(MySolver, .name = "mine", .summary = "what it does", .licence = "MIT")
#define GEODROME_PLUGIN(Class, ...)                                                                                \
  extern "C" __attribute__((visibility("default"))) const geodrome::PluginDescriptor* geodrome_plugin() noexcept { \
    static constexpr geodrome::PluginDescriptor descriptor =                                                       \
        geodrome::detail::describe<Class>(geodrome::PluginTraits{__VA_ARGS__});                                    \
    return &descriptor;                                                                                            \
  }
