// SPDX-License-Identifier: MIT
// Everything about one combination that has no column of its own.
import { invariant_text } from "./columns";
import { element } from "./element";
import type { Result } from "./figures";
import { count, counted, exactly, figure } from "./format";

type Row = [string, ...string[]];

function block(caption: string, head: string[], rows: Row[]): HTMLElement | null {
  if (rows.length === 0) return null;
  return element(
    "table",
    { class: "block" },
    element("caption", {}, caption),
    head.length
      ? element("thead", {}, element("tr", {}, ...head.map((name) => element("th", { scope: "col" }, name))))
      : null,
    element(
      "tbody",
      {},
      ...rows.map(([name, ...cells]) =>
        element("tr", {}, element("th", { scope: "row" }, name), ...cells.map((cell) => element("td", {}, cell))),
      ),
    ),
  );
}

const stage_rows = ({ stages, seconds }: Result) =>
  Object.entries(stages).map(([stage, choice]): Row => [
    stage,
    choice,
    stage === "solver" ? "" : figure(seconds.stages[stage]),
  ]);

function error_rows({ errors }: Result): Row[] {
  const quantiles = Object.entries(errors.quantiles)
    .map(([share, value]) => [Number(share), value] as const)
    .sort(([a], [b]) => a - b);
  return [
    ["targets compared", count(errors.compared)],
    ["of them exact", count(errors.histogram.zero)],
    ...quantiles.map(([share, value]): Row => [
      `${count(Number((share * 100).toPrecision(9)))} % are at most`,
      figure(value),
    ]),
    ["near pairs", count(errors.near.compared)],
    ["far pairs", count(errors.far.compared)],
  ];
}

export function details(result: Result, source_names: string[]): HTMLElement {
  const { certified, guarantee, invariants, counters, seconds } = result;
  const reason = guarantee.why + (guarantee.worst === null ? "" : ` (worst factor seen: ${exactly(guarantee.worst)})`);
  return element(
    "div",
    { class: "details" },
    element("p", {}, element("strong", {}, "Guarantee: "), reason),
    element(
      "p",
      {},
      result.never_shorter
        ? "The solver states that no distance is below the true one."
        : "The solver may err to both sides.",
    ),
    certified
      ? element(
          "p",
          {},
          element("strong", {}, "Certified: "),
          `by its own lower bounds, distances are off by at most ${figure(certified.largest)} of themselves, ` +
            `${figure(certified.mean)} in the mean.`,
        )
      : null,
    element(
      "div",
      { class: "blocks" },
      block(
        `Stages; surface of ${counted(result.surface.faces, "face")}, ${count(result.surface.vertices)} vertices`,
        ["stage", "plugin", "s"],
        stage_rows(result),
      ),
      block("Errors |D/T − 1|", [], error_rows(result)),
      block(
        "Invariants",
        ["", "", "worst"],
        invariants.map((i): Row => [i.name, invariant_text(i), figure(i.worst)]),
      ),
      block(
        "Counters, mean of a source",
        [],
        Object.entries(counters).map(([name, value]): Row => [name, count(value)]),
      ),
      block(
        "Seconds of each source",
        [],
        seconds.sources.map((s, i): Row => [source_names[i] ?? String(i), figure(s)]),
      ),
    ),
  );
}
