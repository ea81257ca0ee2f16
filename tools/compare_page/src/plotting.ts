// SPDX-License-Identifier: MIT
// What all plots share: how they fill their room, logarithmic axes, and words.
import * as Plot from "@observablehq/plot";
import { element } from "./element";

type Drawn = ReturnType<typeof Plot.plot>;

/**
 * A box that holds what `draw` makes for its width, made anew when that changes; `redraw` makes it anew with other
 * choices.
 */
export function responsive(draw: (width: number) => Node): { node: HTMLElement; redraw: () => void } {
  const node = element("div", { class: "plot" });
  let width = 0;
  const redraw = () => {
    if (width > 0) node.replaceChildren(draw(width));
  };
  new ResizeObserver(([entry]) => {
    const now = Math.floor(entry!.contentRect.width);
    if (now === width) return;
    width = now;
    redraw();
  }).observe(node);
  return { node, redraw };
}

// Of a logarithmic axis: room for its ends to be moved outwards.
export const smallest = 1e-300;
const largest = 1e300;

export interface LogAxis {
  domain: [number, number];
  ticks: number[];
}

const power_of_ten = (exponent: number) => Number(`1e${exponent}`);

/**
 * A logarithmic axis around positive values, with at most about `most` ticks: decades, or 1, 2, 5 where there are
 * few.
 */
export function log_axis(values: number[], most: number): LogAxis {
  const low = Math.max(Math.min(...values) / 1.5, smallest);
  const high = Math.min(Math.max(...values) * 1.5, largest);
  const first = Math.floor(Math.log10(low));
  const last = Math.ceil(Math.log10(high));
  const step = Math.ceil((last - first) / most);
  const mantissas = last - first <= most / 3 ? [1, 2, 5] : [1];
  const ticks: number[] = [];
  for (let e = first; e <= last; ++e)
    if (e % step === 0) ticks.push(...mantissas.map((m) => m * power_of_ten(e)).filter((t) => t >= low && t <= high));
  return { domain: [low, high], ticks };
}

/** The number at a tick: few characters. */
export const tick_text = (value: number) => {
  if (value >= 0.0099 && value < 1e4) return String(Number(value.toPrecision(3)));
  return value.toExponential(0).replace("+", "");
};

interface Label {
  x: number;
  y: number;
  /** How much higher than its point it should stand, if there is room. */
  lift: number;
  text: string;
}

const letter_width = 6.2;
const line_height = 12;

/** Writes labels beside their points, each where it covers none before it, if there is such a place. */
export function write_labels(drawn: Drawn, labels: Label[], width: number): void {
  const group = document.createElementNS("http://www.w3.org/2000/svg", "g");
  group.setAttribute("class", "labels");
  group.setAttribute("text-anchor", "start");
  const taken: { left: number; right: number; y: number }[] = labels.map(({ x, y }) => ({
    left: x - 5,
    right: x + 5,
    y,
  }));
  for (const { x, y, lift, text } of labels) {
    const length = text.length * letter_width;
    const places = [-lift, 0, -12, 12, -24, 24, -36, 36].flatMap((dy) => [
      { left: x + 9, right: x + 9 + length, y: y + dy },
      { left: x - 9 - length, right: x - 9, y: y + dy },
    ]);
    const inside = places.filter(({ left, right }) => left >= 0 && right <= width);
    const free = inside.find((p) =>
      taken.every((t) => Math.abs(t.y - p.y) >= line_height || t.right < p.left || t.left > p.right),
    );
    const place = free ?? inside[0] ?? places[0]!;
    taken.push(place);
    const node = document.createElementNS("http://www.w3.org/2000/svg", "text");
    node.setAttribute("x", String(place.left));
    node.setAttribute("y", String(place.y + 4));
    node.textContent = text;
    group.append(node);
  }
  drawn.append(group);
}

/** The place of a value on an axis of a plot, in pixels. */
export const pixel = (drawn: Drawn, axis: "x" | "y", value: number) => drawn.scale(axis)!.apply(value) as number;
