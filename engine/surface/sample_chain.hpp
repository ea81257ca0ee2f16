// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geodrome/engine/pipeline.hpp"

namespace geodrome {

/// Stages 1 to 4 on one sample, for one choice of plugins after another. What a choice shares with an earlier one, from
/// stage 1 on, is not computed again: its result, its record with the seconds it took then, or its refusal is used.
/// Keeps the results of all stages that ran.
class SampleChain {
 public:
  /// All must outlive it. `settings.stages` is not used. `among`: the points that take part, ascending, or none for
  /// all; stage 1 sees no others, later stages see the others as dropped.
  SampleChain(const Input& input, const PluginHost& host, const RunSettings& settings, Observer& observer,
              std::vector<Index> among = {});

  /// As `try_surface` with `choice` (its solver does not count), and the same errors. All four plugins are loaded
  /// before the first of them runs. The same call gives the same.
  SurfaceAttempt make(const StageChoice& choice);

 private:
  struct Planes {
    Tangents tangents;
    PointSample smoothed;
  };
  /// A Reconstruction whose parts several surfaces share.
  struct Built {
    MeshPtr mesh;
    std::vector<Index> sample_of_vertex;
    std::vector<Finding> findings;
    std::shared_ptr<const PointInserter> inserter;
  };
  /// The outcome of one stage: a value, or the exception that it threw, and the records that it left.
  template <class Value>
  struct Outcome {
    std::optional<Value> value;
    std::exception_ptr failure;
    std::vector<StageRecord> records;
  };
  /// Outcomes by the choices up to their stage.
  template <class Value>
  using Outcomes = std::map<std::string, Outcome<Value>>;

  Tangents estimate(const TangentEstimator& stage, RunContext& context) const;
  template <class Value, class Make>
  const Value& once(Outcomes<Value>& known, const std::string& key, std::vector<StageRecord>& records, Make&& make);
  const Planes& planes(const std::string& key, const Plugin<TangentEstimator>& plugin,
                       std::vector<StageRecord>& records);
  const Control& control(const std::string& key, const Plugin<ControlFunction>& plugin, const Planes& planes,
                         std::vector<StageRecord>& records);
  const std::vector<Index>& kept(const std::string& key, const Plugin<Decimator>& plugin, const SampleStages& made,
                                 std::vector<StageRecord>& records);
  const Built& built(const std::string& key, const Plugin<SurfaceReconstructor>& plugin, const SampleStages& made,
                     std::vector<StageRecord>& records);
  void run(const StageChoice& choice, PlacedSurface& surface);

  const Input& input_;
  const PluginHost& host_;
  const RunSettings& settings_;
  Observer& observer_;
  PointSample sample_;
  std::vector<Index> among_;
  Outcomes<Planes> planes_;
  Outcomes<Control> controls_;
  Outcomes<std::vector<Index>> kept_;
  Outcomes<Built> built_;
};

}  // namespace geodrome
