// SPDX-License-Identifier: MIT
#include <iostream>
#include <limits>

#include "geodrome/engine/input.hpp"
#include "geodrome/engine/outputs.hpp"
#include "tools/geodrome/commands.hpp"
#include "tools/geodrome/console.hpp"
#include "tools/geodrome/remedies.hpp"
#include "tools/shapes/shapes.hpp"

namespace geodrome::cli {

namespace {

using shapes::Sampling;

/// Points or faces; more than anybody waits for, and few enough for memory and indices.
constexpr std::uint64_t largest_shape = 100'000'000;

struct ShapeArguments {
  std::string kind;
  std::filesystem::path out;
  shapes::SampleSpec spec;
  bool mesh = false;
  std::size_t faces = 5000;
};

int write_shape(const ShapeArguments& arguments) {
  check_outputs({&arguments.out, 1}, {});
  if (arguments.mesh) {
    const SurfaceMesh made = shapes::mesh(arguments.kind, arguments.faces, arguments.spec.seed);
    const Console undisturbed(true);  // a signal ends what is computed at once, but what is written is finished
    for (const Finding& finding : write_mesh(arguments.out, made))
      std::cerr << "warning: " << finding.message << "; " << words(finding.remedy) << "\n";
    std::cout << arguments.out.string() << ": " << made.vertex_count() << " vertices, " << made.face_count()
              << " faces\n";
  } else {
    const PointSample made = shapes::sample(arguments.kind, arguments.spec);
    const Console undisturbed(true);
    write_points(arguments.out, made.points);
    std::cout << arguments.out.string() << ": " << made.size() << " points\n";
  }
  return 0;
}

}  // namespace

void add_shape(CLI::App& app, Action& action) {
  const auto [command, arguments] =
      add_command(app, action, "shape", "Generates a shape, as points or as a mesh", write_shape);
  command
      .add_option("KIND", arguments.kind,
                  "Points: " + joined(shapes::sample_kinds()) + ". With --mesh: " + joined(shapes::mesh_kinds()))
      ->required();
  command
      .add_option("-o,--output", arguments.out,
                  "Points: " + help_for_writing(Content::points) + "; mesh: " + help_for_writing(Content::mesh))
      ->required()
      ->type_name("FILE");
  command.add_option("--points", arguments.spec.points, "How many points")
      ->check(whole_number_up_to(largest_shape))
      ->capture_default_str();
  add_choice<Sampling>(command, "--sampling", arguments.spec.sampling,
                       {{"uniform", Sampling::uniform}, {"blue", Sampling::blue}, {"grid", Sampling::grid}},
                       "uniform by area, blue noise, or a grid");
  command
      .add_option("--noise", arguments.spec.noise, "Standard deviation along the normal, as a share of the diagonal")
      ->check(number_from_to(0, 1))
      ->capture_default_str();
  command.add_flag("--mesh", arguments.mesh, "A mesh instead of points");
  command.add_option("--faces", arguments.faces, "About how many faces")
      ->check(whole_number_up_to(largest_shape))
      ->capture_default_str();
  command.add_option("--seed", arguments.spec.seed, "Seed of everything random")
      ->check(whole_number_up_to(std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
}

}  // namespace geodrome::cli
