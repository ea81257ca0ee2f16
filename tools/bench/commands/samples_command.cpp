// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "tools/bench/commands/commands.hpp"
#include "tools/bench/samples/file_samples.hpp"
#include "tools/bench/samples/topology_table.hpp"

namespace geodrome::bench {
namespace {

constexpr const char* meaning =
    "Right: one component, oriented, with the genus and the number of boundary loops of the shape. Refused: the "
    "sample was\n"
    "declined (SampleError). Wrong: another surface was returned. Failed: any other error. Noise is along the normal; "
    "outliers\n"
    "are uniform in the bounding box enlarged by 10 %. With FILEs: their vertices as points, nothing else is run.";

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
  auto arguments = std::make_shared<SamplesArguments>();
  CLI::App& command = *app.add_subcommand("samples", "Surfaces from samples: how many come out right.");
  command.footer(meaning);
  command.add_option("FILE", arguments->files, "meshes or clouds whose vertices are taken as points");
  const auto list = [&](const char* flag, auto& values, const char* help) {
    command.add_option(flag, values, help)->delimiter(',')->allow_extra_args(false)->capture_default_str();
  };
  list("--families", arguments->choice.families, "of clean, boundary, noise, outliers");
  list("--shapes", arguments->choice.shapes, "closed and cut shapes");
  list("--samplings", arguments->choice.samplings, "noise and outliers come with the first");
  list("--points", arguments->choice.points, "numbers of points");
  list("--seeds", arguments->choice.seeds, "of the samples and of the stages");
  list("--noise", arguments->choice.noise, "standard deviations as shares of the diagonal");
  list("--outliers", arguments->choice.outliers, "shares of the number of points");
  add_stages(command, arguments->settings);
  add_threads(command, arguments->settings);
  command.callback([&action, arguments] { action = [arguments] { run(*arguments); }; });
}

}  // namespace geodrome::bench
