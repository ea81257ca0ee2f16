// SPDX-License-Identifier: MIT
// How often which error occurs: small multiples on common axes, log10 |D/T - 1|, targets without any error as a bar
// of their own.
import * as Plot from "@observablehq/plot";
import { element, section } from "./element";
import { type Figures, type Result, ran } from "./figures";
import { count, figure } from "./format";
import { colour_of, mark_of } from "./identity";
import { responsive } from "./plotting";

interface Bar {
  from: number;
  to: number;
  share: number;
  text: string;
}

const percent = (share: number) => `${figure(100 * share)} %`;

/** The bars of a histogram, on decades; the one of zeros lies in [zero, zero + 1]. */
function bars_of({ errors: { histogram } }: Result, zero: number): Bar[] {
  const { counts, decades } = histogram;
  const all = counts.reduce((sum, n) => sum + n, histogram.zero) || 1;
  const told = (n: number) => `${count(n)} targets, ${percent(n / all)}`;
  const bars = counts.map((n, i): Bar => {
    const [from, to] = [decades[i]!, decades[i + 1]!];
    return { from, to, share: n / all, text: `${figure(10 ** from)} to ${figure(10 ** to)}\n${told(n)}` };
  });
  return [
    { from: zero, to: zero + 1, share: histogram.zero / all, text: `no error\n${told(histogram.zero)}` },
    ...bars,
  ].filter((bar) => bar.share > 0);
}

interface Frame {
  zero: number;
  first: number;
  last: number;
  highest: number;
}

/** Common axes of all histograms: whole decades that hold every bar, the bar of zeros before them. */
function frame_of(results: Result[]): Frame {
  const used = results.flatMap((r) => bars_of(r, NaN)).filter((bar) => !Number.isNaN(bar.from));
  const first = Math.floor(Math.min(...used.map((bar) => bar.from), -1));
  const last = Math.ceil(Math.max(...used.map((bar) => bar.to), 0));
  const zero = first - 2;
  return {
    zero,
    first,
    last,
    highest: Math.max(...results.flatMap((r) => bars_of(r, zero)).map((bar) => bar.share), 0),
  };
}

function draw(result: Result, place: number, { zero, first, last, highest }: Frame, width: number): Node {
  const decades = Array.from({ length: last - first + 1 }, (_, i) => first + i);
  const step = Math.ceil(decades.length / (width / 42));
  const bars = bars_of(result, zero);
  return Plot.plot({
    width,
    height: 120,
    marginLeft: 40,
    marginTop: 8,
    marginBottom: 24,
    ariaLabel: `Histogram of relative errors of ${result.name}`,
    x: {
      domain: [zero - 0.3, last],
      ticks: [zero + 0.5, ...decades.filter((d) => d % step === 0)],
      tickFormat: (d: number) => (d < first ? "0" : d === 0 ? "1" : `1e${d}`),
      label: null,
    },
    y: {
      domain: [0, highest],
      ticks: 3,
      tickFormat: (share: number) => `${Math.round(100 * share)} %`,
      label: null,
      grid: true,
    },
    marks: [
      Plot.ruleX([first - 0.5], { strokeOpacity: 0.35, strokeDasharray: "2 3" }),
      Plot.rectY(bars, {
        x1: "from",
        x2: "to",
        y: "share",
        fill: colour_of(place),
        insetLeft: 0.5,
        insetRight: 0.5,
        className: "bars",
      }),
      Plot.ruleY([0]),
      Plot.tip(bars, Plot.pointerX({ x: (bar: Bar) => (bar.from + bar.to) / 2, y: "share", title: "text" })),
    ],
  });
}

export function histograms({ combinations }: Figures): HTMLElement {
  const frame = frame_of(combinations.filter(ran));
  const multiples = combinations.flatMap((c, place) => {
    if (!ran(c)) return [];
    const plot = responsive((width) => draw(c, place, frame, width)).node;
    return [element("figure", { class: "histogram" }, element("figcaption", {}, mark_of(place), " ", c.name), plot)];
  });
  return section(
    "histograms",
    "Relative errors, share of targets",
    element("div", { class: "multiples" }, ...multiples),
  );
}
