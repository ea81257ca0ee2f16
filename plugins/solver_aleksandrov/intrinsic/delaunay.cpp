// SPDX-License-Identifier: MIT
#include "plugins/solver_aleksandrov/intrinsic/delaunay.hpp"

namespace geodrome::aleksandrov {
namespace {

/// Ties stay as they are, whatever rounding makes of them.
constexpr double tie = 1e-10;

bool wants_flip(const IntrinsicTriangulation& t, Index h, Index g) {
  const auto &f = t.face(h / 3), &k = t.face(g / 3);
  const int i = static_cast<int>(SurfaceMesh::previous(h) % 3), j = static_cast<int>(SurfaceMesh::previous(g) % 3);
  const double sines = f.sine[i] * k.sine[j], cosines = f.cosine[i] * k.cosine[j];
  // Beyond 3/2 pi: the sine goes back to 0 where two flat caps stand on one edge.
  if (f.cosine[i] < 0 && k.cosine[j] < 0 && cosines > sines) return true;
  return f.sine[i] * k.cosine[j] + f.cosine[i] * k.sine[j] < -tie;  // the sine of the sum
}

}  // namespace

void flip_until_delaunay(IntrinsicTriangulation& t, std::vector<Index>& stack, std::vector<Index>& changed,
                         const RunContext& context) {
  for (std::size_t step = 1; !stack.empty(); ++step) {
    if (step % 4096 == 0) context.throw_if_cancelled();
    const Index h = stack.back(), g = t.flat_twin(h);
    stack.pop_back();
    if (g == no_index || !wants_flip(t, h, g)) continue;
    const Index f = h / 3, k = g / 3;
    t.flip(h);
    changed.push_back(f), changed.push_back(k);
    for (const Index i : {3 * f + 1, 3 * f + 2, 3 * k + 1, 3 * k + 2}) stack.push_back(i);
  }
}

void make_delaunay(IntrinsicTriangulation& t, const RunContext& context) {
  std::vector<Index> stack, changed;
  for (Index h = 3 * t.face_count(); h-- > 0;) stack.push_back(h);
  flip_until_delaunay(t, stack, changed, context);
}

}  // namespace geodrome::aleksandrov
