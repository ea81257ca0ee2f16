// SPDX-License-Identifier: MIT
// The head of the page: what was compared, on what, against which truth.
import { element } from "./element";
import type { Figures } from "./figures";
import { count, counted, exactly, figure } from "./format";

function input_text({ input, targets }: Figures): string {
  const size =
    input.kind === "mesh"
      ? `mesh of ${count(input.rows)} vertices, ${count(input.faces)} faces`
      : counted(input.rows, "point");
  return `${size}, diagonal ${figure(input.diagonal, 4)}; ${counted(targets, "target")} a source`;
}

function sources_list({ sources }: Figures): HTMLElement {
  const entries = sources.map(({ entry, row, position }) =>
    element("li", { title: `at (${position.map(exactly).join(", ")})` }, row === null ? entry : `row ${row}`),
  );
  return element("ul", { class: "inline" }, ...entries);
}

export function header(figures: Figures): HTMLElement {
  const failed = figures.combinations.filter(({ error }) => error !== null).length;
  const facts: [string, Node | string][] = [
    ["Input", input_text(figures)],
    ["Truth", figures.truth.text],
    ["Sources", sources_list(figures)],
    ["Combinations", `${figures.combinations.length}${failed ? `, of which ${failed} did not run` : ""}`],
    [
      "Near, far",
      `pairs below ${exactly(figures.near)}, at least ${exactly(figures.far)} of the largest true distance`,
    ],
  ];
  return element(
    "header",
    {},
    element("h1", {}, element("span", { class: "file" }, figures.input.file)),
    element("p", { class: "version" }, `geodrome compare ${figures.version}`),
    element(
      "dl",
      { class: "facts" },
      ...facts.flatMap(([term, text]) => [element("dt", {}, term), element("dd", {}, text)]),
    ),
  );
}
