// SPDX-License-Identifier: MIT
// Files of weights. The first byte: 1 other line ends; the rest of it: how many faces there are.
#include "engine/input/weights.hpp"

#include "engine/formats/number_text.hpp"
#include "tests/fuzzing/memory_file.hpp"
#include "tests/fuzzing/target.hpp"

namespace geodrome::fuzzing {
namespace {

const MemoryFile& weights_file() {
  static const MemoryFile file;
  return file;
}

std::vector<double> weights_in(std::string_view text, std::size_t faces) {
  weights_file().hold(text);
  input::Soup soup;
  soup.corners.resize(3 * faces);
  Input input;
  for (Index f = 0; f < faces; ++f) soup.face_end.push_back(3 * (f + 1)), input.face_of_triangle.push_back(f);
  input::use_weights(input::Origin("m.off"), weights_file().path(), soup, input);
  return input.weights;
}

}  // namespace

void check_weights(std::string_view input) {
  const Choices choices(input);
  const std::string_view text = rest_of(input);
  const std::size_t faces = choices.bits(1, 7);
  const auto weights = read_or_refusal(weights_file().path(), text, [&] { return weights_in(text, faces); });
  if (!weights) return;
  demand(weights->size() == faces, "every face has a weight");
  std::string written;
  for (const double weight : *weights) {
    demand(weight >= 1e-100 && weight <= 1e100, "weights are positive and in range");
    written += number_text(weight) + "\n";
  }
  if (faces > 0) demand(weights_in(written, faces) == *weights, "weights that are written read back");
  if (choices.bit(0) && text.find('\r') == text.npos)
    demand(weights_in(with_windows_line_ends(text), faces) == *weights, "line ends of Windows change nothing");
}

std::vector<std::string> weight_seeds() {
  const auto of = [](int faces, const std::string& text) { return static_cast<char>(2 * faces + 1) + text; };
  return {of(1, "2.5\n"), of(3, "1\n# c\n1e-3\n\n+7e99 # d"), of(2, "1e100\r1e-100\r"),
          of(2,
             "\xEF\xBB\xBF"
             "0.5\n4\n"),
          of(0, "# none\n")};
}

}  // namespace geodrome::fuzzing
