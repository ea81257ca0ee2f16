#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# CGAL's heat method gives the largest double for every vertex, the source too, on a strip of 1000 squares.
set -euo pipefail
version=5.5.1-2

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download "libcgal-dev=$version" libboost1.74-dev libeigen3-dev libgmp-dev \
  libmpfr-dev libgmp10 libgmpxx4ldbl libmpfr6
for package in ./*.deb; do dpkg -x "$package" root; done
multiarch=$(g++ -print-multiarch)
libraries=$folder/root/usr/lib/$multiarch

cat >strip.cpp <<'CODE'
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Surface_mesh.h>

#include <cstdio>
#include <cstdlib>
#include <limits>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// A strip of unit squares, each of two triangles; the source is at one end. Prints how many
// distances are the largest double.
int main(int, char** arguments) {
  const int squares = std::atoi(arguments[1]);
  Mesh mesh;
  auto low = mesh.add_vertex({0, 0, 0}), high = mesh.add_vertex({0, 1, 0});
  const auto source = low;
  for (int i = 1; i <= squares; ++i) {
    const auto next_low = mesh.add_vertex({double(i), 0, 0}), next_high = mesh.add_vertex({double(i), 1, 0});
    mesh.add_face(low, next_low, next_high), mesh.add_face(low, next_high, high);
    low = next_low, high = next_high;
  }
  auto distance = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0).first;
  CGAL::Heat_method_3::estimate_geodesic_distances(mesh, distance, source);
  int largest = 0;
  for (const auto v : mesh.vertices()) largest += distance[v] == std::numeric_limits<double>::max();
  std::printf("%d %zu\n", largest, std::size_t(mesh.number_of_vertices()));
}
CODE
g++ -O1 -w -DCGAL_HEADER_ONLY -DCGAL_EIGEN3_ENABLED -I root/usr/include -I "root/usr/include/$multiarch" \
  -I root/usr/include/eigen3 strip.cpp -o strip -L "$libraries" -lgmp -lmpfr

echo "CGAL $version, Heat_method_3::estimate_geodesic_distances, strips of unit squares, the source at one end"
echo "expected   an estimate for each vertex; if heat is too weak to be seen far away, then only there"
for squares in 500 1000; do
  read -r largest vertices <<<"$(LD_LIBRARY_PATH=$libraries ./strip $squares)"
  echo "seen       $squares squares: $largest of $vertices distances are 1.79769e+308"
  wanted=0
  [ "$squares" -eq 500 ] || wanted=$vertices
  if [ "$largest" -ne "$wanted" ]; then
    echo "CHANGED    $wanted were before"
    exit 1
  fi
done
echo "hurts      long thin meshes (roads, vessels): the source is 1.8e308 from itself, and no error is told; code"
echo "           that takes this number for unreachable finds a mesh of one piece in pieces"
