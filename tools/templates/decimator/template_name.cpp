// A decimator to start from: in the order of the sample, a point is kept unless a kept one has it within its psi
// (Algorithm 1 of the paper). O(n m) for m kept points. Replace what is in `select` by your method.
#include <algorithm>
#include <geodrome/plugin.hpp>

using namespace geodrome;

namespace {

class TemplateName : public Decimator {
 public:
  std::vector<Index> select(const PointSample& sample, const Control& control, RunContext& context) const override {
    std::vector<Index> kept;
    for (Index i = 0; i < sample.size(); ++i) {
      context.throw_if_cancelled();
      if (control.state[i] == PointState::dropped) continue;
      const bool covered = std::ranges::any_of(
          kept, [&](Index k) { return distance(sample.points[i], sample.points[k]) <= control.psi[k]; });
      if (!covered) kept.push_back(i);
      context.progress(static_cast<double>(i + 1) / static_cast<double>(sample.size()));
    }
    return kept;
  }
};

}  // namespace

GEODROME_PLUGIN(TemplateName, .name = "template_name", .summary = "keeps points outside of each other's psi",
                .licence = "MIT")
