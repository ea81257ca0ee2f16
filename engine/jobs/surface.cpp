// SPDX-License-Identifier: MIT
#include "engine/jobs/check_outputs.hpp"
#include "engine/surface/opened.hpp"
#include "geodrome/engine/jobs.hpp"

namespace geodrome {

MeshPtr run_surface(const SurfaceJob& job, Observer& observer) {
  check_mesh_ending(job.out, job.settings.read);
  check_outputs({&job.out, 1}, files_read(job.input, job.settings.read, {}));
  const PluginHost host(job.settings.plugin_path);
  MeshPtr mesh = open_input(job.input, host, job.settings, observer).surface.mesh;
  if (!job.out.empty()) write_mesh(job.out, *mesh);
  return mesh;
}

}  // namespace geodrome
