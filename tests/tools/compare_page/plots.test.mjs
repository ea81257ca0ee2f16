// SPDX-License-Identifier: MIT
// The plots: as many marks as there is data, at places that follow from it.
import assert from "node:assert/strict";
import { test } from "node:test";
import { choose, settled, with_page } from "./browser.mjs";
import { sample } from "./sample.mjs";

const data = { ...sample(), view: undefined };
const ran = data.combinations.filter(({ error }) => error === null);

/** Name, centre and label of each mark of the plot of errors. */
const marks = (page) =>
  page.locator("#error-time .combination-mark").evaluateAll((nodes) =>
    nodes.map((node) => {
      const mark = node.querySelector("[aria-label]") ?? node;
      const box = mark.getBoundingClientRect();
      return { label: mark.getAttribute("aria-label"), x: box.x + box.width / 2, y: box.y + box.height / 2 };
    }),
  );

test("the plot of errors has a mark and a label for each combination that ran, in the order of its figures", () =>
  with_page(data, async (page) => {
    const found = await marks(page);
    assert.equal(found.length, ran.length);
    assert.deepEqual(
      (await page.locator("#error-time .labels text").allTextContents()).sort(),
      ran.map(({ name }) => name).sort(),
    );
    for (const [i, a] of ran.entries())
      for (const [j, b] of ran.entries()) {
        if (a.seconds.per_source < b.seconds.per_source)
          assert.ok(found[i].x < found[j].x, `${a.name} is left of ${b.name}`);
        if (a.errors.mean < 0.5 * b.errors.mean) assert.ok(found[i].y > found[j].y, `${a.name} is below ${b.name}`);
      }
  }));

test("both axes of the plot of errors are logarithmic", () =>
  with_page(data, async (page) => {
    const found = await marks(page);
    const positive = ran
      .map((c, i) => ({ x: Math.log(c.seconds.per_source), y: Math.log(c.errors.mean), at: found[i] }))
      .filter(({ y }) => Number.isFinite(y));
    for (const axis of ["x", "y"]) {
      const [a, b, c] = [...positive]
        .sort((p, q) => p[axis] - q[axis])
        .filter((_, i, all) => [0, 1, all.length - 1].includes(i));
      const share = (b[axis] - a[axis]) / (c[axis] - a[axis]);
      const drawn = (b.at[axis] - a.at[axis]) / (c.at[axis] - a.at[axis]);
      assert.ok(Math.abs(share - drawn) < 0.02, `${axis}: ${share} is drawn at ${drawn}`);
    }
  }));

test("errors of zero lie on a floor that is marked as 0", () =>
  with_page(data, async (page) => {
    const floor = await page.locator("#error-time .floor, #error-time [class*=floor] line").first().boundingBox();
    const zero = (await marks(page))[0];
    assert.ok(Math.abs(zero.y - floor.y - floor.height / 2) < 3, `${zero.y} on ${floor.y}`);
    assert.ok((await page.locator("#error-time svg text").allTextContents()).includes("0"));
    assert.match(zero.label, /^delaunay_cut, chen_han: 7\.29e-3 s, error 0$/);
  }));

test("other errors and times move the marks", () =>
  with_page(data, async (page) => {
    const before = await marks(page);
    await choose(page, "error", 2);
    const largest = await marks(page);
    assert.ok(before.some((mark, i) => Math.abs(mark.y - largest[i].y) > 3));
    assert.match(largest[5].label, /error 0\.0400$/);
    await choose(page, "time", 2);
    assert.match((await marks(page))[5].label, /^advancing_front, boastful: 0\.431 s/);
  }));

test("a histogram has a bar for each count and one for zeros, in proportion", () =>
  with_page(data, async (page) => {
    const drawn = page.locator("#histograms .histogram");
    assert.equal(await drawn.count(), ran.length);
    let unit = null;
    for (const [i, { errors, name }] of ran.entries()) {
      const { counts, zero } = errors.histogram;
      const all = counts.reduce((sum, n) => sum + n, zero);
      assert.equal(all, errors.compared, "the sample is sound");
      const shares = [zero, ...counts].filter((n) => n > 0).map((n) => n / all);
      const heights = await drawn
        .nth(i)
        .locator(".bars rect")
        .evaluateAll((bars) => bars.map((bar) => Number(bar.getAttribute("height"))));
      assert.equal(heights.length, shares.length, name);
      unit ??= heights[0] / shares[0];
      heights.forEach((height, k) =>
        assert.ok(Math.abs(height - unit * shares[k]) < 0.51, `${name}: bar ${k} is ${height} high`),
      );
    }
  }));

test("growth has a curve for each combination with figures, a point for each size, and the fitted exponents", () =>
  with_page(data, async (page) => {
    const plots = page.locator("#growth figure");
    const titles = await plots.locator("figcaption").allTextContents();
    assert.deepEqual(titles, [
      "seconds per source",
      "seconds to prepare",
      "peak memory, MB",
      "windows",
      "propagated_faces",
      "nodes",
      "pops",
    ]);
    const curves = async (title) => plots.nth(titles.indexOf(title)).locator(".curve path").count();
    assert.equal(await curves("seconds per source"), ran.length);
    assert.equal(await curves("peak memory, MB"), ran.length - 1);
    assert.equal(await curves("windows"), 2);
    const points = await plots.first().locator("g[aria-label=dot] > *").count();
    assert.equal(points, 3 * ran.length);
    const exponents = await page
      .locator(".exponents tbody tr")
      .evaluateAll((rows) => rows.map((row) => row.children[1].textContent));
    assert.deepEqual(exponents, ["1.50", "1.70", "1.10", "1.02", "1.15", "1.30"]);
  }));

test("one size alone has no exponent", () => {
  const alone = data.combinations.map((c) => (c.error ? c : { ...c, growth: c.growth.slice(-1) }));
  return with_page({ ...data, combinations: alone }, async (page) => {
    assert.equal(await page.locator(".exponents tbody tr").first().locator("td").first().textContent(), "–");
  });
});

test("plots fill their room when it changes", () =>
  with_page(data, async (page) => {
    const width = () =>
      page
        .locator("#error-time svg")
        .last()
        .evaluate((svg) => svg.getBoundingClientRect().width);
    const wide = await width();
    await page.setViewportSize({ width: 600, height: 800 });
    await settled(page);
    assert.ok(wide > 1200 && wide <= 1240, String(wide));
    assert.ok((await width()) <= 580, String(await width()));
  }));
