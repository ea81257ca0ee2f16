// SPDX-License-Identifier: MIT
// The section with the surfaces in 3D: menus that choose what is seen, and one picture or two under one camera.
import { floats } from "./arrays";
import { CameraControls, type Axis, make_camera, reset_camera } from "./camera";
import { type Choice, element, Menu, section } from "./element";
import { type FieldKind, isoline_spacings } from "./field";
import type { Comparison, SourceView } from "./figures";
import { figure } from "./format";
import { Frame } from "./frame";
import { SurfaceView } from "./surface_view";

const default_lines = 20;

function largest_distance({ distances }: SourceView): number {
  return floats(distances).reduce((most, d) => (Number.isFinite(d) ? Math.max(most, d) : most), 0);
}

class SurfaceSection {
  readonly node: HTMLElement;
  private readonly camera_ = make_camera();
  private readonly frame_: Frame;
  private readonly views_: [SurfaceView, SurfaceView];
  private readonly controls_: CameraControls[];
  private readonly combination_: Menu<number>;
  private readonly beside_: Menu<number | null>;
  private readonly source_: Menu<number>;
  private readonly path_: Menu<number | null>;
  private readonly kind_ = new Menu<FieldKind>(
    "Colour:",
    "field",
    [
      { label: "distance", value: "distance" },
      { label: "signed error", value: "error" },
    ],
    () => this.show(),
  );
  private readonly range_ = new Menu<boolean>(
    "Error colours:",
    "range",
    [
      { label: "to its own range", value: false },
      { label: "to the range of all", value: true },
    ],
    () => this.show(),
  );
  private readonly up_ = new Menu<Axis>(
    "Up:",
    "up",
    (["z", "y", "x"] as const).map((axis) => ({ label: axis, value: axis })),
    () => this.reset(),
  );
  private readonly slider_ = element("input", { type: "range", name: "isolines", min: "0", step: "1" });
  private readonly spacing_ = element("output");
  private spacings_: number[] = [];

  constructor(
    private readonly data_: Comparison,
    context_of: (canvas: HTMLCanvasElement) => WebGL2RenderingContext,
    drawn: () => void,
  ) {
    const combinations = data_.combinations
      .map(({ name }, value) => ({ label: name, value }))
      .filter(({ value }) => data_.view!.combinations[value]);
    this.combination_ = new Menu("Combination:", "combination", combinations, () => this.choose_source());
    this.beside_ = new Menu<number | null>(
      "Beside it:",
      "beside",
      [{ label: "none", value: null }, ...combinations],
      () => this.show(),
    );
    this.source_ = new Menu(
      "Source:",
      "source",
      data_.sources.map(({ entry, row }, value) => ({ label: row === null ? entry : `row ${row}`, value })),
      () => this.choose_source(),
    );
    this.path_ = new Menu<number | null>("Path:", "path", [{ label: "none", value: null }], () => this.show());
    this.frame_ = new Frame(
      floats(data_.view!.surfaces[data_.view!.combinations[this.combination_.value]!.surface]!.positions),
    );
    const view = () => new SurfaceView(data_, this.frame_, this.camera_, context_of, drawn);
    this.views_ = [view(), view()];
    this.controls_ = this.views_.map(({ canvas }) => new CameraControls(this.camera_, canvas, () => this.draw()));
    this.slider_.addEventListener("input", () => this.show());
    const back = element("button", { type: "button" }, "Reset view");
    back.addEventListener("click", () => this.reset());
    const isolines = element("label", {}, "Isolines: ", this.slider_, " ", this.spacing_);
    const menus = [this.combination_, this.beside_, this.source_, this.kind_, this.range_, this.path_].map(
      (menu) => menu.node,
    );
    this.node = element(
      "div",
      {},
      element("div", { class: "controls" }, ...menus, isolines, this.up_.node, back),
      element("div", { class: "views" }, ...this.views_.map((v) => v.node)),
    );
    this.choose_source();
    this.reset();
  }

  private get source_view(): SourceView {
    return this.data_.view!.combinations[this.combination_.value]!.sources[this.source_.value]!;
  }

  /** Another source or combination: other paths, and spacings that suit its distances. */
  private choose_source(): void {
    const { paths } = this.source_view;
    const had_none = this.spacings_.length === 0;
    const choices = paths.map(({ target, distance }, value): Choice<number | null> => ({
      label: `to row ${target}, D = ${figure(distance)}`,
      value,
    }));
    this.path_.offer([{ label: paths.length ? "none" : "none (the solver gives none here)", value: null }, ...choices]);
    const longest = largest_distance(this.source_view);
    this.spacings_ = isoline_spacings(longest);
    this.slider_.max = String(this.spacings_.length);
    if (had_none) {
      this.slider_.value = String(1 + this.spacings_.findIndex((spacing) => longest / spacing >= default_lines));
      this.path_.choose(Math.min(1, paths.length));
    }
    this.show();
  }

  private show(): void {
    const spacing = this.spacings_[Number(this.slider_.value) - 1] ?? null;
    this.spacing_.textContent = spacing === null ? "none" : `every ${figure(spacing, 1)}`;
    this.slider_.setAttribute("aria-valuetext", this.spacing_.textContent);
    const selection = {
      source: this.source_.value,
      kind: this.kind_.value,
      common_range: this.range_.value,
      spacing,
      path: this.path_.value,
    };
    const [first, second] = this.views_;
    const beside = this.beside_.value;
    second.node.hidden = beside === null;
    first.show({ ...selection, combination: this.combination_.value });
    if (beside !== null) second.show({ ...selection, combination: beside });
  }

  private reset(): void {
    reset_camera(this.camera_, this.up_.value);
    for (const controls of this.controls_) controls.update();
  }

  private draw(): void {
    for (const view of this.views_) if (!view.node.hidden) view.draw();
  }
}

/**
 * The section on the surfaces; `drawn` is called after each frame. Where there is no WebGL or nothing to show, it
 * says so.
 */
export function surface_section(data: Comparison, drawn: () => void): HTMLElement {
  const said = (text: string) => section("surface", "The surface", element("p", { class: "absent" }, text));
  if (!data.view?.combinations.some((combination) => combination !== null))
    return said("There is no surface to show: no combination ran.");
  const context_of = (canvas: HTMLCanvasElement) => {
    const context = canvas.getContext("webgl2", { antialias: true, alpha: true });
    if (!context) throw new Error("this browser has no WebGL 2, or it is switched off");
    return context;
  };
  try {
    return section("surface", "The surface", new SurfaceSection(data, context_of, drawn).node);
  } catch (error) {
    return said(`The surface cannot be shown: ${(error as Error).message}.`);
  }
}
