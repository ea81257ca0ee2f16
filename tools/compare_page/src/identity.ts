// SPDX-License-Identifier: MIT
// How a combination is told from the others: by a colour and by the shape of its mark, so that colour alone never
// matters.
import {
  symbol,
  symbolCircle,
  symbolCross,
  symbolDiamond,
  symbolSquare,
  symbolStar,
  symbolTriangle,
  symbolWye,
  type SymbolType,
} from "d3-shape";

// Readable on white and on near-black.
const colours = ["#3778c6", "#d2691e", "#1b9074", "#a05fd0", "#cf4560", "#7f8420", "#2497b4", "#99694f"];
const symbols: SymbolType[] = [
  symbolCircle,
  symbolSquare,
  symbolTriangle,
  symbolDiamond,
  symbolStar,
  symbolCross,
  symbolWye,
];

export const colour_of = (combination: number) => colours[combination % colours.length]!;
export const symbol_of = (combination: number) => symbols[combination % symbols.length]!;

/** The mark of a combination, as a small picture. */
export function mark_of(combination: number): SVGElement {
  const picture = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  for (const [name, value] of Object.entries({
    width: "12",
    height: "12",
    viewBox: "-6 -6 12 12",
    class: "mark",
    "aria-hidden": "true",
  }))
    picture.setAttribute(name, value);
  const shape = document.createElementNS("http://www.w3.org/2000/svg", "path");
  shape.setAttribute("d", symbol(symbol_of(combination), 40)() ?? "");
  shape.setAttribute("fill", colour_of(combination));
  picture.append(shape);
  return picture;
}
