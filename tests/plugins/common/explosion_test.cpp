// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "geodrome/errors.hpp"
#include "plugins/common/exact/vertex_propagation.hpp"

namespace geodrome::test {
namespace {

struct VertexStep {
  Index vertex = no_index;
};

/// A queue that never empties.
struct Endless {
  bool empty() const { return false; }
  void push_vertex(Index, double) {}
};

/// A propagation that carries a thousand lines a step, for ever.
class Exploding : public VertexPropagation<Exploding, VertexStep> {
 public:
  explicit Exploding(const PackedMesh& surface) : VertexPropagation(surface) {}
  std::uint64_t carried() const { return carried_; }

 private:
  friend VertexPropagation;
  Endless& waiting() { return waiting_; }
  void next() { carried_ += 1000; }
  void send_wedge(const Apex&, const PseudoSource&, double, Entry) {}

  Endless waiting_;
  std::uint64_t carried_ = 0;
};

TEST(ExplodingPropagation, IsRefusedWithTheReason) {
  const PackedMesh surface(std::make_shared<const SurfaceMesh>(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                                               std::vector<Triangle>{{0, 1, 2}}));
  Exploding propagation(surface);
  QuietContext context;
  try {
    propagation.run(context, [] { return infinity; });
    FAIL() << "nothing was thrown";
  } catch (const NumericalError& error) {
    EXPECT_NE(error.message().find("multiply"), std::string::npos) << error.what();
    EXPECT_FALSE(error.remedy().empty());
  }
  EXPECT_LE(propagation.carried(), most_carried(1) + 256 * 1000);  // seen at the next poll
}

}  // namespace
}  // namespace geodrome::test
