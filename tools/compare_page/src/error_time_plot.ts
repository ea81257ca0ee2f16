// SPDX-License-Identifier: MIT
// Error against time, one mark a combination; an error of 0 has no place on a logarithmic axis and is drawn on a
// floor of its own.
import * as Plot from "@observablehq/plot";
import { largest_error, stage_seconds } from "./columns";
import { type Choice, element, Menu, section } from "./element";
import { type Figures, type Result, ran } from "./figures";
import { figure } from "./format";
import { colour_of, mark_of, symbol_of } from "./identity";
import { log_axis, pixel, responsive, smallest, tick_text, write_labels } from "./plotting";

type Measure = (result: Result) => number | null;

const times: Choice<Measure>[] = [
  { label: "seconds per source", value: ({ seconds }) => seconds.per_source },
  { label: "seconds to prepare and search once", value: ({ seconds }) => seconds.prepare + seconds.per_source },
  {
    label: "seconds in all (stages, prepare, sources)",
    value: (r) => (stage_seconds(r) ?? 0) + r.seconds.prepare + r.seconds.sources.reduce((a, b) => a + b, 0),
  },
];
const errors: Choice<Measure>[] = [
  { label: "mean relative error", value: (r) => r.errors.mean },
  { label: "99 % quantile of relative errors", value: (r) => r.errors.quantiles["0.99"] ?? null },
  { label: "largest relative error", value: largest_error },
  { label: "mean relative error of near pairs", value: (r) => r.errors.near.mean },
  { label: "mean relative error of far pairs", value: (r) => r.errors.far.mean },
];

interface Mark {
  place: number;
  name: string;
  time: number;
  error: number;
  y: number;
}

const shortest_time = 1e-9; // what a clock tells apart
const room_for_labels = 520;

/** The marks, and the floor where errors of 0 are drawn: a decade and a half below the others. */
function marks_of({ combinations }: Figures, time: Measure, error: Measure): { marks: Mark[]; floor: number } {
  const marks = combinations.flatMap((c, place): Mark[] => {
    if (!ran(c)) return [];
    const [t, e] = [time(c), error(c)];
    if (t === null || e === null || !Number.isFinite(t) || !Number.isFinite(e)) return [];
    return [{ place, name: c.name, time: Math.max(t, shortest_time), error: e, y: e }];
  });
  const positive = marks.map(({ error }) => error).filter((e) => e > 0);
  const floor = Math.max((positive.length ? Math.min(...positive) : 1e-16) / 30, smallest);
  for (const mark of marks) mark.y = Math.max(mark.error, floor);
  return { marks, floor };
}

const legend = (marks: Mark[]) =>
  element(
    "ul",
    { class: "legend-list" },
    ...marks.map(({ place, name }) => element("li", {}, mark_of(place), " ", name)),
  );

function draw(figures: Figures, time: Choice<Measure>, error: Choice<Measure>, width: number): Node {
  const { marks, floor } = marks_of(figures, time.value, error.value);
  if (marks.length === 0) return element("p", {}, "Nothing to draw: no combination has such an error.");
  const zeros = marks.some((mark) => mark.y === floor);
  const x = log_axis(
    marks.map((mark) => mark.time),
    width > 500 ? 9 : 5,
  );
  const y = log_axis(
    marks.map((mark) => mark.y),
    9,
  );
  const options = (mark: Mark) => ({
    x: "time" as const,
    y: "y" as const,
    r: 5,
    symbol: symbol_of(mark.place),
    fill: colour_of(mark.place),
    ariaLabel: (m: Mark) => `${m.name}: ${figure(m.time)} s, error ${figure(m.error)}`,
  });
  const title = (m: Mark) => `${m.name}\n${figure(m.time)} s\nerror ${figure(m.error)}`;
  const drawn = Plot.plot({
    width,
    height: 340,
    marginLeft: 56,
    ariaLabel: `${error.label} against ${time.label}, both logarithmic`,
    x: { type: "log", ...x, tickFormat: tick_text, label: time.label, grid: true },
    y: {
      type: "log",
      domain: y.domain,
      ticks: y.ticks.filter((t) => !zeros || t > floor * 3),
      tickFormat: tick_text,
      label: error.label,
      grid: true,
    },
    marks: [
      ...(zeros
        ? [
            Plot.ruleY([floor], { strokeDasharray: "4 3", className: "floor" }),
            Plot.text([floor], {
              y: (v: number) => v,
              frameAnchor: "left",
              dx: -8,
              textAnchor: "end",
              text: () => "0",
            }),
          ]
        : []),
      ...marks.map((mark) => Plot.dot([mark], { ...options(mark), className: "combination-mark" })),
      Plot.tip(marks, Plot.pointer({ x: "time", y: "y", title })),
    ],
  });
  if (width < room_for_labels) return element("div", {}, drawn, legend(marks));
  write_labels(
    drawn,
    marks.map((m) => ({
      x: pixel(drawn, "x", m.time),
      y: pixel(drawn, "y", m.y),
      lift: m.y === floor ? 12 : 0,
      text: m.name,
    })),
    width,
  );
  return drawn;
}

export function error_time_plot(figures: Figures): HTMLElement {
  const changed = () => plot.redraw();
  const named = (choices: Choice<Measure>[]) => choices.map((choice) => ({ label: choice.label, value: choice }));
  const time = new Menu("Time:", "time", named(times), changed);
  const error = new Menu("Error:", "error", named(errors), changed);
  const plot = responsive((width) => draw(figures, time.value, error.value, width));
  return section(
    "error-time",
    "Error against time",
    element("div", { class: "controls" }, error.node, time.node),
    plot.node,
  );
}
