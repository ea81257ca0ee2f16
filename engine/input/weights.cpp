// SPDX-License-Identifier: MIT
#include "engine/input/weights.hpp"

#include <cmath>

#include "engine/formats/line_reader.hpp"
#include "engine/formats/text_stream.hpp"
#include "engine/input/findings.hpp"

namespace geodrome::input {
namespace {

// As for coordinates: products of a length and a weight, and their squares, must stay in double's range.
constexpr double largest = 1e100, smallest = 1e-100;

/// What is wrong with a weight; empty if nothing is.
std::string fault_of(double weight) {
  TextOutput text;
  text << weight;
  if (!std::isfinite(weight)) return "the weight " + text.str() + " is not finite";
  if (!(weight > 0)) return "the weight " + text.str() + " is not positive";
  if (weight > largest || weight < smallest) return "the weight " + text.str() + " is not from 1e-100 to 1e100";
  return {};
}

InputFault kind_of(double weight) { return std::isfinite(weight) ? InputFault::range : InputFault::nonfinite; }

const char* const remedy = "give every face a positive, finite number";

/// `whose`: what messages call the weight of a face.
template <class Whose>
void check_weights(const Origin& origin, const std::vector<double>& weights, Whose&& whose) {
  for (std::size_t f = 0; f < weights.size(); ++f)
    if (const std::string fault = fault_of(weights[f]); !fault.empty())
      origin.reject(kind_of(weights[f]), whose(f) + ": " + fault, remedy);
}

/// One number a line, checked.
std::vector<double> read_numbers(const SourceFile& file) {
  std::vector<double> weights;
  LineReader lines(file, {.comment = '#'});
  while (lines.next()) {
    const double weight = lines.number();
    if (!lines.word().empty()) lines.reject(InputFault::syntax, "the line holds more than one weight", "one a line");
    if (const std::string fault = fault_of(weight); !fault.empty())
      lines.reject(kind_of(weight), fault + ", of face " + std::to_string(weights.size()) + " (from 0)", remedy);
    weights.push_back(weight);
  }
  return weights;
}

std::vector<double> read_weights(const std::filesystem::path& path, const Origin& input, std::size_t faces) {
  const SourceFile file = read_source(path);
  std::vector<double> weights = read_numbers(file);
  if (weights.size() != faces)
    reject(file, InputFault::index,
           "holds " + counted(weights.size(), "weight", "weights") + ", but " + input.file().string() + " has " +
               counted(faces, "face", "faces"),
           "give one number a line for each face of the input, in its order");
  return weights;
}

std::string hash_of(const std::vector<double>& weights) {
  return content_hash({reinterpret_cast<const char*>(weights.data()), weights.size() * sizeof(double)});
}

}  // namespace

WeightChoice weight_choice(const std::string& option) {
  constexpr std::string_view prefix = "property:";
  if (!option.starts_with(prefix)) return {{}, option};
  if (option.size() == prefix.size())
    throw OptionError("weights 'property:' name no property", "write property:NAME, or the name of a file");
  return {option.substr(prefix.size()), {}};
}

void use_weights(const Origin& origin, const std::string& option, Soup& soup, Input& input) {
  const WeightChoice choice = weight_choice(option);
  std::vector<double> of_face;
  if (!choice.file.empty()) {
    of_face = read_weights(choice.file, origin, soup.face_count());
  } else {
    of_face = std::move(soup.face_weights);
    check_weights(origin, of_face, [&](std::size_t f) {
      if (!origin.is_file()) return "weights[" + std::to_string(f) + "]";
      return "face " + std::to_string(f) + " (from 0), property '" + choice.property + "'";
    });
  }
  if (of_face.empty()) return;
  for (const Index face : input.face_of_triangle) input.weights.push_back(of_face[face]);
  input.weights_from = origin.is_file() ? option : "weights";
  input.weights_hash = hash_of(input.weights);
}

void reject_weights_of_points(const Origin& origin) {
  origin.reject(InputFault::unsupported, "weights are numbers of faces, but the input is points",
                "leave the weights out, or give a mesh");
}

}  // namespace geodrome::input

namespace geodrome {

std::filesystem::path weights_file(const ReadOptions& options) { return input::weight_choice(options.weights).file; }

}  // namespace geodrome
