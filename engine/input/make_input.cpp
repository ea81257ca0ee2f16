// SPDX-License-Identifier: MIT
#include "engine/input/check_soup.hpp"

namespace geodrome {

namespace {

using namespace input;

template <class Element>
std::string_view bytes_of(std::span<const Element> elements) {
  return {reinterpret_cast<const char*>(elements.data()), elements.size_bytes()};
}

void check_arrays(const Arrays& arrays, const ReadOptions& options) {
  const Origin origin = Origin::arrays();
  if (!arrays.vertex_mask.empty() || !arrays.face_mask.empty())
    throw CapabilityError("a mask is given, and this version measures on whole surfaces only",
                          "leave the mask empty, and leave out the faces that no path may cross");
  if (!options.weights.empty())
    throw OptionError("`ReadOptions::weights` names weights of a file, and the input is in memory",
                      "give them as `Arrays::weights`");
  if (!options.columns.empty())
    throw OptionError("`ReadOptions::columns` chooses columns of a file, and the input is in memory",
                      "leave the choice of columns out");
  if (arrays.positions.size() >= no_index || arrays.faces.size() >= no_index)
    origin.reject(InputFault::unsupported, "positions or faces are more than 32 bits count");
  if (!arrays.weights.empty() && arrays.weights.size() != arrays.faces.size())
    origin.reject(InputFault::index,
                  "weights has " + std::to_string(arrays.weights.size()) + " entries, but faces has " +
                      std::to_string(arrays.faces.size()),
                  "give one weight for each face");
}

Soup soup_of(const Arrays& arrays) {
  const std::size_t count = arrays.positions.size();
  Soup soup{.format = "arrays"};
  soup.positions.assign(arrays.positions.begin(), arrays.positions.end());
  for (std::size_t f = 0; f < arrays.faces.size(); ++f) {
    for (const Index corner : arrays.faces[f])
      if (corner >= count)
        Origin::arrays().reject(InputFault::index, Origin::arrays().face(f) + " names positions[" +
                                                       std::to_string(corner) + "], but there are " +
                                                       std::to_string(count) + " positions");
    soup.corners.insert(soup.corners.end(), arrays.faces[f].begin(), arrays.faces[f].end());
    soup.face_end.push_back(soup.corners.size());
  }
  soup.face_weights.assign(arrays.weights.begin(), arrays.weights.end());
  return soup;
}

}  // namespace

Input make_input(const Arrays& arrays, const ReadOptions& options) {
  check_arrays(arrays, options);
  // The two hashes are hashed, so that no byte can move from one array to the other unseen.
  const std::string hash =
      content_hash(content_hash(bytes_of(arrays.positions)) + content_hash(bytes_of(arrays.faces)));
  return check_soup(Origin::arrays(), options, soup_of(arrays), hash);
}

}  // namespace geodrome
