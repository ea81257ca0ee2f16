// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "geodrome/options.hpp"
#include "geodrome/surface_reconstructor.hpp"

namespace geodrome {

class DelaunayCut final : public SurfaceReconstructor {
 public:
  static constexpr std::array<OptionSpec, 2> options{
      choice_option("boundary", "auto", "auto|closed|open",
                    "auto: holes that the sample shows stay open; closed: they are an error; open: every face too large for psi is left out"),
      choice_option("stars", "refuse", "refuse|allow", "what to do when over 20 % of the star triangles are inconsistent")};

  explicit DelaunayCut(const OptionValues& values) : boundary_(values.text("boundary")), allow_stars_(values.text("stars") == "allow") {}

  Reconstruction reconstruct(const PointSample& sample, const Tangents& tangents, const Control& control,
                             std::span<const Index> kept, RunContext& context) const override;

 private:
  std::string boundary_;
  bool allow_stars_;
};

}  // namespace geodrome
