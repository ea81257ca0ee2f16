// SPDX-License-Identifier: MIT
#include <iostream>

#include "tools/geodrome/commands.hpp"
#include "tools/geodrome/console.hpp"

namespace geodrome::cli {

namespace {

using SurfaceArguments = JobArguments<SurfaceJob>;

int write_surface(const SurfaceArguments& arguments) {
  const MeshPtr mesh = at_console(run_surface, arguments);
  std::cout << arguments.job.out.string() << ": " << mesh->vertex_count() << " vertices, " << mesh->face_count()
            << " faces, " << (mesh->closed() ? "closed" : "bordered") << "\n";
  return 0;
}

}  // namespace

void add_surface(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command(
      app, action, "surface", "The surface of a point sample as a mesh (of a mesh: the mesh as used)", write_surface);
  SurfaceJob& job = arguments.job;
  add_input(command, job.input);
  command.add_option("-o,--output", job.out, "The mesh: " + help_for_writing(Content::mesh))
      ->required()
      ->type_name("FILE");
  add_choice<ScalarType>(command, "--dtype", job.scalar,
                         {{"float64", ScalarType::float64}, {"float32", ScalarType::float32}},
                         "Coordinates of a .ply; float32 for viewers that know no doubles (.stl has float32 always)");
  add_job_options(command, job.settings, arguments.quiet);
}

}  // namespace geodrome::cli
