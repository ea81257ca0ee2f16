// SPDX-License-Identifier: MIT
#include "engine/jobs/part.hpp"

#include "engine/formats/remedies.hpp"
#include "engine/formats/text.hpp"
#include "engine/surface/part_surface.hpp"
#include "engine/surface/sample_chain.hpp"
#include "engine/surface/sample_part.hpp"

namespace geodrome {

namespace {

/// Passes on that work is done and whether it should end: what is said of parts that come to nothing is no news.
class Trying final : public Observer {
 public:
  explicit Trying(Observer& observer) : observer_(observer) {}
  void progress(std::string_view stage, double fraction) override { observer_.progress(stage, fraction); }
  std::string words(const Remedy& remedy) const override { return observer_.words(remedy); }
  bool cancelled() const noexcept override { return observer_.cancelled(); }

 private:
  Observer& observer_;
};

/// Share of the points that a surface may leave off: one that leaves more is not the surface of these points.
constexpr double most_off = 0.05;

class PartSearch {
 public:
  PartSearch(const Input& input, const RunSettings& settings, std::optional<double> factor)
      : input_(input), settings_(settings), factor_(factor) {}

  std::size_t points() const { return best_ ? best_->surface.part->points : 0; }

  /// `chosen`: of points that were chosen for looking like a surface.
  void weigh(SurfaceAttempt attempt, bool chosen) {
    if (attempt.refusal || !cut_to_part(input_, attempt.surface)) return;
    const SurfacePart& part = *attempt.surface.part;
    const std::size_t used = part.sample - part.no_surface;
    if (static_cast<double>(part.off_surface) > most_off * static_cast<double>(used)) return;
    if (part.points <= points() || (chosen && !enough_for_part(part.points, part.sample))) return;
    SampleReport report = make_sample_report(input_, attempt.surface, nullptr, factor_, settings_.seed);
    if (report.practice.verdict != Practice::Verdict::doubtful)
      best_ = FoundPart{std::move(attempt.surface), std::move(report)};
  }

  std::optional<FoundPart> best() && { return std::move(best_); }

 private:
  const Input& input_;
  const RunSettings& settings_;
  const std::optional<double> factor_;
  std::optional<FoundPart> best_;
};

}  // namespace

std::optional<FoundPart> find_part(const Input& input, const SurfaceAttempt& whole, const PluginHost& host,
                                   const RunSettings& settings, std::optional<double> factor, Observer& observer) {
  Trying trying(observer);
  PartSearch search(input, settings, factor);
  search.weigh(whole, false);
  if (!has_candidates(whole)) return std::move(search).best();
  for (std::vector<Index>& candidate : part_candidates(*whole.surface.sample, trying)) {
    if (candidate.size() <= search.points()) break;
    search.weigh(SampleChain(input, host, settings, trying, std::move(candidate)).make(settings.stages), true);
  }
  return std::move(search).best();
}

bool has_candidates(const SurfaceAttempt& whole) { return whole.surface.sample->tangents.state.size() >= least_part; }

SampleError with_part(const SampleError& refusal, const std::optional<FoundPart>& found) {
  std::string message = refusal.message();
  Remedy remedy = refusal.coded_remedy();
  if (found)
    remedy = remedies::take_part(text_of(*found->surface.part), remedy.text);
  else
    message += ", and no part of the sample makes a surface by itself";
  SampleError error(std::move(message), std::move(remedy), refusal.findings());
  error.attribute_to(refusal.plugin());
  return error;
}

SampleError without_part(const SampleReport& report) {
  return SampleError("no part of the sample makes a surface by itself; that of the whole is " +
                         std::string(word(report.practice.verdict)) +
                         (report.practice.because.empty() ? "" : " (" + joined(report.practice.because) + ")"),
                     remedies::whole_sample());
}

}  // namespace geodrome
