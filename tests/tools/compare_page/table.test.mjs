// SPDX-License-Identifier: MIT
// The table of combinations: its numbers are those of the data, sorting sorts, failures and promises are told in words.
import assert from "node:assert/strict";
import { test } from "node:test";
import { with_page } from "./browser.mjs";
import { sample } from "./sample.mjs";

const data = { ...sample({ growth: false }), view: undefined };
const ran = data.combinations.filter(({ error }) => error === null);

const expected = {
  faces: (c) => c.surface.faces,
  stages: (c) => Object.values(c.seconds.stages).reduce((a, b) => a + b, 0),
  prepare: (c) => c.seconds.prepare,
  per_source: (c) => c.seconds.per_source,
  peak: (c) => (c.memory.peak_bytes === null ? null : c.memory.peak_bytes / 1e6),
  prepared: (c) => c.memory.prepared_bytes / 1e6,
  mean: (c) => c.errors.mean,
  q99: (c) => c.errors.quantiles["0.99"],
  max_over: (c) => c.errors.max_over,
  max_under: (c) => c.errors.max_under,
  near_mean: (c) => c.errors.near.mean,
  near_max: (c) => c.errors.near.max,
  far_mean: (c) => c.errors.far.mean,
  far_max: (c) => c.errors.far.max,
  unreachable: (c) => c.unreachable,
  reach_differs: (c) => c.reach_differs,
};

const row = (page, place) => page.locator(`tr[data-combination="${place}"]`);
const cell = (page, place, column) => row(page, place).locator(`[data-column=${column}]`);
const order = (page) =>
  page.locator("tr[data-combination]").evaluateAll((rows) => rows.map((r) => Number(r.dataset.combination)));

/** The number that a person reads. */
const read = (text) => Number(text.replaceAll(",", ""));

test("every number of the table is that of the data", () =>
  with_page(data, async (page) => {
    for (const [place, combination] of ran.entries())
      for (const [column, value_of] of Object.entries(expected)) {
        const [value, where] = [value_of(combination), `${column} of ${combination.name}`];
        const text = await cell(page, place, column).textContent();
        if (value === null) assert.equal(text, "–", where);
        else {
          assert.equal(Number(await cell(page, place, column).locator("data").getAttribute("value")), value, where);
          assert.ok(Math.abs(read(text) - value) <= 0.0051 * Math.abs(value), `${where}: ${text} for ${value}`);
        }
      }
    const numeric = await page
      .locator("thead th.number")
      .evaluateAll((heads) => heads.map((head) => head.dataset.column));
    assert.deepEqual(numeric, Object.keys(expected));
  }));

test("a click on the head of a column sorts by it, another one the other way round", () =>
  with_page(data, async (page) => {
    for (const [column, value_of] of Object.entries(expected)) {
      const head = page.locator(`th[data-column=${column}][scope=col]`);
      for (const [direction, sign] of [
        ["ascending", 1],
        ["descending", -1],
      ]) {
        await head.locator("button").click();
        assert.equal(await head.getAttribute("aria-sort"), direction);
        assert.equal(await page.locator("[aria-sort]").count(), 1);
        const places = await order(page);
        assert.deepEqual(
          [...places].sort((a, b) => a - b),
          data.combinations.map((_, i) => i),
          column,
        );
        assert.equal(places.at(-1), data.combinations.length - 1, "what did not run comes last");
        const values = places.slice(0, -1).map((place) => value_of(ran[place]));
        const known = values.filter((value) => value !== null);
        assert.deepEqual(values.slice(0, known.length), known, "what was not measured comes after the rest");
        for (let i = 1; i < known.length; ++i) assert.ok(sign * (known[i] - known[i - 1]) >= 0, `${column}: ${known}`);
      }
    }
  }));

test("names sort too, by the keyboard", () =>
  with_page(data, async (page) => {
    await page.locator("th[data-column=name][scope=col] button").focus();
    await page.keyboard.press("Enter");
    const names = (await order(page)).slice(0, -1).map((place) => ran[place].name);
    assert.deepEqual(
      names,
      ran.map(({ name }) => name).sort((a, b) => a.localeCompare(b)),
    );
  }));

test("details stay with their row when it is sorted elsewhere", () =>
  with_page(data, async (page) => {
    await row(page, 2).locator("button.toggle").click();
    await page.locator("th[data-column=mean] button").click();
    assert.equal(await row(page, 2).evaluate((r) => r.nextElementSibling.id), "details-2");
    assert.ok(await page.locator("#details-2").isVisible());
  }));

test("what a solver certifies is told in its details, of no other solver", () =>
  with_page(data, async (page) => {
    for (const [place, { certified }] of ran.entries()) {
      await row(page, place).locator("button.toggle").click();
      const text = await page.locator(`#details-${place}`).textContent();
      const said = /off by at most (\S+) of themselves, (\S+) in the mean/.exec(text);
      assert.equal(said !== null, certified !== undefined, ran[place].name);
      if (!said) continue;
      for (const [i, value] of [certified.largest, certified.mean].entries())
        assert.ok(Math.abs(read(said[i + 1]) - value) <= 0.0051 * value, `${said[i + 1]} for ${value}`);
    }
    assert.ok(ran.some(({ certified }) => certified));
  }));

test("what did not run shows its error and status", () =>
  with_page(data, async (page) => {
    const last = data.combinations.at(-1);
    const text = await row(page, data.combinations.length - 1).textContent();
    assert.ok(text.includes(last.name) && text.includes(last.error.text) && text.includes("status 4"), text);
  }));

test("promises are told in words", () =>
  with_page(data, async (page) => {
    const words = async (column) => Promise.all(ran.map((_, place) => cell(page, place, column).textContent()));
    assert.deepEqual(await words("guarantee"), [
      "exact: held",
      "exact: held",
      "≤ 1.1: held",
      "none stated",
      "none stated",
      "≤ 1.01: BROKEN",
    ]);
    assert.deepEqual(await words("invariants"), [
      "all hold",
      "all hold",
      "all hold",
      "all hold",
      "1 not promised",
      "1 BROKEN",
    ]);
  }));

test("a guarantee that the truth cannot judge is neither held nor broken", () => {
  const [first, ...rest] = data.combinations;
  const guarantee = { stated: 1, worst: null, held: null, why: "the truth is another surface" };
  return with_page({ ...data, combinations: [{ ...first, guarantee }, ...rest] }, async (page) => {
    assert.equal(await cell(page, 0, "guarantee").textContent(), "exact: not judged");
  });
});

test("details have stages, counters, quantiles, invariants and each source's seconds", () =>
  with_page(data, async (page) => {
    const toggle = row(page, 0).locator("button.toggle");
    assert.equal(await toggle.getAttribute("aria-expanded"), "false");
    await toggle.click();
    assert.equal(await toggle.getAttribute("aria-expanded"), "true");
    const rows = await page.locator("#details-0 tr").allTextContents();
    for (const text of [
      "reconstructordelaunay_cut0.250",
      "windows52,341",
      "propagated_faces9,177",
      "50 % are at most0",
      "99 % are at most0",
      "D >= Euclidholds0",
      "symmetryholds–",
      "row 06.56e-3",
      "5817.29e-3",
      "targets compared2,302",
    ])
      assert.ok(rows.includes(text), `${text} is not among:\n${rows.join("\n")}`);
    await toggle.click();
    assert.ok(await page.locator("#details-0").isHidden());
  }));
