// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "tools/bench/commands/commands.hpp"
#include "tools/bench/samples/file_samples.hpp"
#include "tools/bench/samples/topology_table.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* samples_meaning =
    "Right: one component, oriented, with the genus and the number of boundary loops of the shape. Refused: the "
    "sample was\n"
    "declined (SampleError). Wrong: another surface was returned. Failed: any other error. Noise is along the normal; "
    "outliers\n"
    "are uniform in the bounding box enlarged by 10 %. A sheet is wrong as well if an edge joins two parts of it, or "
    "if\n"
    "vertices are over 2 % too near to each other; errors are those of pairs at least a quarter of its size apart. "
    "With FILEs: their vertices as points, nothing else is run.";

struct SamplesArguments {
  std::vector<std::filesystem::path> files;
  TableChoice choice;
  RunSettings settings;
};

void run(const SamplesArguments& arguments) {
  const PluginHost host(arguments.settings.plugin_path);
  const StageChoice& stages = arguments.settings.stages;
  std::cout << "stages: tangent " << stages.tangent << ", control " << stages.control << ", decimator "
            << stages.decimator << ", reconstructor " << stages.reconstructor << '\n';
  if (arguments.files.empty()) return print_topology_tables(std::cout, arguments.choice, host, arguments.settings);
  print_file_samples(std::cout, arguments.files, host, arguments.settings);
}

}  // namespace

void add_samples(CLI::App& app, Action& action) {
  const auto [command, arguments] = add_command<SamplesArguments>(
      app, action, "samples", "Surfaces from samples: how many come out right.", samples_meaning, run);
  command.add_option("FILE", arguments.files, "meshes or clouds whose vertices are taken as points");
  add_list(command, "--families", arguments.choice.families, "of clean, boundary, sheets, noise, outliers");
  add_list(command, "--shapes", arguments.choice.shapes, "closed and cut shapes, sheets");
  add_list(command, "--samplings", arguments.choice.samplings, "noise and outliers come with the first");
  add_list(command, "--points", arguments.choice.points, "numbers of points");
  add_list(command, "--seeds", arguments.choice.seeds, "of the samples and of the stages");
  add_list(command, "--noise", arguments.choice.noise, "standard deviations as shares of the diagonal");
  add_list(command, "--outliers", arguments.choice.outliers, "shares of the number of points");
  add_stages(command, arguments.settings);
  add_threads(command, arguments.settings);
}

}  // namespace geodrome::bench
