// SPDX-License-Identifier: MIT
// How time, memory and counters grow with the faces of the surface: log-log, with fitted exponents.
import * as Plot from "@observablehq/plot";
import { element, section } from "./element";
import { type Figures, type GrowthStep, type Result, ran } from "./figures";
import { figure, nothing } from "./format";
import { colour_of, mark_of, symbol_of } from "./identity";
import { log_axis, responsive, tick_text } from "./plotting";

interface Quantity {
  label: string;
  value: (step: GrowthStep) => number | null;
}

interface Point {
  faces: number;
  y: number;
}

interface Curve {
  place: number;
  name: string;
  points: Point[];
}

const common: Quantity[] = [
  { label: "seconds per source", value: (step) => step.per_source },
  { label: "seconds to prepare", value: (step) => step.prepare },
  { label: "peak memory, MB", value: (step) => (step.peak_bytes === null ? null : step.peak_bytes / 1e6) },
];

function quantities_of(results: Result[]): Quantity[] {
  const counters = new Set(results.flatMap(({ growth }) => growth.flatMap((step) => Object.keys(step.counters))));
  return [
    ...common,
    ...[...counters].map((name): Quantity => ({ label: name, value: (step) => step.counters[name] ?? null })),
  ];
}

/** The exponent e of y ~ faces^e, by least squares of the logarithms; null where fewer than two sizes were measured. */
export function exponent_of(points: Point[]): number | null {
  const x = points.map(({ faces }) => Math.log(faces));
  const y = points.map((point) => Math.log(point.y));
  const mean = (values: number[]) => values.reduce((sum, v) => sum + v, 0) / values.length;
  const [mx, my] = [mean(x), mean(y)];
  const spread = x.reduce((sum, v) => sum + (v - mx) ** 2, 0);
  return points.length > 1 && spread > 0 ? x.reduce((sum, v, i) => sum + (v - mx) * (y[i]! - my), 0) / spread : null;
}

function curves_of({ combinations }: Figures, { value }: Quantity): Curve[] {
  return combinations.flatMap((c, place): Curve[] => {
    if (!ran(c)) return [];
    const points = c.growth
      .map((step): Point => ({ faces: step.faces, y: value(step) ?? 0 }))
      .filter(({ faces, y }) => y > 0 && faces > 0);
    return points.length ? [{ place, name: c.name, points }] : [];
  });
}

function draw(curves: Curve[], label: string, width: number): Node {
  const points = curves.flatMap((curve) => curve.points);
  return Plot.plot({
    width,
    height: 240,
    marginLeft: 52,
    ariaLabel: `${label} against faces, both logarithmic`,
    x: {
      type: "log",
      ...log_axis(
        points.map((p) => p.faces),
        width > 350 ? 6 : 4,
      ),
      tickFormat: tick_text,
      label: "faces",
      grid: true,
    },
    y: {
      type: "log",
      ...log_axis(
        points.map((p) => p.y),
        6,
      ),
      tickFormat: tick_text,
      label: null,
      grid: true,
    },
    marks: curves.flatMap(({ place, name, points }) => [
      Plot.line(points, { x: "faces", y: "y", stroke: colour_of(place), className: "curve" }),
      Plot.dot(points, {
        x: "faces",
        y: "y",
        fill: colour_of(place),
        symbol: symbol_of(place),
        r: 4,
        title: (p: Point) => `${name}\n${figure(p.faces)} faces\n${label}: ${figure(p.y)}`,
      }),
    ]),
  });
}

function exponents_table(figures: Figures, quantities: Quantity[]): HTMLElement {
  const heads = ["combination", ...quantities.map(({ label }) => label)];
  const curves = quantities.map((quantity) => curves_of(figures, quantity));
  const rows = figures.combinations.flatMap((c, place) => {
    if (!ran(c) || c.growth.length === 0) return [];
    const cells = curves.map((all) => {
      const curve = all.find((candidate) => candidate.place === place);
      const exponent = curve ? exponent_of(curve.points) : null;
      return element("td", { class: "number" }, exponent === null ? nothing : exponent.toFixed(2));
    });
    return [element("tr", {}, element("th", { scope: "row" }, mark_of(place), " ", c.name), ...cells)];
  });
  return element(
    "div",
    { class: "scroll", tabindex: "0", role: "region", "aria-label": "Fitted exponents" },
    element(
      "table",
      { class: "exponents" },
      element("caption", {}, "Fitted exponents e of faces^e, by least squares of the logarithms"),
      element("thead", {}, element("tr", {}, ...heads.map((head) => element("th", { scope: "col" }, head)))),
      element("tbody", {}, ...rows),
    ),
  );
}

/** The section on growth; null where no combination was measured at several sizes. */
export function growth(figures: Figures): HTMLElement | null {
  const results = figures.combinations.filter(ran);
  if (results.every((result) => result.growth.length === 0)) return null;
  const quantities = quantities_of(results).filter((quantity) => curves_of(figures, quantity).length > 0);
  const plots = quantities.map((quantity) => {
    const curves = curves_of(figures, quantity);
    const plot = responsive((width) => draw(curves, quantity.label, width)).node;
    return element("figure", { class: "growth" }, element("figcaption", {}, quantity.label), plot);
  });
  return section(
    "growth",
    "Growth with the number of faces",
    element("div", { class: "multiples" }, ...plots),
    exponents_table(figures, quantities),
  );
}
