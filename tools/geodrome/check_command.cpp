// SPDX-License-Identifier: MIT
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "engine/report/finding_text.hpp"
#include "engine/report/json.hpp"

namespace geodrome::cli {

namespace {

struct Arguments {
  std::filesystem::path input;
  ReadOptions read;
  bool json = false;
};

void print(const Input& input) {
  const InputFacts& f = input.facts;
  const bool mesh = input.kind == InputKind::mesh;
  std::cout << input.file.string() << ": " << input.format << ", " << f.rows << (mesh ? " vertices, " : " points, ");
  if (mesh) {
    std::cout << input.triangles.size() << " triangles, " << f.components
              << (f.components == 1 ? " component, " : " components, ") << f.boundary_loops
              << (f.boundary_loops == 1 ? " boundary loop, " : " boundary loops, ")
              << (f.manifold ? "manifold, " : "nonmanifold, ")
              << (f.oriented     ? "oriented, "
                  : f.orientable ? "not oriented, "
                                 : "not orientable, ");
    if (f.genus) std::cout << "genus " << *f.genus << ", ";
  }
  std::cout << "diagonal " << f.bounding_box_diagonal << "\n";
  for (const Finding& finding : input.findings)
    std::cout << (finding.severity == Finding::Severity::note ? "note: " : "warning: ") << text_of(finding) << "\n";
}

int run(const Arguments& arguments) {
  try {
    const Input input = read_input(arguments.input, arguments.read);
    if (!arguments.json)
      print(input);
    else
      std::cout << text_of(Json{{"usable", true}, {"input", to_json(input)}}) << "\n";
    return 0;
  } catch (const InputError& error) {
    if (!arguments.json) throw;
    const Json what{{"fault", name(error.fault())}, {"message", error.message()}, {"remedy", error.remedy()}};
    std::cout << text_of(Json{{"usable", false}, {"file", arguments.input.string()}, {"error", what}}) << "\n";
    return exit_status(error);
  }
}

}  // namespace

void add_check(CLI::App& app, Action& action) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App& command =
      *app.add_subcommand("check", "What a file holds and what is wrong with it; status 3 if it cannot be used");
  add_input(command, arguments->input);
  add_read_options(command, arguments->read);
  command.add_flag("--json", arguments->json, "As JSON on standard output");
  command.callback([&action, arguments] { action = [arguments] { return run(*arguments); }; });
}

}  // namespace geodrome::cli
