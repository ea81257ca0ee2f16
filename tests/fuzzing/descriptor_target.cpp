// SPDX-License-Identifier: MIT
// What a plugin says of itself: its descriptor, and the answer of `geodrome-vet` that carries it to the host.
#include <charconv>
#include <cmath>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>

#include "engine/formats/number_text.hpp"
#include "engine/host/handshake.hpp"
#include "engine/host/plugin_json.hpp"
#include "engine/host/vetting.hpp"
#include "geodrome/engine/plugin_text.hpp"
#include "tests/fuzzing/target.hpp"
#include "tools/vet/descriptor.hpp"

namespace geodrome::fuzzing {
namespace {

double factor_now = 1;
bool offers_any_extension = false;

double factor_of_all(const OptionValues*) noexcept { return factor_now; }
void* create_none(const OptionValues*, const ErrorSink*) noexcept { return nullptr; }
void destroy_none(void*) noexcept {}
const void* extension_of_all(const char*) noexcept { return offers_any_extension ? &offers_any_extension : nullptr; }

/// A descriptor from text: a field a line; the word NULL is a null pointer. Options take eight fields each.
class DescriptorText {
 public:
  explicit DescriptorText(std::string_view text) : rest_(text) {
    plugin_ = {.size = static_cast<std::uint32_t>(number()),
               .interface_version = static_cast<std::uint32_t>(number()),
               .build_tag = build_tag,
               .stage = field(),
               .name = field(),
               .summary = field(),
               .licence = field(),
               .needs = Needs{number()},
               .provides = Provides{number()}};
    factor_now = real();
    offers_any_extension = number() != 0;
    while (!rest_.empty() && options_.size() < 20)
      options_.push_back(
          {field(), static_cast<OptionType>(number()), field(), real(), real(), field(), field(), field()});
    plugin_.options = options_.empty() ? nullptr : options_.data();
    plugin_.option_count = options_.size();
    plugin_.factor = factor_of_all, plugin_.create = create_none, plugin_.destroy = destroy_none;
    plugin_.extension = extension_of_all;
  }
  const PluginDescriptor& plugin() const { return plugin_; }

 private:
  const char* field() {
    const std::string_view line = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(rest_.size(), line.size() + 1));
    if (line == "NULL") return nullptr;
    strings_.push_back(std::make_unique<std::string>(line));
    return strings_.back()->c_str();
  }
  template <class Number>
  Number parsed() {
    const char* text = field();
    Number value = 0;
    if (text) std::from_chars(text, text + std::strlen(text), value);
    return value;
  }
  std::uint64_t number() { return parsed<std::uint64_t>(); }
  double real() { return parsed<double>(); }

  std::string_view rest_;
  std::vector<std::unique_ptr<std::string>> strings_;
  std::vector<OptionSpec> options_;
  PluginDescriptor plugin_{};
};

void demand_usable(const OptionSpec& spec, const OptionValues& values) {
  if (spec.type == OptionType::boolean) values.boolean(spec.name);
  if (spec.type == OptionType::integer) {
    const auto whole = static_cast<double>(values.integer(spec.name));
    demand(whole >= spec.minimum && whole <= spec.maximum, "a whole number is in its range");
  }
  if (spec.type == OptionType::number) demand(!std::isnan(values.number(spec.name)), "a number is one");
  if (spec.type != OptionType::choice) return;
  demand(choice_index(spec.choices, values.text(spec.name)) != no_choice, "a choice is one of its words");
  for (std::string_view rest = spec.choices;;) {
    const std::string word(rest.substr(0, rest.find('|')));
    const OptionValues chosen({&spec, 1}, std::string(spec.name) + "=" + word);
    demand(chosen.text(spec.name) == word, "every choice can be written");
    if (word.size() == rest.size()) return;
    rest.remove_prefix(word.size() + 1);
  }
}

nlohmann::json answer_with(const PluginInfo& info) {
  return {{"interface_version", interface_version}, {"build_tag", build_tag}, {"plugin", info}};
}

ChildEnd ended(int status, std::string out) { return {.exited = true, .status = status, .out = std::move(out)}; }

/// What the host learns is what the plugin said.
void demand_carried(const PluginInfo& info) {
  const std::string text = answer_with(info).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const auto learned = read_answer("p.so", ended(0, text));
  demand(std::holds_alternative<PluginInfo>(learned), "the answer on a plugin is one");
  demand(
      answer_with(std::get<PluginInfo>(learned)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) == text,
      "the host learns what the plugin said");
  demand(nlohmann::json::accept(json_text(std::get<PluginInfo>(learned))), "what is shown of a plugin is JSON");
}

}  // namespace

void check_descriptor(std::string_view input) {
  const DescriptorText text(input);
  if (const auto fault = handshake_fault(&text.plugin())) {
    demand(!fault->empty(), "a refusal says why");
    return;
  }
  const PluginDescriptor whole = whole_descriptor(text.plugin());
  try {
    const PluginInfo info = checked_info(whole);
    demand(info.default_factor >= 1, "a factor is at least 1");
    const std::span specs(whole.options, whole.option_count);
    const OptionValues defaults(specs);
    for (const OptionSpec& spec : specs) demand_usable(spec, defaults);
    demand_carried(info);
  } catch (const PluginError& error) {
    demand(!error.message().empty(), "a refusal says why");
  }
}

/// The first byte: 1 for the exit status of a refusal.
void check_vet_answer(std::string_view input) {
  const int status = Choices(input).bit(0) ? 1 : 0;
  try {
    const auto answer = read_answer("p.so", ended(status, std::string(rest_of(input))));
    if (const auto* info = std::get_if<PluginInfo>(&answer)) demand_carried(*info);
  } catch (const PluginError& error) {  // of another version
    demand(!error.remedy().empty(), "a refusal says what to do");
  } catch (const nlohmann::json::exception&) {  // no answer, which `vet` takes for a bad end of the plugin
  }
}

std::vector<std::string> descriptor_seeds() {
  const std::string head = std::to_string(sizeof(PluginDescriptor)) + "\n" + std::to_string(interface_version) + "\n";
  const std::string solver = head + "solver\nown\nwhat it does\nMIT\n1\n33\n";
  return {solver + "1\n0\n",
          solver + "inf\n0\nk\n1\n20\n6\n400\n\npoints\nneighbours\nsmooth\n0\non\n0\n0\non|off\n\nmoves\n",
          solver + "1.5\n0\ndelta\n2\n0.1\n0\ninf\n\n\naccuracy\nrule\n3\nfast\n0\n0\nfast|exact\n\nthe rule\n",
          head + "tangent\nnULL\nNULL\nMIT\n0\n0\n1\n1\n",
          std::to_string(smallest_descriptor) + "\n2\ncontrol\nsmall\ns\nl\n0\n0\n1\n0\n"};
}

std::vector<std::string> vet_answer_seeds() {
  std::vector<std::string> seeds;
  for (const std::string& text : descriptor_seeds()) {
    const DescriptorText descriptor(text);
    if (handshake_fault(&descriptor.plugin())) continue;
    try {
      seeds.push_back(std::string(1, '\0') + answer_with(checked_info(whole_descriptor(descriptor.plugin()))).dump());
    } catch (const PluginError& error) {
      const nlohmann::json refusal{
          {"interface_version", interface_version}, {"build_tag", build_tag}, {"refused", error.what()}};
      seeds.push_back(std::string(1, '\1') + refusal.dump());
    }
  }
  return seeds;
}

}  // namespace geodrome::fuzzing
