// SPDX-License-Identifier: MIT
#include "engine/surface/sample_chain.hpp"

#include <algorithm>

#include "engine/host/stage_context.hpp"
#include "engine/surface/input_rows.hpp"
#include "engine/surface/place.hpp"

namespace geodrome {

namespace {

/// Runs one stage: times the call, keeps the record, also of a stage that refuses the sample.
template <class Stage, class Function>
auto run_stage(const Plugin<Stage>& plugin, const RunSettings& settings, Observer& observer,
               std::vector<StageRecord>& records, Function&& function) {
  StageContext context(Stage::stage, observer, thread_count(settings), settings.seed);
  const Stopwatch watch;
  const auto record = [&] { records.push_back({plugin.info, plugin.options, watch.seconds(), context.measures()}); };
  try {
    auto result = plugin.call([&](const Stage& stage) { return function(stage, context); });
    context.throw_if_cancelled();
    record();
    return result;
  } catch (const SampleError&) {
    record();
    throw;
  }
}

/// A plugin may be anybody's: a result that breaks the interface must not travel on.
void demand(bool holds, const PluginInfo& plugin, const char* what) {
  if (!holds)
    throw PluginError(std::string("returned ") + what, "report this to the author of " + plugin.file.string());
}

void check(const Tangents& tangents, std::size_t n, const PluginInfo& plugin) {
  demand(tangents.plane.size() == n && tangents.state.size() == n, plugin, "not one tangent plane and state per point");
  for (std::size_t i = 0; i < n; ++i)
    demand(tangents.state[i] == PointState::dropped ||
               (is_finite(tangents.plane[i].origin) && is_finite(tangents.plane[i].normal)),
           plugin, "a tangent plane that is not finite");
}

void check(const Control& control, std::size_t n, const PluginInfo& plugin) {
  demand(control.phi.size() == n && control.psi.size() == n && control.state.size() == n, plugin,
         "not one phi, psi and state per point");
  for (std::size_t i = 0; i < n; ++i)
    demand(control.state[i] == PointState::dropped || (control.psi[i] > 0 && std::isfinite(control.psi[i])), plugin,
           "a psi that is not positive and finite");
}

void check(const std::vector<Index>& kept, std::size_t n, const PluginInfo& plugin) {
  const bool ascending = std::adjacent_find(kept.begin(), kept.end(), std::greater_equal<>()) == kept.end();
  demand(ascending && (kept.empty() || kept.back() < n), plugin,
         "kept points that are not ascending indices of points");
}

void check(const Reconstruction& made, std::size_t n, const PluginInfo& plugin) {
  demand(made.mesh != nullptr && made.mesh->face_count() > 0, plugin, "no surface");
  demand(made.sample_of_vertex.size() == made.mesh->vertex_count(), plugin, "not one sample point per vertex");
  for (const Index s : made.sample_of_vertex)
    demand(s == no_index || s < n, plugin, "a sample point that is not there");
  demand(made.mesh->manifold() && made.mesh->oriented(), plugin, "a surface that is no oriented 2-manifold");
  // D >= |st| would not hold there, and nobody asked for them.
  demand(made.mesh->face_weights().empty(), plugin, "a surface with weights");
}

/// What stages 2 to 4 work on: the sample as stage 1 left it.
PointSample smoothed(const PointSample& sample, const Tangents& tangents) {
  PointSample result = sample;
  for (std::size_t i = 0; i < result.size(); ++i)
    if (tangents.state[i] != PointState::dropped) result.points[i] = tangents.plane[i].origin;
  return result;
}

/// Stages count points, users count rows: two numbers where rows were merged or dropped.
void name_rows(std::vector<Finding>& findings, const std::vector<Index>& row_of) {
  for (Finding& finding : findings)
    for (Index& element : finding.elements)
      if (element < row_of.size() && row_of[element] != no_index) element = row_of[element];
}

/// Every row's closest surface point (Algorithm 2, lines 16 to 19, corrected).
std::vector<Place> project(const Input& input, const SurfaceLocator& locator, const SurfaceMesh& mesh,
                           const Control& control) {
  std::vector<Place> of_point(input.positions.size());
  for (std::size_t i = 0; i < of_point.size(); ++i) {
    of_point[i].position = input.positions[i];
    if (control.state[i] == PointState::dropped) continue;
    const SurfacePoint at = locator.closest(input.positions[i]).at;
    of_point[i] = place_on(mesh, at, input.positions[i]);
  }
  std::vector<Place> of_row;
  for (const Index i : input.element_of_row) of_row.push_back(i == no_index ? Place{} : of_point[i]);
  return of_row;
}

}  // namespace

SampleChain::SampleChain(const Input& input, const PluginHost& host, const RunSettings& settings, Observer& observer,
                         std::vector<Index> among)
    : input_(input),
      host_(host),
      settings_(settings),
      observer_(observer),
      sample_{input.positions},
      among_(std::move(among)) {}

/// Stage 1, on the points that take part.
Tangents SampleChain::estimate(const TangentEstimator& stage, RunContext& context) const {
  if (among_.empty()) return stage.estimate(sample_, context);
  PointSample part;
  for (const Index i : among_) part.points.push_back(sample_.points[i]);
  Tangents of_part = stage.estimate(part, context), all;
  if (of_part.plane.size() != part.size() || of_part.state.size() != part.size()) return of_part;  // `check` tells
  for (const Vec3& point : sample_.points) all.plane.push_back({point, {}, 0});
  all.state.assign(sample_.size(), PointState::dropped);
  all.sigma = of_part.sigma;
  for (Index k = 0; k < among_.size(); ++k)
    all.plane[among_[k]] = of_part.plane[k], all.state[among_[k]] = of_part.state[k];
  return all;
}

template <class Value, class Make>
const Value& SampleChain::once(Outcomes<Value>& known, const std::string& key, std::vector<StageRecord>& records,
                               Make&& make) {
  const auto [entry, is_new] = known.try_emplace(key);
  Outcome<Value>& outcome = entry->second;
  if (is_new) {
    try {
      outcome.value = make(outcome.records);
    } catch (const Cancelled&) {
      known.erase(entry);
      throw;
    } catch (...) {
      outcome.failure = std::current_exception();
    }
  }
  records.insert(records.end(), outcome.records.begin(), outcome.records.end());
  if (outcome.failure) std::rethrow_exception(outcome.failure);
  return *outcome.value;
}

const SampleChain::Planes& SampleChain::planes(const std::string& key, const Plugin<TangentEstimator>& plugin,
                                               std::vector<StageRecord>& records) {
  return once(planes_, key, records, [&](std::vector<StageRecord>& mine) {
    return run_stage(plugin, settings_, observer_, mine, [&](const auto& stage, RunContext& context) {
      Tangents tangents = estimate(stage, context);
      check(tangents, sample_.size(), plugin.info);
      PointSample moved = smoothed(sample_, tangents);
      return Planes{std::move(tangents), std::move(moved)};
    });
  });
}

const Control& SampleChain::control(const std::string& key, const Plugin<ControlFunction>& plugin, const Planes& planes,
                                    std::vector<StageRecord>& records) {
  return once(controls_, key, records, [&](std::vector<StageRecord>& mine) {
    return run_stage(plugin, settings_, observer_, mine, [&](const auto& stage, RunContext& context) {
      Control control = stage.evaluate(planes.smoothed, planes.tangents, context);
      check(control, sample_.size(), plugin.info);
      return control;
    });
  });
}

const std::vector<Index>& SampleChain::kept(const std::string& key, const Plugin<Decimator>& plugin,
                                            const SampleStages& made, std::vector<StageRecord>& records) {
  return once(kept_, key, records, [&](std::vector<StageRecord>& mine) {
    return run_stage(plugin, settings_, observer_, mine, [&](const auto& stage, RunContext& context) {
      std::vector<Index> kept = stage.select(made.smoothed, made.control, context);
      check(kept, sample_.size(), plugin.info);
      return kept;
    });
  });
}

const SampleChain::Built& SampleChain::built(const std::string& key, const Plugin<SurfaceReconstructor>& plugin,
                                             const SampleStages& made, std::vector<StageRecord>& records) {
  return once(built_, key, records, [&](std::vector<StageRecord>& mine) {
    return run_stage(plugin, settings_, observer_, mine, [&](const auto& stage, RunContext& context) {
      Reconstruction result = stage.reconstruct(made.smoothed, made.tangents, made.control, made.kept, context);
      check(result, sample_.size(), plugin.info);
      return Built{std::move(result.mesh), std::move(result.sample_of_vertex), std::move(result.findings),
                   std::move(result.inserter)};
    });
  });
}

void SampleChain::run(const StageChoice& choice, PlacedSurface& surface) {
  const auto tangent = host_.load<TangentEstimator>(choice.tangent);
  const auto control_function = host_.load<ControlFunction>(choice.control);
  const auto decimator = host_.load<Decimator>(choice.decimator);
  const auto reconstructor = host_.load<SurfaceReconstructor>(choice.reconstructor);
  SampleStages& made = *surface.sample;
  std::string key = choice.tangent;
  const Planes& planes = this->planes(key, tangent, surface.stages);
  made.tangents = planes.tangents, made.smoothed = planes.smoothed;
  made.control = control(key += "\n" + choice.control, control_function, planes, surface.stages);
  made.kept = kept(key += "\n" + choice.decimator, decimator, made, surface.stages);
  const Built& result = built(key += "\n" + choice.reconstructor, reconstructor, made, surface.stages);
  made.sample_of_vertex = result.sample_of_vertex;
  surface.mesh = result.mesh, surface.findings = result.findings, surface.inserter = result.inserter;
  name_rows(surface.findings, rows_of_elements(input_));
  surface.locator = std::make_shared<const SurfaceLocator>(surface.mesh);
  surface.places = project(input_, *surface.locator, *surface.mesh, made.control);
}

SurfaceAttempt SampleChain::make(const StageChoice& choice) {
  SurfaceAttempt attempt;
  attempt.surface.made_from = InputKind::points;
  attempt.surface.sample.emplace();
  try {
    run(choice, attempt.surface);
  } catch (const SampleError& error) {
    std::vector<Finding> findings = error.findings();
    name_rows(findings, rows_of_elements(input_));
    attempt.refusal.emplace(error.message(), error.coded_remedy(), std::move(findings));
    attempt.refusal->attribute_to(error.plugin());
  }
  return attempt;
}

}  // namespace geodrome
