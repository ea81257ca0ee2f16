// SPDX-License-Identifier: MIT
// How a combination is told from the others: by a colour and by the shape of its mark, so that colour alone never matters.
import * as Plot from "@observablehq/plot";
import type { SymbolType } from "@observablehq/plot";

// Readable on white and on near-black.
const colours = ["#3778c6", "#d2691e", "#1b9074", "#a05fd0", "#cf4560", "#7f8420", "#2497b4", "#99694f"];
const symbols: SymbolType[] = ["circle", "square", "triangle", "diamond", "star", "cross", "wye"];

export const colour_of = (combination: number) => colours[combination % colours.length]!;
export const symbol_of = (combination: number) => symbols[combination % symbols.length]!;

/** The mark of a combination, as a small picture. */
export function mark_of(combination: number): SVGElement | HTMLElement {
  const picture = Plot.plot({
    width: 12,
    height: 12,
    margin: 0,
    axis: null,
    x: { domain: [0, 1] },
    y: { domain: [0, 1] },
    marks: [Plot.dot([[0.5, 0.5]], { r: 3.6, symbol: symbol_of(combination), fill: colour_of(combination) })],
  });
  picture.setAttribute("aria-hidden", "true");
  picture.classList.add("mark");
  return picture;
}
