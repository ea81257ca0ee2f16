// SPDX-License-Identifier: MIT
#include "engine/formats/remedies.hpp"
#include "engine/formats/table.hpp"
#include "engine/jobs/check_outputs.hpp"
#include "engine/jobs/start.hpp"
#include "engine/output/atomic_file.hpp"
#include "engine/search/named_points.hpp"
#include "engine/search/projection_rule.hpp"
#include "geodrome/engine/session.hpp"

namespace geodrome {

namespace {

/// The one entry that names an end of the path. `what`: the option.
Selection parse_end(const std::string& text, const char* what) {
  Selection selection = parse_place(text);
  if (!selection.all && selection.count() != 1)
    throw OptionError(std::string(what) + " names " + std::to_string(selection.count()) + " points", "name one");
  if (selection.has_starts()) throw OptionError(std::string(what) + " has no start distance of its own");
  return selection;
}

std::vector<NamedPoint> end_of(const Selection& selection, const char* what, const Session& session) {
  std::vector<NamedPoint> points = resolve(selection, session.input(), session.surface());
  if (points.size() != 1)
    throw OptionError(std::string(what) + " names " + std::to_string(points.size()) + " points", "name one");
  return points;
}

void write(const PathResult& path, const std::filesystem::path& file) {
  if (!file.empty()) write_atomically(file, format_to_write(file, Content::path).write_path(path));
}

/// The flat path of a smooth one, as a path of its own.
PathResult flat_path(const PathResult& smooth) {
  const FlatPath& flat = *smooth.flat;
  const double distance = flat.points.empty() ? smooth.distance : flat.length;
  return {.distance = distance, .length = flat.length, .points = flat.points, .positions = flat.positions};
}

}  // namespace

PathResult run_path(const PathJob& job, Observer& observer) {
  check_path_rule(job.query);
  for (const std::filesystem::path* file : {&job.out, &job.flat}) check_ending(*file, Content::path);
  if (!job.flat.empty() && job.settings.metric == Metric::flat)
    throw OptionError("there is no path on the triangles beside the path, which is that itself",
                      remedies::smooth_metric_or_no_flat_path());
  const std::string selections[] = {job.from, job.to};
  const std::filesystem::path outputs[] = {job.out, job.flat};
  check_outputs(outputs, files_read(job.input, job.settings.read, selections));
  constexpr const char *start = "the start of the path", *end = "the end of the path";
  const Selection from = parse_end(job.from, start), to = parse_end(job.to, end);
  const Session session(job.input, job.settings, observer, Provides::paths);
  const std::vector<NamedPoint> first = end_of(from, start, session), last = end_of(to, end, session);
  tell_off_surface(session.input(), session.surface(), {{from, first}, {to, last}}, observer);
  PathResult path = session.path(first[0], last[0], job.query);
  path.broken_promises = session.audit_path(first[0], last[0], path, job.query);
  write(path, job.out);
  if (path.flat) write(flat_path(path), job.flat);
  return path;
}

}  // namespace geodrome
