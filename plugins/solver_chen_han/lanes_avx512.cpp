// SPDX-License-Identifier: MIT
#include "plugins/common/exact/register_avx512.hpp"
#include "plugins/solver_chen_han/lanes_body.hpp"

namespace geodrome::chen_han {
extern const Lanes avx2_lanes;
extern const Lanes avx512_lanes;

namespace {

// Roots and quotients of eight take twice as long as those of four.
constexpr std::size_t narrow = 4;

void carry_wide(const WindowArrays& in, std::size_t count, const Turn& turn, const Clip& clip,
                const WindowArrays& out) {
  return (count <= narrow ? avx2_lanes.carry : carry<8>)(in, count, turn, clip, out);
}
Trimmed cut_wide(const WindowArrays& windows, std::size_t count) {
  return (count <= narrow ? avx2_lanes.cut : cut<8>)(windows, count);
}
Parting part_wide(const WindowArrays& windows, std::size_t count, double x, double y) {
  return part<8>(windows, count, x, y);
}

}  // namespace

const Lanes avx512_lanes{carry_wide, cut_wide, part_wide};
}  // namespace geodrome::chen_han
