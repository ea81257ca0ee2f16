// SPDX-License-Identifier: MIT
// The 3D scene of one canvas: a surface with a field on it, the source, a path. It draws a frame when something has
// changed.
import * as THREE from "three";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import type { Field } from "./field";
import type { Frame } from "./frame";
import { Marker } from "./marker";
import { SurfaceMaterial } from "./surface_material";

const path_colour = 0xff2bd6; // on neither colour map

export class Scene {
  readonly camera: THREE.PerspectiveCamera;
  private readonly renderer_: THREE.WebGLRenderer;
  private readonly scene_ = new THREE.Scene();
  private readonly material_ = new SurfaceMaterial();
  private readonly mesh_ = new THREE.Mesh(new THREE.BufferGeometry(), this.material_);
  private readonly source_ = new Marker("#000", "#fff");
  private readonly target_ = new Marker("#fff", "#ff2bd6");
  private readonly path_ = new THREE.Group();
  private waiting_ = false;

  /** Precondition: `context` is the WebGL 2 context of `canvas`. `drawn` is called after each frame. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    context: WebGL2RenderingContext,
    camera: THREE.PerspectiveCamera,
    private readonly drawn_: () => void,
  ) {
    this.camera = camera;
    this.renderer_ = new THREE.WebGLRenderer({ canvas, context, antialias: true, alpha: true });
    this.mesh_.frustumCulled = false;
    this.scene_.add(this.mesh_, this.path_, this.source_, this.target_);
    new ResizeObserver(() => this.resize()).observe(canvas);
  }

  surface(positions: Float32Array, triangles: Uint32Array, frame: Frame): void {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(frame.place(positions), 3));
    geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
    this.mesh_.geometry.dispose();
    this.mesh_.geometry = geometry;
  }

  /** Precondition: the field belongs to the surface. `isolines`: how many up to the largest distance, 0: none. */
  field(field: Field, isolines: number): void {
    const set = (name: string, values: Float32Array) =>
      this.mesh_.geometry.setAttribute(name, new THREE.BufferAttribute(values, 1));
    set("shade", field.shade);
    set("field_distance", field.distance);
    set("unreached", field.unreached);
    set("missing", field.missing);
    this.material_.show(field.kind, isolines);
    this.draw();
  }

  source(position: number[], frame: Frame): void {
    this.source_.place.fromArray(frame.place(position));
    this.draw();
  }

  /**
   * A path, as 3 coordinates a point; fewer than two points: none. What the surface hides of it stays visible,
   * faintly.
   */
  path(points: Float32Array, frame: Frame): void {
    for (const line of this.path_.children as Line2[]) {
      line.geometry.dispose();
      line.material.dispose();
    }
    this.path_.clear();
    this.target_.visible = points.length >= 6;
    if (this.target_.visible) {
      const placed = frame.place(points);
      this.path_.add(path_line(placed, false), path_line(placed, true));
      this.target_.place.fromArray(placed, placed.length - 3);
    }
    this.draw();
  }

  /**
   * The vertex of the surface next to what is seen at a place of the canvas, both from -1 to 1; null beside the
   * surface.
   */
  vertex_at(x: number, y: number): number | null {
    const ray = new THREE.Raycaster();
    this.fit_camera();
    ray.setFromCamera(new THREE.Vector2(x, y), this.camera);
    const hit = ray.intersectObject(this.mesh_)[0];
    if (!hit?.face) return null;
    const corner = new THREE.Vector3();
    const gap = (vertex: number) =>
      corner.fromBufferAttribute(this.mesh_.geometry.getAttribute("position"), vertex).distanceTo(hit.point);
    return [hit.face.a, hit.face.b, hit.face.c].reduce((best, vertex) => (gap(vertex) < gap(best) ? vertex : best));
  }

  /** Asks for a frame; one is drawn however often this is called before. */
  draw(): void {
    if (this.waiting_) return;
    this.waiting_ = true;
    requestAnimationFrame(() => {
      this.waiting_ = false;
      this.fit_camera();
      this.source_.face(this.camera);
      this.target_.face(this.camera);
      this.renderer_.render(this.scene_, this.camera);
      this.drawn_();
    });
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer_.setPixelRatio(window.devicePixelRatio);
    this.renderer_.setSize(width, height, false);
    this.draw();
  }

  /** Several canvases share the camera: each sets its shape. What fits into the height fits into a small width too. */
  private fit_camera(): void {
    this.camera.aspect = this.canvas.clientWidth / this.canvas.clientHeight || 1;
    this.camera.zoom = Math.min(1, this.camera.aspect);
    this.camera.updateProjectionMatrix();
  }
}

function path_line(points: Float32Array, hidden: boolean): Line2 {
  const geometry = new LineGeometry();
  geometry.setPositions(points);
  const material = new LineMaterial({
    color: path_colour,
    linewidth: 3,
    depthTest: !hidden,
    transparent: hidden,
    opacity: hidden ? 0.3 : 1,
  });
  const line = new Line2(geometry, material);
  line.renderOrder = hidden ? 2 : 1;
  return line;
}
