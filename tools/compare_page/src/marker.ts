// SPDX-License-Identifier: MIT
// A disc that marks a place on a surface: always of one size, faint where the surface hides it.
import * as THREE from "three";

const size = 0.022; // of the height of the view
const pull = 0.03; // towards the eye, as a share of the way: the disc is not cut by the surface that it lies on
const hidden_opacity = 0.35;

function disc(inner: string, outer: string): THREE.Texture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d")!;
  for (const [colour, radius] of [
    [outer, 30],
    [inner, 19],
  ] as const) {
    pen.fillStyle = colour;
    pen.beginPath();
    pen.arc(32, 32, radius, 0, 2 * Math.PI);
    pen.fill();
  }
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}

export class Marker extends THREE.Group {
  readonly place = new THREE.Vector3();

  constructor(inner: string, outer: string) {
    super();
    const map = disc(inner, outer);
    const sprite = (hidden: boolean) => {
      const material = new THREE.SpriteMaterial({
        map,
        depthTest: !hidden,
        opacity: hidden ? hidden_opacity : 1,
        sizeAttenuation: false,
      });
      const made = new THREE.Sprite(material);
      made.scale.setScalar(size);
      made.renderOrder = hidden ? 3 : 4;
      return made;
    };
    this.add(sprite(true), sprite(false));
  }

  face(camera: THREE.Camera): void {
    this.position.lerpVectors(this.place, camera.position, pull);
  }
}
