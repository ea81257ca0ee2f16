// SPDX-License-Identifier: MIT
// The columns of the table: what each shows of a combination, and by what it sorts.
import type { Invariant, Result } from "./figures";
import { count, exactly, figure, nothing } from "./format";

export interface Column {
  id: string;
  group: string;
  label: string;
  /** What is shown and sorted: a number, or null where nothing was measured; words sort by `value` too. */
  value: (result: Result) => number | null;
  /** The value as text. */
  text: (value: number | null, result: Result) => string;
  /** Said when asked: the whole truth about the value. */
  title?: (result: Result) => string;
  kind: "number" | "words";
}

const megabyte = 1e6;

function number(
  id: string,
  group: string,
  label: string,
  value: Column["value"],
  text: Column["text"] = (v) => figure(v),
): Column {
  return { id, group, label, value, text, kind: "number" };
}

/** Of |D/T - 1|: the largest of both signs. */
export function largest_error({ errors: { max_over, max_under } }: Result): number | null {
  return max_over === null || max_under === null ? null : Math.max(Math.abs(max_over), Math.abs(max_under));
}

/** Of all stages before the solver; null where there are none. */
export function stage_seconds({ seconds }: Result): number | null {
  const all = Object.values(seconds.stages);
  return all.length ? all.reduce((sum, s) => sum + s, 0) : null;
}

export const factor_text = (factor: number | null) =>
  factor === null ? "none" : factor === 1 ? "exact" : `≤ ${exactly(factor)}`;

export function guarantee_text({ guarantee }: Result): string {
  if (guarantee.stated === null) return "none stated";
  const verdict = guarantee.held === null ? "not judged" : guarantee.held ? "held" : "BROKEN";
  return `${factor_text(guarantee.stated)}: ${verdict}`;
}

export const invariant_text = ({ holds, promised }: Invariant) =>
  holds === null ? "not applicable" : holds ? "holds" : promised ? "BROKEN" : "fails, not promised";

const failing = ({ invariants }: Result) => invariants.filter(({ holds }) => holds === false);

export function invariants_text(result: Result): string {
  const failed = failing(result);
  if (failed.length === 0) return result.invariants.some(({ holds }) => holds) ? "all hold" : nothing;
  const broken = failed.filter(({ promised }) => promised).length;
  return broken ? `${broken} BROKEN` : `${failed.length} not promised`;
}

export const columns: Column[] = [
  number(
    "faces",
    "Surface",
    "faces",
    ({ surface }) => surface.faces,
    (v) => count(v),
  ),
  number("stages", "Time, s", "stages", stage_seconds),
  number("prepare", "Time, s", "prepare", ({ seconds }) => seconds.prepare),
  number("per_source", "Time, s", "source", ({ seconds }) => seconds.per_source),
  number("peak", "Memory, MB", "peak", ({ memory }) =>
    memory.peak_bytes === null ? null : memory.peak_bytes / megabyte,
  ),
  number("prepared", "Memory, MB", "prepared", ({ memory }) =>
    memory.prepared_bytes === null ? null : memory.prepared_bytes / megabyte,
  ),
  number("mean", "Relative error", "mean", ({ errors }) => errors.mean),
  number("q99", "Relative error", "99 %", ({ errors }) => errors.quantiles["0.99"] ?? null),
  number("max_over", "Relative error", "over", ({ errors }) => errors.max_over),
  number("max_under", "Relative error", "under", ({ errors }) => errors.max_under),
  number("near_mean", "Near pairs", "mean", ({ errors }) => errors.near.mean),
  number("near_max", "Near pairs", "max", ({ errors }) => errors.near.max),
  number("far_mean", "Far pairs", "mean", ({ errors }) => errors.far.mean),
  number("far_max", "Far pairs", "max", ({ errors }) => errors.far.max),
  number(
    "unreachable",
    "Targets",
    "unreach",
    ({ unreachable }) => unreachable,
    (v) => count(v),
  ),
  number(
    "reach_differs",
    "Targets",
    "differ",
    ({ reach_differs }) => reach_differs,
    (v) => count(v),
  ),
  {
    id: "guarantee",
    group: "Promises",
    label: "guarantee",
    value: ({ guarantee }) => guarantee.stated,
    text: (_, result) => guarantee_text(result),
    title: ({ guarantee }) =>
      `${guarantee.worst === null ? "" : `worst factor seen ${exactly(guarantee.worst)}; `}${guarantee.why}`,
    kind: "words",
  },
  {
    id: "invariants",
    group: "Promises",
    label: "invariants",
    value: (result) => failing(result).length,
    text: (_, result) => invariants_text(result),
    title: (result) => result.invariants.map((i) => `${i.name}: ${invariant_text(i)}`).join("\n"),
    kind: "words",
  },
];
