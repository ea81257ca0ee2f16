#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# OpenMesh's readers of OFF, OBJ, PLY and STL round coordinates to float, also into a mesh whose points are double.
set -euo pipefail
version=9.0-4+b1

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
apt-get -qq -o APT::Sandbox::User=root download "libopenmesh-dev=$version" "libopenmesh1=$version"
for package in ./*.deb; do dpkg -x "$package" root; done
libraries=$folder/root/usr/lib/$(g++ -print-multiarch)

x=500000.123 y=5400000.456 z=0.1 # metres, such as a survey has
printf 'OFF\n3 1 0\n%s %s %s\n500001 5400000 0\n500000 5400001 0\n3 0 1 2\n' $x $y $z >mesh.off
printf 'v %s %s %s\nv 500001 5400000 0\nv 500000 5400001 0\nf 1 2 3\n' $x $y $z >mesh.obj
{
  printf 'ply\nformat ascii 1.0\nelement vertex 3\n'
  printf 'property double x\nproperty double y\nproperty double z\n'
  printf 'element face 1\nproperty list uchar int vertex_indices\nend_header\n'
  printf '%s %s %s\n500001 5400000 0\n500000 5400001 0\n3 0 1 2\n' $x $y $z
} >mesh.ply
{
  printf 'solid mesh\nfacet normal 0 0 1\nouter loop\n'
  printf 'vertex %s %s %s\nvertex 500001 5400000 0\nvertex 500000 5400001 0\n' $x $y $z
  printf 'endloop\nendfacet\nendsolid mesh\n'
} >mesh.stl

cat >read.cpp <<'CODE'
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdio>

struct DoublePoints : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<DoublePoints>;

int main(int, char** arguments) {
  Mesh mesh;
  if (!OpenMesh::IO::read_mesh(mesh, arguments[1])) return 1;
  const Mesh::Point first = mesh.point(Mesh::VertexHandle(0));
  std::printf("%.10g %.10g %.10g\n", first[0], first[1], first[2]);
}
CODE
g++ -w -I root/usr/include read.cpp -o read -L "$libraries" -lOpenMeshCore

echo "OpenMesh $version, a mesh with points of three doubles (OpenMesh::Vec3d)"
echo "expected   $x $y $z from every format; PLY even says 'property double'"
rounded="500000.125 5400000.5 0.1000000015"
for mesh in mesh.off mesh.obj mesh.ply mesh.stl; do
  seen=$(LD_LIBRARY_PATH=$libraries ./read "$mesh")
  echo "seen       $seen ($mesh)"
  if [ "$seen" != "$rounded" ]; then
    echo "CHANGED    $mesh no longer gives $rounded"
    exit 1
  fi
done
echo "hurts      whoever reads coordinates with a large offset, as maps and scans have: here 4 cm are lost, silently"
