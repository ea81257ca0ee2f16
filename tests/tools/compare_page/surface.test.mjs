// SPDX-License-Identifier: MIT
// The surface in 3D, as pixels: it is there, and changes with what is chosen.
import assert from "node:assert/strict";
import { test } from "node:test";
import { choose, difference, picture, settled, share, with_page as with_any_page } from "./browser.mjs";
import { sample } from "./sample.mjs";

const data = sample({ growth: false });
// A small window: without a GPU, pixels cost time.
const with_page = (shown, body, options) =>
  with_any_page(shown, body, { viewport: { width: 800, height: 640 }, ...options });
const isolines = (page, value) =>
  page
    .locator("input[name=isolines]")
    .fill(String(value))
    .then(() => settled(page));
const canvas = (page) => picture(page.locator("canvas").first());

const grey = ([r, g, b]) => Math.max(r, g, b) - Math.min(r, g, b) < 8;
const coloured = (colour) => Math.max(...colour) - Math.min(...colour) > 40;
const white = (colour) => colour.every((c) => c > 250);
const path_coloured = ([r, g, b]) => r > 220 && g < 90 && b > 170;

test("the surface is drawn, in many colours, beside empty ground", () =>
  with_page(data, async (page) => {
    await isolines(page, 0);
    const seen = await canvas(page);
    assert.ok(share(seen, coloured) > 0.08, "the torus");
    assert.ok(share(seen, white) > 0.4, "the ground");
    const colours = new Set();
    share(seen, (colour) => coloured(colour) && colours.add(colour.map((c) => c >> 4).join()));
    assert.ok(colours.size > 50, `${colours.size} colours`);
    assert.ok(await page.evaluate(() => window.geodrome.frames > 0));
  }));

for (const [menu, place, least] of [
  ["field", 1, 0.05],
  ["source", 1, 0.05],
  ["combination", 4, 0.002],
])
  test(`another ${menu} changes what is seen`, () =>
    with_page(data, async (page) => {
      await choose(page, "path", 0);
      const before = await canvas(page);
      await choose(page, menu, place);
      const changed = difference(before, await canvas(page));
      assert.ok(changed > least, `${changed} of the pixels`);
    }));

test("the same choice twice is the same picture", () =>
  with_page(data, async (page) => {
    const before = await canvas(page);
    await choose(page, "field", 1);
    await choose(page, "field", 0);
    assert.equal(difference(before, await canvas(page)), 0);
  }));

test("isolines appear, and more of them at a smaller spacing", () =>
  with_page(data, async (page) => {
    await choose(page, "path", 0);
    await isolines(page, 0);
    assert.match(await page.locator("#surface output").textContent(), /none/);
    const without = await canvas(page);
    await isolines(page, 2);
    assert.match(await page.locator("#surface output").textContent(), /^every 0\.5/);
    const few = difference(without, await canvas(page));
    await isolines(page, 4);
    const more = difference(without, await canvas(page));
    assert.ok(few > 0.002 && more > 1.5 * few, `${few}, ${more}`);
  }));

test("a path is drawn, and its length is told against D", () =>
  with_page(data, async (page) => {
    const { target, length, distance } = data.view.combinations[0].sources[0].paths[0];
    const seen = await canvas(page);
    assert.ok(share(seen, path_coloured) > 0.001);
    const text = await page.locator(".readout").first().textContent();
    assert.ok(text.includes(`row ${target}: length ${length}, D ${distance}`), text);
    await choose(page, "path", 0);
    assert.equal(share(await canvas(page), path_coloured), 0);
    await choose(page, "path", 2);
    assert.ok(difference(seen, await canvas(page)) > 0.001);
  }));

test("a solver without paths offers none", () =>
  with_page(data, async (page) => {
    await choose(page, "combination", 4);
    assert.match(await page.locator("select[name=path]").textContent(), /gives none here/);
    assert.equal(share(await canvas(page), path_coloured), 0);
  }));

test("unreachable and uncomputed vertices are grey, counted and told", () =>
  with_page(data, async (page) => {
    await choose(page, "path", 0);
    await isolines(page, 0);
    const without_nan = share(await canvas(page), (colour) => grey(colour) && !white(colour));
    assert.match(await page.locator(".legend").first().textContent(), /108 vertices unreachable/);
    assert.ok(without_nan > 0.0025, `the sphere: ${without_nan}`);
    await choose(page, "combination", 4);
    const with_nan = share(await canvas(page), (colour) => grey(colour) && !white(colour));
    assert.match(await page.locator(".legend").first().textContent(), /40 vertices not computed/);
    assert.ok(with_nan > without_nan + 0.002, `${with_nan} after ${without_nan}`);
  }));

/** The numbers under the colour map. */
const legend = (page, view = 0) => page.locator(".legend").nth(view).locator(".numbers span").allTextContents();

test("the legend has the range of distances, and a symmetric one of errors", () =>
  with_page(data, async (page) => {
    const floats = (text) => new Float32Array(Uint8Array.from(Buffer.from(text, "base64")).buffer);
    const longest = Math.max(...floats(data.view.combinations[0].sources[0].distances).filter(Number.isFinite));
    assert.deepEqual([(await legend(page))[0], (await legend(page)).at(-1)], ["0", longest.toPrecision(3)]);
    await choose(page, "combination", 3);
    await choose(page, "field", 1);
    const errors = (await legend(page)).map((text) => Number(text.replace(/[≤≥ ]/g, "")));
    assert.equal(errors[2], 0);
    assert.equal(errors[0], -errors[4]);
    assert.ok(errors[4] > 0.11 && errors[4] <= 0.12);
  }));

test("errors of one sign have the colours of one side", () =>
  with_page(data, async (page) => {
    await choose(page, "path", 0);
    await isolines(page, 0);
    await choose(page, "field", 1);
    const red = ([r, , b]) => r > b + 60;
    const blue = ([r, , b]) => b > r + 60;
    await choose(page, "combination", 3);
    let seen = await canvas(page);
    assert.ok(share(seen, red) > 0.02 && share(seen, blue) === 0, "too long is red");
    await choose(page, "combination", 5);
    seen = await canvas(page);
    assert.ok(share(seen, blue) > 0.02 && share(seen, red) === 0, "too short is blue");
  }));

test("two combinations stand side by side under one camera", () =>
  with_page(data, async (page) => {
    assert.equal(await page.locator("figure.surface:visible").count(), 1);
    await choose(page, "path", 0);
    await choose(page, "field", 1);
    await choose(page, "combination", 3);
    await choose(page, "beside", 4);
    assert.equal(await page.locator("figure.surface:visible").count(), 2);
    const same = await picture(page.locator("canvas").nth(1));
    assert.ok(difference(await canvas(page), same) < 0.001, "the same combination looks the same");
    await choose(page, "beside", 6);
    const other = await picture(page.locator("canvas").nth(1));
    assert.ok(difference(same, other) > 0.02, "another one does not");
    await page.locator("canvas").first().press("ArrowLeft");
    await settled(page);
    assert.ok(difference(other, await picture(page.locator("canvas").nth(1))) > 0.02, "both turn");
  }));

test("the range of all makes the error colours of two combinations comparable", () =>
  with_page(data, async (page) => {
    await choose(page, "field", 1);
    await choose(page, "combination", 2);
    await choose(page, "beside", 4);
    assert.notDeepEqual(await legend(page, 0), await legend(page, 1));
    await choose(page, "range", 1);
    const ends = [0, 1].map(async (view) => Number((await legend(page, view))[4].replace(/[≥ ]/g, "")));
    assert.equal(await ends[0], await ends[1]);
  }));

test("mouse and keys turn and zoom, and there is a way back", () =>
  with_page(data, async (page) => {
    const target = page.locator("canvas").first();
    const start = await canvas(page);
    const box = await target.boundingBox();
    const moves = {
      drag: async () => {
        await page.mouse.move(box.x + 300, box.y + 200);
        await page.mouse.down();
        await page.mouse.move(box.x + 420, box.y + 240, { steps: 4 });
        await page.mouse.up();
      },
      wheel: async () => {
        await page.mouse.move(box.x + 300, box.y + 200);
        await page.mouse.wheel(0, -300);
      },
      ...Object.fromEntries(
        ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "+", "-"].map((key) => [key, () => target.press(key)]),
      ),
    };
    await target.scrollIntoViewIfNeeded();
    Object.assign(box, await target.boundingBox());
    for (const [name, move] of Object.entries(moves)) {
      await move();
      await settled(page);
      assert.ok(difference(start, await canvas(page)) > 0.01, name);
      await page.getByText("Reset view").click();
      await settled(page);
      assert.ok(difference(start, await canvas(page)) < 0.001, `back after ${name}`);
    }
  }));

test("a click on the surface reads the vertex there, one beside it does not", () =>
  with_page(data, async (page) => {
    const target = page.locator("canvas").first();
    const readout = page.locator(".readout").first();
    const before = await readout.textContent();
    await target.click({ position: { x: 20, y: 20 } });
    assert.equal(await readout.textContent(), before);
    await isolines(page, 0);
    const seen = await canvas(page);
    const middle = Math.floor(seen.width / 2);
    const y = Array.from({ length: seen.height }, (_, i) => seen.height - 1 - i).find((row) =>
      coloured(seen.at(middle, row)),
    );
    await target.click({ position: { x: middle, y: y - 12 } });
    const [, vertex, distance] = (await readout.textContent()).match(/^Vertex (\d+): D = ([\d.]+), D\/T − 1 = 0$/);
    const distances = new Float32Array(
      Uint8Array.from(Buffer.from(data.view.combinations[0].sources[0].distances, "base64")).buffer,
    );
    assert.ok(Math.abs(distances[vertex] - Number(distance)) < 1e-5 * distances[vertex]);
  }));

test("without WebGL the page says so in its place, and the rest works", () =>
  with_page(
    data,
    async (page, log) => {
      assert.match(await page.locator("#surface").textContent(), /cannot be shown: this browser has no WebGL 2/);
      assert.equal(await page.locator("canvas").count(), 0);
      assert.equal(await page.locator("tr[data-combination]").count(), data.combinations.length);
      assert.deepEqual(log.errors, []);
    },
    { webgl: false },
  ));

test("coordinates far from 1 are shown as well", async () => {
  const floats = (text) => new Float32Array(Uint8Array.from(Buffer.from(text, "base64")).buffer);
  const scaled = (text, by) => Buffer.from(floats(text).map((x) => x * by).buffer).toString("base64");
  for (const by of [1e-20, 1e20]) {
    const view = {
      ...data.view,
      surfaces: data.view.surfaces.map((s) => ({ ...s, positions: scaled(s.positions, by) })),
    };
    for (const { paths } of view.combinations.flatMap((c) => c?.sources ?? [])) paths.length = 0;
    const sources = data.sources.map((s) => ({ ...s, position: s.position.map((x) => x * by) }));
    await with_page({ ...data, sources, view }, async (page) => {
      await isolines(page, 0);
      assert.ok(share(await canvas(page), coloured) > 0.08, String(by));
    });
  }
});

test("a cortex of 20,000 vertices, 5 sources and 4 combinations opens in seconds", () => {
  const large = sample({ rings: 200, sides: 100, growth: false });
  const four = (list) => [0, 2, 3, 4].map((i) => list[i]);
  const twice_and_more = (list) => [0, 1, 0, 1, 0].map((i) => list[i]);
  const combinations = four(large.view.combinations).map((view) => ({
    ...view,
    sources: twice_and_more(view.sources),
  }));
  const data_of_20k = {
    ...large,
    sources: twice_and_more(large.sources),
    combinations: four(large.combinations),
    view: { ...large.view, combinations },
  };
  return with_page(data_of_20k, async (page) => {
    const { duration } = await page.evaluate(() => performance.getEntriesByType("navigation")[0].toJSON());
    assert.ok(duration < 10000, `${duration} ms`);
    await isolines(page, 0);
    assert.ok(share(await canvas(page), coloured) > 0.08);
  });
});
