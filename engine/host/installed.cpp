// SPDX-License-Identifier: MIT
#include "engine/host/installed.hpp"

#define BOOST_DLL_USE_STD_FS
#include <boost/dll/runtime_symbol_info.hpp>

#include "engine/formats/text.hpp"
#include "geodrome/errors.hpp"

namespace geodrome {
namespace {

namespace fs = std::filesystem;

/// The first of the places, as seen from the engine's library, that holds `name`.
fs::path find(const std::string& name, std::initializer_list<const char*> places) {
  std::string tried;
  for (const char* place : places) {
    const fs::path path = (engine_folder() / place / name).lexically_normal();
    std::error_code error;
    if (fs::exists(path, error)) return path;
    if (tried != path.string()) append_word(tried, path.string());
  }
  throw PluginError(name + ", a part of Geodrome, is missing (looked for " + tried + ")",
                    "install Geodrome completely");
}

}  // namespace

fs::path engine_folder() {
  static const fs::path folder = fs::weakly_canonical(boost::dll::this_line_location()).parent_path();
  return folder;
}

fs::path installed_program(const std::string& name) { return find(name, {GEODROME_BIN_FROM_LIB, "../bin"}); }

fs::path installed_data(const std::string& name) { return find(name, {GEODROME_DATA_FROM_LIB, "../share/geodrome"}); }

}  // namespace geodrome
