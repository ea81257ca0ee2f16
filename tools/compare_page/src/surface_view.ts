// SPDX-License-Identifier: MIT
// One picture of a surface with what belongs under it: the legend, the path in numbers, the vertex that was clicked.
import type * as THREE from "three";
import { floats, indices } from "./arrays";
import { colour_gradient } from "./colour_maps";
import { element } from "./element";
import { type Field, type FieldKind, error_range, field_of } from "./field";
import type { Comparison, SourceView } from "./figures";
import { count, exactly, figure } from "./format";
import { Frame } from "./frame";
import { Scene } from "./scene";

/** What is to be seen of a combination. */
export interface Selection {
  combination: number;
  source: number;
  kind: FieldKind;
  common_range: boolean;
  /** Distance from an isoline to the next; null: none. */
  spacing: number | null;
  /** Which of the source's paths; null: none. */
  path: number | null;
}

export class SurfaceView {
  readonly node: HTMLElement;
  readonly canvas = element("canvas", { tabindex: "0", role: "img" });
  private readonly scene_: Scene;
  private readonly title_ = element("figcaption");
  private readonly legend_ = element("div", { class: "legend" });
  private readonly readout_ = element("p", { class: "readout", "aria-live": "polite" });
  private surface_: number | null = null;
  private field_: { field: Field; source: SourceView } | null = null;

  constructor(
    private readonly data_: Comparison,
    private readonly frame_: Frame,
    camera: THREE.PerspectiveCamera,
    context_of: (canvas: HTMLCanvasElement) => WebGL2RenderingContext,
    drawn: () => void,
  ) {
    this.scene_ = new Scene(this.canvas, context_of(this.canvas), camera, drawn);
    this.node = element("figure", { class: "surface" }, this.title_, this.canvas, this.legend_, this.readout_);
    this.canvas.addEventListener("click", (event) => this.tell_vertex(event));
  }

  show(selection: Selection): void {
    const { name } = this.data_.combinations[selection.combination]!;
    const { surface, sources } = this.data_.view!.combinations[selection.combination]!;
    const source = sources[selection.source]!;
    this.show_surface(surface);
    const field = field_of(source, selection.kind, selection.common_range ? this.range_of_all(selection.source) : null);
    const isolines = selection.spacing === null ? 0 : field.largest_distance / selection.spacing;
    this.field_ = { field, source };
    this.scene_.field(field, isolines);
    this.scene_.source(this.data_.sources[selection.source]!.position, this.frame_);
    const path = selection.path === null ? undefined : source.paths[selection.path];
    this.scene_.path(path ? floats(path.points) : new Float32Array(), this.frame_);
    this.title_.replaceChildren(name);
    this.canvas.setAttribute(
      "aria-label",
      `Surface of ${name}, coloured by ${selection.kind}; arrow keys turn it, plus and minus zoom`,
    );
    this.legend_.replaceChildren(...legend(field));
    this.readout_.textContent = path ? path_text(path) : "Click on the surface to read a vertex.";
  }

  draw(): void {
    this.scene_.draw();
  }

  private show_surface(index: number): void {
    if (this.surface_ === index) return;
    const { positions, triangles } = this.data_.view!.surfaces[index]!;
    this.scene_.surface(floats(positions), indices(triangles), this.frame_);
    this.surface_ = index;
  }

  private range_of_all(source: number): number {
    const views = this.data_.view!.combinations.flatMap((view) => view?.sources[source] ?? []);
    return Math.max(...views.map(({ errors }) => error_range(floats(errors))));
  }

  private tell_vertex({ offsetX, offsetY }: MouseEvent): void {
    const { clientWidth, clientHeight } = this.canvas;
    const vertex = this.scene_.vertex_at((2 * offsetX) / clientWidth - 1, 1 - (2 * offsetY) / clientHeight);
    if (vertex === null || !this.field_) return;
    const { source } = this.field_;
    const [d, e] = [floats(source.distances)[vertex]!, floats(source.errors)[vertex]!];
    const error = Number.isNaN(e) ? "not known" : figure(e);
    this.readout_.textContent = `Vertex ${vertex}: D = ${figure(d, 6)}, D/T − 1 = ${error}`;
  }
}

function path_text({ target, distance, length }: SourceView["paths"][number]): string {
  const difference = length === distance ? "no difference" : `length/D − 1 = ${figure(length / distance - 1)}`;
  return `Path to row ${target}: length ${exactly(length)}, D ${exactly(distance)}; ${difference}`;
}

function legend(field: Field): HTMLElement[] {
  const beyond = field.kind === "error";
  const at = (share: number) => field.low + share * (field.high - field.low);
  const signed = (value: number) => (beyond && value > 0 ? "+" : "") + figure(value);
  const prefix = (share: number) =>
    !beyond || field.high === 0
      ? ""
      : share === 0 && field.smallest < field.low
        ? "≤ "
        : share === 1 && field.largest > field.high
          ? "≥ "
          : "";
  const numbers = [0, 0.25, 0.5, 0.75, 1].map((share) => element("span", {}, prefix(share) + signed(at(share))));
  const bar = element("div", { class: "bar" });
  bar.style.backgroundImage = colour_gradient(field.kind);
  const what = beyond ? "D/T − 1: blue is too short, red too long" : "distance D";
  const range =
    field.smallest > field.largest ? "no values" : `from ${signed(field.smallest)} to ${signed(field.largest)}`;
  return [
    element("p", {}, `${what}; ${range}`),
    bar,
    element("div", { class: "numbers" }, ...numbers),
    ...swatch("unreached", field.unreached_count, "unreachable"),
    ...swatch("missing", field.missing_count, beyond ? "without an error (not compared)" : "not computed"),
  ];
}

function swatch(kind: string, vertices: number, words: string): HTMLElement[] {
  if (vertices === 0) return [];
  return [
    element(
      "p",
      {},
      element("span", { class: `swatch ${kind}` }),
      ` ${count(vertices)} ${vertices === 1 ? "vertex" : "vertices"} ${words}`,
    ),
  ];
}
