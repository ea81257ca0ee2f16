// SPDX-License-Identifier: MIT
// Base64 into arrays. Typed arrays have the byte order of the machine: little-endian wherever there is a browser with WebGL.

function bytes(base64: string): ArrayBuffer {
  return Uint8Array.from(atob(base64), (character) => character.charCodeAt(0)).buffer;
}

export const floats = (base64: string) => new Float32Array(bytes(base64));
export const indices = (base64: string) => new Uint32Array(bytes(base64));
