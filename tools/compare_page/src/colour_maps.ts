// SPDX-License-Identifier: MIT
// The colour maps of fields, both safe for colour-blind readers: sequential for distances, diverging for signed errors.
import { interpolateRdBu, interpolateViridis } from "d3-scale-chromatic";
import type { FieldKind } from "./field";

/** Colour of a place from 0 to 1. Errors: blue is too short, white right, red too long. */
export const colour_at: Record<FieldKind, (place: number) => string> = {
  distance: interpolateViridis,
  error: (place) => interpolateRdBu(1 - place),
};

/** `size` colours of a map as RGBA bytes. */
export function colour_bytes(kind: FieldKind, size: number): Uint8Array {
  const bytes = new Uint8Array(4 * size);
  for (let i = 0; i < size; ++i) bytes.set([...rgb_of(colour_at[kind](i / (size - 1))), 255], 4 * i);
  return bytes;
}

/** A map as a CSS gradient from left to right. */
export const colour_gradient = (kind: FieldKind) =>
  `linear-gradient(to right, ${Array.from({ length: 21 }, (_, i) => colour_at[kind](i / 20)).join(", ")})`;

function rgb_of(colour: string): number[] {
  if (colour.startsWith("#")) return [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));
  return colour.match(/\d+/g)!.map(Number);
}
