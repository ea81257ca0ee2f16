// SPDX-License-Identifier: MIT
// Base64 into arrays. Typed arrays have the byte order of the machine: little-endian wherever there is a browser with
// WebGL.

function bytes(base64: string): ArrayBuffer {
  const text = atob(base64);
  const decoded = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) decoded[i] = text.charCodeAt(i);
  return decoded.buffer;
}

export const floats = (base64: string) => new Float32Array(bytes(base64));
export const indices = (base64: string) => new Uint32Array(bytes(base64));
