// SPDX-License-Identifier: MIT
// What is shown at the vertices of a surface: values as colours, distances as isolines, and vertices without a value.
import { floats } from "./arrays";
import type { SourceView } from "./figures";

export type FieldKind = "distance" | "error";

/** Vertices are coloured by `shade`, 0 to 1 on the colour map, which stands for values from `low` to `high`. */
export interface Field {
  kind: FieldKind;
  shade: Float32Array;
  low: number;
  high: number;
  /** Smallest and largest value there is; some lie beyond low and high. */
  smallest: number;
  largest: number;
  /** Distances over the largest finite one, for isolines; 0 where there is none. */
  distance: Float32Array;
  largest_distance: number;
  /** 1 where a vertex is unreachable, or has no value for another reason. */
  unreached: Float32Array;
  missing: Float32Array;
  unreached_count: number;
  missing_count: number;
}

/** The shares of errors that the colours reach over, so that a few outliers do not leave the rest in one colour. */
const covered = 0.98;

/** The magnitude below which `covered` of the finite errors lie, or the largest if that is 0; 0 where all are. */
export function error_range(errors: Float32Array): number {
  const sizes = errors.filter(Number.isFinite).map(Math.abs).sort();
  return sizes[Math.floor(covered * (sizes.length - 1))] || sizes.at(-1) || 0;
}

function extent(values: Float32Array): { smallest: number; largest: number } {
  let [smallest, largest] = [Infinity, -Infinity];
  for (const value of values)
    if (Number.isFinite(value)) {
      smallest = Math.min(smallest, value);
      largest = Math.max(largest, value);
    }
  return { smallest, largest };
}

/** The field of one source; `range`: the magnitude of the errors at the ends of the colour map, null: its own. */
export function field_of(source: SourceView, kind: FieldKind, range: number | null): Field {
  const distances = floats(source.distances);
  const values = kind === "distance" ? distances : floats(source.errors);
  const largest_distance = Math.max(extent(distances).largest, 0);
  const { smallest, largest } = extent(values);
  const reach = kind === "error" ? (range ?? error_range(values)) : largest_distance;
  const low = kind === "error" ? -reach : 0;
  const unreached = Float32Array.from(distances, (d) => Number(d === Infinity));
  const missing = Float32Array.from(values, (v, i) => Number(!Number.isFinite(v) && !unreached[i]));
  const finite = (v: number) => (Number.isFinite(v) ? v : 0);
  return {
    kind,
    low,
    high: reach,
    smallest,
    largest,
    shade: Float32Array.from(values, (v) =>
      reach > 0 ? Math.min(Math.max((finite(v) - low) / (reach - low), 0), 1) : kind === "error" ? 0.5 : 0,
    ),
    distance: Float32Array.from(distances, (d) => (largest_distance > 0 ? finite(d) / largest_distance : 0)),
    largest_distance,
    unreached,
    missing,
    unreached_count: unreached.reduce((sum, v) => sum + v, 0),
    missing_count: missing.reduce((sum, v) => sum + v, 0),
  };
}

/** Spacings of isolines, coarse to fine, that are 1, 2 or 5 times a power of ten: about 5 to 100 lines. */
export function isoline_spacings(largest_distance: number): number[] {
  if (!(largest_distance > 0)) return [];
  const spacings: number[] = [];
  for (let e = Math.floor(Math.log10(largest_distance)); e > Math.log10(largest_distance) - 4; --e)
    for (const mantissa of [5, 2, 1]) spacings.push(Number(`${mantissa}e${e}`));
  return spacings.filter((s) => largest_distance / s >= 3 && largest_distance / s <= 100);
}
