// SPDX-License-Identifier: MIT
// The data that `geodrome compare --html` puts into the page: its types, and how it is read. Rows count from 0,
// seconds are seconds, memory is in bytes, errors are D/T - 1 for the distance D of a combination and the true
// distance T.

export interface Figures {
  schema: string;
  version: string;
  input: { file: string; kind: "points" | "mesh"; rows: number; faces: number | null; diagonal: number };
  sources: { entry: string; row: number | null; position: [number, number, number] }[];
  targets: number;
  truth: { kind: "first" | "exact" | "file"; name: string; text: string };
  near: number;
  far: number;
  combinations: Combination[];
}

/** A combination of plugins: what it gave, or why it did not run. */
export type Combination = Result | Failure;

export interface Failure {
  name: string;
  stages: Record<string, string>;
  error: { text: string; status: number };
}

export interface Result {
  name: string;
  stages: Record<string, string>;
  error: null;
  factor: number | null;
  never_shorter: boolean;
  surface: { vertices: number; faces: number };
  seconds: { stages: Record<string, number>; prepare: number; per_source: number; sources: number[] };
  memory: { peak_bytes: number | null; prepared_bytes: number | null };
  errors: {
    compared: number;
    max_over: number | null; // null: nothing was compared
    max_under: number | null;
    mean: number | null;
    quantiles: Record<string, number | null>;
    near: ErrorSummary;
    far: ErrorSummary;
    histogram: { decades: number[]; counts: number[]; zero: number };
  };
  reach_differs: number;
  unreachable: number;
  invariants: Invariant[];
  /** What distances can be off by, of themselves, by the solver's own lower bounds; only if it states them. */
  certified?: { largest: number | null; mean: number | null; worst: number | null };
  guarantee: { stated: number | null; worst: number | null; held: boolean | null; why: string };
  counters: Record<string, number>;
  growth: GrowthStep[];
}

export interface ErrorSummary {
  compared: number;
  mean: number | null;
  max: number | null;
}

export interface Invariant {
  name: string;
  holds: boolean | null;
  worst: number | null;
  promised: boolean;
}

export interface GrowthStep {
  rows: number;
  vertices: number;
  faces: number;
  prepare: number;
  per_source: number;
  peak_bytes: number | null;
  counters: Record<string, number>;
}

/** What the 3D view shows; arrays are base64 of little-endian float32 or uint32 and are decoded when they are shown. */
export interface View {
  surfaces: { positions: string; triangles: string }[];
  combinations: ({ surface: number; sources: SourceView[] } | null)[];
}

export interface SourceView {
  distances: string;
  errors: string;
  paths: { target: number; distance: number; length: number; points: string }[];
}

export interface Comparison extends Figures {
  view?: View;
}

export const ran = (combination: Combination): combination is Result => combination.error === null;

const schema = "geodrome-comparison/1";
// A name may well be "inf"; a number that is not finite is written as such a word, since JSON has none.
const text_members = new Set(["name", "text", "file", "why", "entry", "version"]);
const words: Record<string, number> = { inf: Infinity, "-inf": -Infinity, nan: NaN };

const revive = (key: string, value: unknown) =>
  typeof value === "string" && value in words && !text_members.has(key) ? words[value] : value;

/**
 * The data of the page; null if it holds none. Throws an Error that says what is wrong with data that this page
 * cannot show.
 */
export function read_comparison(page: Document): Comparison | null {
  const text = page.getElementById("geodrome-comparison")?.textContent;
  if (!text) return null;
  const data = JSON.parse(text, revive) as Comparison;
  if (data.schema !== schema) throw new Error(`the data is "${data.schema}", this page shows "${schema}"`);
  for (const { name, errors } of data.combinations.filter(ran))
    if (errors.histogram.counts.length !== errors.histogram.decades.length - 1)
      throw new Error(`the histogram of ${name} does not have one count for each step between its decades`);
  return data;
}
