#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# CGAL's advancing front reconstruction settles ties by memory addresses: the same points give other triangles.
set -euo pipefail
version=5.5.1-2

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download "libcgal-dev=$version" libboost1.74-dev libgmp-dev libmpfr-dev \
  libgmp10 libgmpxx4ldbl libmpfr6
for package in ./*.deb; do dpkg -x "$package" root; done
multiarch=$(g++ -print-multiarch)
libraries=$folder/root/usr/lib/$multiarch

cat >lattice.cpp <<'CODE'
#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <memory>
#include <random>
#include <set>
#include <vector>

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Triangles = std::vector<std::array<std::size_t, 3>>;

// The 98 points on the outside of a lattice of 5 x 5 x 5, again and again; the program takes and frees memory between.
int main() {
  std::vector<Point> points;
  const auto outside = [](int i) { return i == 0 || i == 4; };
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y)
      for (int z = 0; z < 5; ++z)
        if (outside(x) || outside(y) || outside(z)) points.emplace_back(x, y, z);
  std::mt19937 random(1);
  std::vector<std::unique_ptr<char[]>> memory(2000);
  std::set<Triangles> results;
  for (int call = 0; call < 24; ++call) {
    for (auto& block : memory)
      if (random() % 2) block = std::make_unique<char[]>(16 + random() % 400);
    Triangles triangles;
    CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(), std::back_inserter(triangles));
    for (auto& t : triangles) std::sort(t.begin(), t.end());
    std::sort(triangles.begin(), triangles.end());
    results.insert(triangles);
  }
  std::printf("%zu %zu\n", points.size(), results.size());
}
CODE
g++ -O1 -w -DCGAL_HEADER_ONLY -I root/usr/include -I "root/usr/include/$multiarch" lattice.cpp -o lattice \
  -L "$libraries" -lgmp -lmpfr
read -r points results <<<"$(LD_LIBRARY_PATH=$libraries ./lattice)"

echo "CGAL $version, advancing_front_surface_reconstruction, $points points of a lattice, 24 calls in one process"
echo "expected   one set of triangles: the algorithm draws no numbers and the input is the same"
echo "seen       $results different sets of triangles (how many changes from run to run)"
if [ "$results" -lt 2 ]; then
  echo "CHANGED    all calls give the same triangles"
  exit 1
fi
echo "hurts      whoever reconstructs voxel or grid data and compares runs: results cannot be repeated, in one process"
echo "           even; points without equal distances are not affected"
