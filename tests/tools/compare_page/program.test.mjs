// SPDX-License-Identifier: MIT
// The page that the program writes of comparisons that it has run: it opens, and shows the figures that the program
// prints.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import path from "node:path";
import { test } from "node:test";
import { choose, difference, in_folder, picture, share, with_file } from "./browser.mjs";

function geodrome(folder, ...words) {
  const { status, stdout, stderr } = spawnSync(process.env.GEODROME_PROGRAM, words, { cwd: folder, encoding: "utf8" });
  return { status, stdout, stderr };
}

/** Runs `test(page, log, figures)` on the page of a comparison of `input`, made by `shape`. */
async function with_comparison(shape, input, options, test) {
  await in_folder(async (folder) => {
    assert.equal(geodrome(folder, "shape", ...shape, "-o", input).status, 0);
    const { stdout, stderr } = geodrome(
      folder,
      "compare",
      input,
      ...options,
      "--html",
      "page.html",
      "--json",
      "--quiet",
    );
    assert.notEqual(stdout, "", stderr);
    await with_file(path.join(folder, "page.html"), (page, log) => test(page, log, JSON.parse(stdout)));
  });
}

const value = (page, place, column) =>
  page.locator(`tr[data-combination="${place}"] [data-column=${column}] data`).getAttribute("value").then(Number);

async function expect_table(page, figures) {
  for (const [place, combination] of figures.combinations.entries()) {
    if (combination.error !== null) continue;
    assert.equal(await value(page, place, "faces"), combination.surface.faces);
    assert.equal(await value(page, place, "prepare"), combination.seconds.prepare);
    assert.equal(await value(page, place, "mean"), combination.errors.mean);
    assert.equal(await value(page, place, "max_over"), combination.errors.max_over);
    assert.equal(await value(page, place, "unreachable"), combination.unreachable);
  }
}

const is_coloured = (colour) => Math.max(...colour) - Math.min(...colour) > 60;

test("solvers on a mesh, with growth and paths", () =>
  with_comparison(
    ["bumpy", "--mesh", "--faces", "1000"],
    "bumpy.ply",
    ["--stage", "solver=chen_han,edge_dijkstra", "--sources", "0,100", "--truth", "exact", "--growth", "1"],
    async (page, log, figures) => {
      await expect_table(page, figures);
      assert.equal(await page.locator("h2", { hasText: "Growth" }).count(), 1);
      const canvas = page.locator("canvas").first();
      const first = await picture(canvas);
      assert.ok(share(first, is_coloured) > 0.05, "the surface is coloured");
      await choose(page, "source", 1);
      assert.ok(difference(first, await picture(canvas)) > 0.02, "another source gives another picture");
      assert.ok((await page.locator("select[name=path] option").count()) > 1, "paths to choose from");
      assert.deepEqual(log.errors, []);
      assert.equal(log.requests.length, 1);
    },
  ));

test("reconstructors on a sample, one of which refuses it", () =>
  with_comparison(
    ["torus", "--points", "800"],
    "torus.xyz",
    ["--stage", "reconstructor=delaunay_cut,stars", "--sources", "0,9"],
    async (page, log, figures) => {
      assert.deepEqual(
        figures.combinations.map(({ error }) => error?.status ?? 0),
        [0, 4],
      );
      await expect_table(page, figures);
      assert.equal(await page.locator(".failed").count(), 1);
      assert.ok(share(await picture(page.locator("canvas").first()), is_coloured) > 0.05);
      assert.deepEqual(log.errors, []);
    },
  ));
