// SPDX-License-Identifier: MIT
#include "engine/jobs/check_outputs.hpp"
#include "engine/jobs/start.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

MeshPtr run_surface(const SurfaceJob& job, Observer& observer) {
  check_mesh_ending(job.out, job.settings.read, job.scalar);
  check_outputs({&job.out, 1}, files_read(job.input, job.settings.read, {}));
  const PluginHost host(job.settings.plugin_path);
  const JobStart start = start_job(job.input, host, job.settings, std::nullopt, observer);
  throw_if_refused(start, observer);
  tell_sample(start, observer);
  if (!job.out.empty()) tell(write_mesh(job.out, *start.surface().mesh, job.scalar), observer);
  return start.surface().mesh;
}

}  // namespace geodrome
