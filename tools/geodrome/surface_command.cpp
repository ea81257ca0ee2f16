// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "console.hpp"
#include "geodrome/engine/input.hpp"
#include "geodrome/engine/pipeline.hpp"

namespace geodrome::cli {

namespace {

struct Arguments {
  std::filesystem::path input, out;
  RunSettings settings;
  bool quiet = false;
};

int run(const Arguments& arguments) {
  Console console(arguments.quiet);
  const PluginHost host(arguments.settings.plugin_path);
  const Input input = read_input(arguments.input, arguments.settings.read);
  for (const Finding& finding : input.findings)
    if (finding.severity != Finding::Severity::note) console.log(LogLevel::warning, finding.message);
  const Surface surface = make_surface(input, host, arguments.settings, console);
  for (const Finding& finding : surface.findings)
    console.log(finding.severity == Finding::Severity::note ? LogLevel::info : LogLevel::warning, finding.message);
  write_mesh(arguments.out, *surface.mesh);
  std::cout << arguments.out.string() << ": " << surface.mesh->vertex_count() << " vertices, "
            << surface.mesh->face_count() << " faces, " << (surface.mesh->closed() ? "closed" : "bordered") << "\n";
  return 0;
}

}  // namespace

void add_surface(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command =
      *app.add_subcommand("surface", "The surface of a point sample as a mesh (of a mesh: the mesh as used)");
  add_input(command, arguments->input);
  command.add_option("-o,--output", arguments->out, "The mesh: .ply, .off, .obj, .stl")->required()->type_name("FILE");
  add_sample_stages(command, arguments->settings.stages);
  add_read_options(command, arguments->settings.read);
  add_run_options(command, arguments->settings);
  add_quiet(command, arguments->quiet);
  command.callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace geodrome::cli
