// SPDX-License-Identifier: MIT
#include "tests/fuzzing/found.hpp"

namespace geodrome::fuzzing {

using namespace std::string_view_literals;

std::span<const Found> found_inputs() {
  static constexpr Found all[] = {
      {"ply", "the name of an element is shown as it stands",
       "\000ply\nformat ascii 1.0\nelement \033[2J 9\nproperty int a\nelement vertex 0\nproperty int x\nproperty int "
       "y\n"
       "property int z\nend_header\n"sv},
      {"ply", "the name of a property is shown as it stands",
       "\000ply\nformat ascii 1.0\nelement vertex 3\nproperty int x\nproperty int y\nproperty int z\nelement face 1\n"
       "property list uchar int vertex_index\nproperty int weight\007\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 4\n"sv},
      {"descriptor", "a boolean option that is neither on nor off",
       "112\n2\nsolver\nown\ns\nMIT\n0\n0\n1\n0\nsmooth\n0\nyes\n0\n0\nyes|no\n\nh\n"sv},
      {"descriptor", "a whole number that is beyond all whole numbers",
       "112\n2\nsolver\nown\ns\nMIT\n0\n0\n1\n0\nk\n1\n1e300\n0\n1e301\n\n\nh\n"sv},
      {"descriptor", "a default that is a number and a comma",
       "112\n2\nsolver\nown\ns\nMIT\n0\n0\n1\n0\ndelta\n2\n0.,\n0\n1\n\n\nh\n"sv},
      {"descriptor", "a choice that nobody can write, since it has a comma",
       "112\n2\nsolver\nown\ns\nMIT\n0\n0\n1\n0\nrule\n3\nfast\n0\n0\nfast|slow,exact\n\nh\n"sv},
  };
  return all;
}

}  // namespace geodrome::fuzzing
