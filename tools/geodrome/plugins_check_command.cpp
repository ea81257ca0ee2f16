// SPDX-License-Identifier: MIT
#include <algorithm>
#include <future>
#include <iomanip>
#include <iostream>
#include <memory>
#include <semaphore>

#include "geodrome/conformance.hpp"
#include "tools/geodrome/commands.hpp"

namespace geodrome::cli {

namespace {

using conformance::Demand;
using conformance::Outcome;
using conformance::Subject;
using conformance::Verdict;

struct JudgeArguments {
  RunSettings settings;
  std::string selection, only;
  std::vector<std::filesystem::path> meshes;
  conformance::Limits limits;
  bool json = false;
};

const char* word(Outcome outcome) {
  switch (outcome) {
    case Outcome::held:
      return "held";
    case Outcome::failed:
      return "FAILED";
    default:
      return "n/a";
  }
}

/// The demands of the plugin's stage that begin with `only`.
std::vector<Demand> chosen(const Subject& subject, const std::string& only) {
  std::vector<Demand> all = conformance::demands(subject.plugin.stage);
  std::erase_if(all, [&](const Demand& demand) { return !demand.name.starts_with(only); });
  if (all.empty())
    throw OptionError("--only '" + only + "': no demand on a " + subject.plugin.stage + " plugin begins so",
                      "leave it out to see all demands");
  return all;
}

/// All verdicts in the order of the demands, judged by as many children at a time as there are threads. `tell` gets
/// each as soon as it and those before it are there.
template <class Tell>
std::vector<Verdict> judge_all(const Subject& subject, const std::vector<Demand>& all, const JudgeArguments& arguments,
                               Tell&& tell) {
  std::counting_semaphore<> free(thread_count(arguments.settings));
  std::vector<std::future<Verdict>> running;
  // Where the system gives no more threads, a demand is judged when its verdict is wanted.
  for (const Demand& demand : all)
    running.push_back(std::async(std::launch::async | std::launch::deferred, [&] {
      free.acquire();
      const std::unique_ptr<std::counting_semaphore<>, void (*)(std::counting_semaphore<>*)> release(
          &free, [](std::counting_semaphore<>* s) { s->release(); });
      return conformance::judge_in_child(subject, demand.name, arguments.limits);
    }));
  std::vector<Verdict> verdicts;
  for (auto& future : running) {
    verdicts.push_back(future.get());
    tell(verdicts.back());
  }
  return verdicts;
}

void print(const Verdict& verdict) {
  const bool applies = verdict.outcome != Outcome::not_applicable;
  std::cout << std::left << std::setw(8) << word(verdict.outcome) << std::setw(30) << verdict.demand.name
            << (applies ? verdict.demand.sentence : verdict.found) << "\n";
  if (verdict.outcome != Outcome::failed) return;
  if (!verdict.where.empty()) std::cout << "          where     " << verdict.where << "\n";
  std::cout << "          expected  " << verdict.expected << "\n          found     " << verdict.found << "\n";
  if (verdict.failures > 1)
    std::cout << "          (and " << verdict.failures - 1 << " more of " << verdict.checks << " checks)\n";
}

std::size_t count(const std::vector<Verdict>& verdicts, Outcome outcome) {
  return static_cast<std::size_t>(
      std::ranges::count_if(verdicts, [&](const Verdict& verdict) { return verdict.outcome == outcome; }));
}

/// The exit status of a plugin that does not keep its contract: that of what is refused.
constexpr int not_conforming = 4;

int judge_plugin(const JudgeArguments& arguments) {
  Subject subject = conformance::find_subject(arguments.selection, arguments.settings.plugin_path);
  subject.meshes = arguments.meshes;
  const std::vector<Demand> all = chosen(subject, arguments.only);
  if (!arguments.json) std::cout << subject.plugin.full_name() << " from " << subject.plugin.file.string() << "\n";
  const std::vector<Verdict> verdicts = judge_all(subject, all, arguments, [&](const Verdict& verdict) {
    if (!arguments.json) print(verdict), std::cout.flush();
  });
  const std::size_t failed = count(verdicts, Outcome::failed);
  if (arguments.json)
    std::cout << conformance::json_text(subject, verdicts) << "\n";
  else
    std::cout << subject.plugin.full_name() << ": " << count(verdicts, Outcome::held) << " held, " << failed
              << " failed, " << count(verdicts, Outcome::not_applicable) << " not applicable\n";
  return failed > 0 ? not_conforming : 0;
}

}  // namespace

void add_plugins_check(CLI::App& plugins, Action& action) {
  const auto [command, arguments] =
      add_command(plugins, action, "check",
                  "Judges whether a plugin keeps the contract of its stage, each demand in a process of its own. Exit "
                  "status 4 if it does not",
                  judge_plugin);
  command.add_option("PLUGIN", arguments.selection, "A name or the path of a file, with options: NAME[:k=v,...]")
      ->required();
  command.add_option("--mesh", arguments.meshes, "A further mesh that a solver is judged on (may be repeated)")
      ->type_name("FILE")
      ->check(CLI::ExistingFile)
      ->allow_extra_args(false);
  command.add_option("--only", arguments.only, "Only demands whose names begin so: 'paths' or 'distances.cube'")
      ->type_name("PREFIX");
  command.add_option("--timeout", arguments.limits.seconds, "Seconds that one demand may take")
      ->check(number_from_to(0.001, 86400))
      ->capture_default_str();
  command.add_option("--memory", arguments.limits.megabytes, "Megabytes of address space that one demand may take")
      ->check(whole_number_up_to(1'000'000'000))
      ->capture_default_str();
  command.add_flag("--json", arguments.json, "As JSON on standard output");
  add_plugin_path(command, arguments.settings.plugin_path);
  add_threads(command, arguments.settings.threads, "Demands judged at a time; 0: one per core");
}

}  // namespace geodrome::cli
