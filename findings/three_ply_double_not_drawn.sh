#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# three.js: PLYLoader reads doubles into Float64Array, which the part of WebGLRenderer that makes buffers refuses.
set -euo pipefail
version=0.187.0

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --no-audit --no-fund --prefix "$folder" "three@$version" >/dev/null

cat >show.mjs <<'CODE'
import { PLYLoader } from "three/addons/loaders/PLYLoader.js";
import { WebGLAttributes } from "three/src/renderers/webgl/WebGLAttributes.js";

const type = process.argv[2];
const text = `ply
format ascii 1.0
element vertex 3
property ${type} x
property ${type} y
property ${type} z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
`;
const { position } = new PLYLoader().parse(text).attributes;
// Answers every call of the renderer to WebGL; constants are their names.
const gl = new Proxy({}, { get: (_, name) => (name === name.toUpperCase() ? name : () => ({})) });
let outcome = "made into a buffer";
try {
  WebGLAttributes(gl).update(position, gl.ARRAY_BUFFER);
} catch (error) {
  outcome = error.message.split(":").slice(0, 2).join(":");
}
console.log(`${position.array.constructor.name}, ${outcome}`);
CODE

echo "three.js $version, PLYLoader and the renderer's WebGLAttributes (with a stand-in for the WebGL context)"
echo "expected   float and double: a geometry that the renderer draws, as PLY has had both types from the start"
as_float=$(node show.mjs float) as_double=$(node show.mjs double)
echo "seen       float:  $as_float"
echo "           double: $as_double"
refused="Float64Array, THREE.WebGLAttributes: Unsupported buffer data format"
if [ "$as_float" != "Float32Array, made into a buffer" ] || [ "$as_double" != "$refused" ]; then
  echo "CHANGED    doubles are no longer read into an array that is refused"
  exit 1
fi
echo "hurts      whoever shows a PLY file of double precision in a page: the file loads without a word, and the error"
echo "           comes at the first frame, about a buffer and not about the file"
