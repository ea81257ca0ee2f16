// SPDX-License-Identifier: MIT
// ten_lines INPUT MATRIX PLUGIN_FOLDER: what `geodrome distances` does, from C++.
#include <geodrome/engine.hpp>
#include <iostream>

int main(int, char** arguments) {
  geodrome::DistanceJob job;
  job.input = arguments[1];
  job.matrix = arguments[2];
  job.settings.plugin_path = {arguments[3]};
  job.settings.stages.solver = "third_party";
  geodrome::Observer silent;
  std::cout << geodrome::run_distances(job, silent).summary;
}
