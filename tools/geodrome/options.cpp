// SPDX-License-Identifier: MIT
#include "tools/geodrome/commands.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

namespace geodrome::cli {

namespace {

constexpr const char* sample_group = "Stages for point samples";
constexpr const char* run_group = "Run";

/// More threads than any machine has; a system that gives fewer is no error.
constexpr std::uint64_t most_threads = 1'000'000;

constexpr const char* weld_flag = "--weld";

/// As the engine has it.
constexpr double largest_tolerance = 1e100;

/// The whole text as a number, or the reason why it is none.
template <class Number>
std::string out_of_range(const std::string& text, Number low, Number high, const std::string& wanted) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool inside = value >= low && value <= high;  // false for NaN
  if (error == std::errc() && end == text.data() + text.size() && inside) return {};
  return "'" + text + "' is not " + wanted;
}

}  // namespace

void fill_in_values(std::vector<std::string>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i] != weld_flag) continue;
    const bool has_value = i + 1 < words.size() && out_of_range(words[i + 1], -infinity, infinity, "").empty();
    if (!has_value) words.insert(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, "0");
  }
}

void add_input(CLI::App& command, std::filesystem::path& file) {
  command.add_option("INPUT", file, help_for_input())->required();
}

void add_read_options(CLI::App& command, ReadOptions& read) {
  const auto set_kind = [&read](const std::string& word) {
    read.as = word == "mesh" ? InputKind::mesh : InputKind::points;
  };
  command
      .add_option_function<std::string>("--as", set_kind,
                                        "Take the input as 'points' or 'mesh' (default: a mesh if it has faces)")
      ->check(CLI::IsMember({"points", "mesh"}))
      ->type_name("KIND");
  const auto set_weld = [&read](const std::string& tolerance) {
    read.weld = true;
    std::from_chars(tolerance.data(), tolerance.data() + tolerance.size(), read.weld_tolerance);
  };
  command
      .add_option_function<std::string>(weld_flag, set_weld,
                                        "Merge mesh vertices that are at exactly the same place, or no farther apart "
                                        "than TOLERANCE, in the units of the input")
      ->check(number_from_to(0, largest_tolerance))
      ->type_name("[TOLERANCE]");
  command
      .add_option("--weights", read.weights,
                  "Weights of the faces: property:NAME of a PLY file, or a text file with one number a line for each "
                  "face of the input. Paths cost their length times the weight; needs a solver that provides weights")
      ->check([](const std::string& text) { return std::string(text.empty() ? "it names nothing" : ""); })
      ->type_name("WEIGHTS");
  command
      .add_option("--columns", read.columns,
                  "Columns of x, y and z in a table of points: names that stand above the points, as x,y,z, or numbers "
                  "from 1, as 2,3,4 (default: those named x, y and z, else the first three)")
      ->type_name("COLUMNS");
  command.add_flag("--drop-nonfinite", read.drop_nonfinite,
                   "Drop points that are NaN or infinite (their distances are NaN)");
}

void add_sample_stages(CLI::App& command, StageChoice& stages) {
  const auto add = [&](const char* flag, std::string& choice, const char* help) {
    command.add_option(flag, choice, help)->type_name("NAME[:k=v,...]")->capture_default_str()->group(sample_group);
  };
  add("--tangent", stages.tangent, "Tangent planes");
  add("--control", stages.control, "Control function psi");
  add("--decimator", stages.decimator, "Decimation of the sample");
  add("--reconstructor", stages.reconstructor, "Surface through the kept points");
}

void add_solver(CLI::App& command, StageChoice& stages, Asked asked) {
  CLI::Option* by_name = command.add_option("--solver", stages.solver, "Shortest-path solver")
                             ->type_name("NAME[:k=v,...]")
                             ->capture_default_str();
  const auto choose = [&stages, asked](const std::string& accuracy) {
    stages.solver = solver_of_accuracy(accuracy, asked);
  };
  const char* help = asked == Asked::pairs
                         ? "In place of --solver: a number from 1e-4 to 1, by which distances are at most too long"
                         : "In place of --solver: 'exact', or a number from 1e-6 to 1, as 1e-3, by which distances are "
                           "at most too long; never too short";
  command.add_option_function<std::string>("--accuracy", choose, help)->type_name("DELTA")->excludes(by_name);
}

void add_plugin_path(CLI::App& command, std::vector<std::filesystem::path>& folders) {
  command.add_option("--plugin-path", folders, "Folder searched for plugins first (may be repeated)")
      ->type_name("DIR")
      ->allow_extra_args(false)
      ->group(run_group);
}

void add_threads(CLI::App& command, unsigned& threads, const std::string& help) {
  command.add_option("--threads", threads, help)
      ->check(whole_number_up_to(most_threads))
      ->capture_default_str()
      ->group(run_group);
}

void add_part(CLI::App& command, RunSettings& settings) {
  add_choice<Part>(
      command, "--part", settings.part, {{"whole", Part::whole}, {"largest", Part::largest}},
      "Of a point sample: all of it, or the largest part that makes a surface by itself; what is not on it "
      "is NaN and counted");
}

void add_metric(CLI::App& command, RunSettings& settings) {
  add_choice<Metric>(
      command, "--metric", settings.metric, {{"flat", Metric::flat}, {"smooth", Metric::smooth}},
      "flat: on the triangles; smooth: the length of a curve on the smooth surface that the tangent estimator fits to "
      "the sample (of a mesh: to its vertices), where that is trusted; no upper bound");
}

void add_job_options(CLI::App& command, RunSettings& settings, bool& quiet) {
  add_part(command, settings);
  add_sample_stages(command, settings.stages);
  add_read_options(command, settings.read);
  add_plugin_path(command, settings.plugin_path);
  add_threads(command, settings.threads, "Threads; 0: one per core. No result depends on it");
  add_seed(command, settings);
  add_quiet(command, quiet);
}

void add_seed(CLI::App& command, RunSettings& settings) {
  command.add_option("--seed", settings.seed, "Seed of everything random")
      ->check(whole_number_up_to(std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str()
      ->group(run_group);
}

void add_quiet(CLI::App& command, bool& quiet) {
  command.add_flag("-q,--quiet", quiet, "Only warnings and errors on standard error")->group(run_group);
}

CLI::Validator number_from_to(double low, double high) {
  std::ostringstream wanted;
  wanted << "a number " << (std::isinf(high) ? ">= " : "from ") << low;
  if (std::isfinite(high)) wanted << " to " << high;
  const auto check = [low, high, words = wanted.str()](const std::string& text) {
    return out_of_range(text, low, high, words);
  };
  return CLI::Validator(check, "");
}

CLI::Validator whole_number_up_to(std::uint64_t high) {
  const auto check = [high](const std::string& text) {
    return out_of_range(text, std::uint64_t{0}, high, "a whole number from 0 to " + std::to_string(high));
  };
  return CLI::Validator(check, "");
}

}  // namespace geodrome::cli
