// SPDX-License-Identifier: MIT
#include <cerrno>
#include <fstream>
#include <iostream>
#include <map>
#include <system_error>

#include "geodrome/engine/installed.hpp"
#include "geodrome/plugin.hpp"
#include "tools/geodrome/commands.hpp"

namespace geodrome::cli {

namespace {

namespace fs = std::filesystem;

struct NewPluginArguments {
  std::string name, stage;
  fs::path folder;
};

/// A name that serves as part of a file's, a target's and a C++ identifier.
void check_plugin_name(const std::string& name) {
  const bool right = !name.empty() && name.size() <= 40 && name[0] >= 'a' && name[0] <= 'z' &&
                     name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
  if (!right)
    throw OptionError("'" + name + "' cannot be a plugin's name",
                      "use small letters, digits and _, a letter first, 40 at most");
}

/// "my_solver" as "MySolver".
std::string class_name(const std::string& name) {
  std::string words;
  bool capital = true;
  for (const char c : name) {
    if (c != '_') words += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    capital = c == '_';
  }
  return words;
}

std::string replaced(std::string text, const std::string& word, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += by.size())
    text.replace(at, word.size(), by);
  return text;
}

/// Puts stage and name in the place of "template_stage", "template_name" and "TemplateName".
std::string filled_in(const std::string& text, const NewPluginArguments& arguments) {
  const std::string staged = replaced(text, "template_stage", arguments.stage);
  return replaced(replaced(staged, "template_name", arguments.name), "TemplateName", class_name(arguments.name));
}

InputError unwritable(const fs::path& path, const std::string& reason) {
  return InputError(InputFault::io, path.string() + " cannot be written: " + reason,
                    "check the folder, or choose another with -o");
}

void copy_file(const fs::path& from, const fs::path& to, const NewPluginArguments& arguments) {
  std::string text(fs::file_size(from), '\0');
  if (!std::ifstream(from, std::ios::binary).read(text.data(), static_cast<std::streamsize>(text.size())))
    throw InputError(InputFault::io, from.string() + " cannot be read", "install Geodrome completely");
  std::ofstream out(to, std::ios::binary);
  out << filled_in(text, arguments);
  out.close();
  if (!out) throw unwritable(to, std::generic_category().message(errno));
  std::cout << to.string() << "\n";
}

/// The files of the templates by their names in the project: those of the stage, and those of all stages.
std::map<std::string, fs::path> template_files(const NewPluginArguments& arguments) {
  std::map<std::string, fs::path> files;
  for (const std::string& folder : {std::string("common"), arguments.stage})
    for (const auto& entry : fs::directory_iterator(installed_data("templates/" + folder)))
      files[filled_in(entry.path().filename().string(), arguments)] = entry.path();
  return files;
}

int start_plugin(const NewPluginArguments& arguments) {
  check_plugin_name(arguments.name);
  const std::map<std::string, fs::path> files = template_files(arguments);
  const fs::path target =
      arguments.folder.empty() ? fs::path(arguments.stage + "_" + arguments.name) : arguments.folder;
  if (fs::exists(target))
    throw InputError(InputFault::io, target.string() + " is there already", "choose another folder with -o");
  std::error_code error;
  if (!fs::create_directories(target, error)) throw unwritable(target, error.message());
  try {
    for (const auto& [name, source] : files) copy_file(source, target / name, arguments);
  } catch (...) {
    fs::remove_all(target, error);  // half a project is none
    throw;
  }
  return 0;
}

}  // namespace

void add_plugins_new(CLI::App& plugins, Action& action) {
  const auto [command, arguments] = add_command(
      plugins, action, "new",
      "Writes a project for a plugin of your own: it builds out of tree against the install and passes 'check'",
      start_plugin);
  command.add_option("NAME", arguments.name, "Its name without the stage: small letters, digits, _")->required();
  command.add_option("--stage", arguments.stage, "The stage it is to serve")
      ->required()
      ->check(CLI::IsMember({TangentEstimator::stage, ControlFunction::stage, Decimator::stage,
                             SurfaceReconstructor::stage, ShortestPathSolver::stage}))
      ->type_name("STAGE");
  command.add_option("-o", arguments.folder, "The folder to be made (default: STAGE_NAME)")->type_name("DIR");
}

}  // namespace geodrome::cli
