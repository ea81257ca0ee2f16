// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "tools/geodrome/commands.hpp"
#include "tools/geodrome/console.hpp"
#include "engine/jobs/check_outputs.hpp"
#include "engine/surface/opened.hpp"
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
  check_mesh_ending(arguments.out, arguments.settings.read);
  check_outputs({&arguments.out, 1}, files_read(arguments.input, arguments.settings.read, {}));
  const MeshPtr mesh = with_console(arguments.quiet, [&](Console& console) {
    const PluginHost host(arguments.settings.plugin_path);
    return open_input(arguments.input, host, arguments.settings, console).surface.mesh;
  });
  write_mesh(arguments.out, *mesh);
  std::cout << arguments.out.string() << ": " << mesh->vertex_count() << " vertices, " << mesh->face_count()
            << " faces, " << (mesh->closed() ? "closed" : "bordered") << "\n";
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
