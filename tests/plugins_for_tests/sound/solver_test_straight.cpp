// SPDX-License-Identifier: MIT
// The good one among the bad.
#include "tests/plugins_for_tests/sound/straight_solver.hpp"

namespace {

struct Settings {
  int rounds;
  double slack;
  std::string mood;
  bool loud;
};

constexpr auto options = geodrome::settings_table(
    geodrome::option("rounds", &Settings::rounds, "1", 1, 9, "", "changes nothing"),
    geodrome::option("slack", &Settings::slack, "0.5", 0, std::numeric_limits<double>::infinity(), "input units",
                     "sets the factor"),
    geodrome::option("mood", &Settings::mood, "calm", "calm|wild", "changes nothing"),
    geodrome::option("loud", &Settings::loud, "off", "changes nothing"));

double factor(const geodrome::OptionValues* values) noexcept { return 1 + options.parsed(*values).slack; }

class Solver : public geodrome::bad::StraightSolver<> {
 public:
  explicit Solver(const geodrome::OptionValues& values) {
    if (options.parsed(values).rounds == 7) throw geodrome::OptionError("7 rounds are too many", "take another number");
  }
};

}  // namespace

GEODROME_PLUGIN(Solver, .name = "test_straight", .summary = "straight through space", .licence = "MIT",
                .needs = geodrome::Needs::manifold,
                .provides = geodrome::Provides::start_distances | geodrome::Provides::face_sources, .options = options,
                .factor = factor)
