// SPDX-License-Identifier: MIT
// The page of `geodrome compare --html`: reads the data that the engine put into it, and shows it section by section.
import { element, section } from "./element";
import { error_time_plot } from "./error_time_plot";
import { type Comparison, read_comparison } from "./figures";
import { growth } from "./growth";
import { header } from "./header";
import { histograms } from "./histograms";
import { surface_section } from "./surface_section";
import { table } from "./table";

declare global {
  interface Window {
    /** For tests: whether the page is complete, and how many frames the 3D view has drawn. */
    geodrome: { ready: boolean; frames: number };
  }
}

window.geodrome = { ready: false, frames: 0 };

function sections(data: Comparison): (Node | null)[] {
  return [
    section("combinations", "Combinations", table(data)),
    error_time_plot(data),
    histograms(data),
    growth(data),
    surface_section(data, () => ++window.geodrome.frames),
  ];
}

function show(page: HTMLElement): void {
  try {
    const data = read_comparison(document);
    if (!data) throw new Error("it is the empty template that geodrome compare --html fills");
    document.title = `${data.input.file}: geodrome compare`;
    page.before(header(data));
    page.append(...sections(data).filter((node): node is Node => node !== null));
  } catch (error) {
    page.replaceChildren(
      element("p", { class: "absent" }, `This page shows no comparison: ${(error as Error).message}.`),
    );
  }
  window.geodrome.ready = true;
}

show(document.querySelector("main")!);
