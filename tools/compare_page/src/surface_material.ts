// SPDX-License-Identifier: MIT
// How a surface is coloured: a colour map over an interpolated value, isolines of the interpolated distance, grey
// where nothing reaches, hatched where there is no value. Facets are lit from the eye, so that orientation does not
// matter.
import * as THREE from "three";
import { colour_bytes } from "./colour_maps";
import type { FieldKind } from "./field";

const map_size = 256;

const vertex_shader = /* glsl */ `
  attribute float shade, field_distance, unreached, missing;
  varying float v_shade, v_distance, v_unreached, v_missing;
  varying vec3 v_place;
  void main() {
    vec4 place = modelViewMatrix * vec4(position, 1.0);
    v_shade = shade;
    v_distance = field_distance;
    v_unreached = unreached;
    v_missing = missing;
    v_place = place.xyz;
    gl_Position = projectionMatrix * place;
  }`;

const fragment_shader = /* glsl */ `
  uniform sampler2D colours;
  uniform float isolines;  // how many lie between 0 and the largest distance; 0: none
  varying float v_shade, v_distance, v_unreached, v_missing;
  varying vec3 v_place;
  const float no_value = 1e-3;  // a face with a vertex that has no value shows none

  float facet_light() {
    vec3 normal = cross(dFdx(v_place), dFdy(v_place));
    float length_product = max(length(normal) * length(v_place), 1e-30);
    return 0.55 + 0.45 * abs(dot(normal, v_place)) / length_product;
  }

  // Dark lines with a light rim, to be seen on any colour; none where they would be closer than a few pixels.
  vec3 with_isoline(vec3 colour) {
    float level = v_distance * isolines;
    float width = max(fwidth(level), 1e-9);
    float pixels = abs(fract(level - 0.5) - 0.5) / width;
    float seen = 1.0 - smoothstep(0.15, 0.35, width);
    colour = mix(colour, vec3(1.0), 0.4 * seen * (1.0 - smoothstep(1.0, 2.2, pixels)));
    return mix(colour, vec3(0.0), 0.75 * seen * (1.0 - smoothstep(0.3, 1.0, pixels)));
  }

  void main() {
    vec3 colour = texture2D(colours, vec2((v_shade * ${map_size - 1}.0 + 0.5) / ${map_size}.0, 0.5)).rgb;
    if (isolines > 0.0) colour = with_isoline(colour);
    if (v_missing > no_value) colour = vec3(mod(gl_FragCoord.x + gl_FragCoord.y, 10.0) < 3.0 ? 0.35 : 0.7);
    if (v_unreached > no_value) colour = vec3(0.5);
    gl_FragColor = vec4(colour * facet_light(), 1.0);
  }`;

function map_texture(kind: FieldKind): THREE.DataTexture {
  const texture = new THREE.DataTexture(colour_bytes(kind, map_size), map_size, 1);
  texture.magFilter = texture.minFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

export class SurfaceMaterial extends THREE.ShaderMaterial {
  private readonly maps_ = { distance: map_texture("distance"), error: map_texture("error") };

  constructor() {
    super({
      vertexShader: vertex_shader,
      fragmentShader: fragment_shader,
      uniforms: { colours: { value: null }, isolines: { value: 0 } },
      side: THREE.DoubleSide,
      polygonOffset: true, // paths on the surface stay in front of it
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 2,
    });
  }

  show(kind: FieldKind, isolines: number): void {
    this.uniforms.colours!.value = this.maps_[kind];
    this.uniforms.isolines!.value = isolines;
  }
}
