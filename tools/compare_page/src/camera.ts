// SPDX-License-Identifier: MIT
// The eye of the 3D view, shared by all canvases: drag to turn, wheel or pinch to zoom, and the same by keys.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

export type Axis = "x" | "y" | "z";

const turn = Math.PI / 24;
const zoom = 1.15;
const distance = 1.85; // the surface has a diagonal of 1
const axes: Record<Axis, THREE.Vector3> = {
  x: new THREE.Vector3(1, 0, 0),
  y: new THREE.Vector3(0, 1, 0),
  z: new THREE.Vector3(0, 0, 1),
};

/** A camera that looks at the origin. */
export function make_camera(): THREE.PerspectiveCamera {
  return new THREE.PerspectiveCamera(30, 1, 0.01, 100);
}

/** Puts the camera back to where it starts: obliquely from above, `up` being up. */
export function reset_camera(camera: THREE.PerspectiveCamera, up: Axis): void {
  camera.up.copy(axes[up]);
  const start = {
    x: new THREE.Vector3(0.6, 0.6, -1),
    y: new THREE.Vector3(0.45, 0.45, 1),
    z: new THREE.Vector3(0.5, -1, 0.75),
  };
  camera.position.copy(start[up]).setLength(distance);
  camera.lookAt(0, 0, 0);
}

/**
 * Lets a person move the camera at `canvas`; `moved` is called when it has moved. Call `update` after the camera was
 * put elsewhere.
 */
export class CameraControls {
  private readonly orbit_: OrbitControls;

  constructor(
    private readonly camera_: THREE.PerspectiveCamera,
    canvas: HTMLCanvasElement,
    private readonly moved_: () => void,
  ) {
    this.orbit_ = new OrbitControls(camera_, canvas);
    this.orbit_.minDistance = 0.1;
    this.orbit_.maxDistance = 10;
    this.orbit_.addEventListener("change", moved_);
    canvas.addEventListener("keydown", (event) => this.key(event));
  }

  /** After `camera.up` or its position were set. */
  update(): void {
    this.orbit_.target.set(0, 0, 0);
    this.orbit_.update();
    this.moved_();
  }

  private key(event: KeyboardEvent): void {
    const moves: Record<string, () => void> = {
      ArrowLeft: () => this.rotate(-turn, 0),
      ArrowRight: () => this.rotate(turn, 0),
      ArrowUp: () => this.rotate(0, -turn),
      ArrowDown: () => this.rotate(0, turn),
      "+": () => this.camera_.position.divideScalar(zoom),
      "-": () => this.camera_.position.multiplyScalar(zoom),
    };
    const move = moves[event.key];
    if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    move();
    this.orbit_.update();
    this.moved_();
  }

  /** Around the upward axis, and from it. */
  private rotate(around: number, down: number): void {
    const to_y = new THREE.Quaternion().setFromUnitVectors(this.camera_.up, axes.y);
    const place = new THREE.Spherical().setFromVector3(this.camera_.position.clone().applyQuaternion(to_y));
    place.theta += around;
    place.phi += down;
    place.makeSafe();
    this.camera_.position.setFromSpherical(place).applyQuaternion(to_y.invert());
  }
}
