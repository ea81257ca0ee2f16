// SPDX-License-Identifier: MIT
// The page as a whole: nothing from outside, no errors, inert strings, light and dark, wide and narrow.
import assert from "node:assert/strict";
import { test } from "node:test";
import { choose, picture, settled, share, with_page } from "./browser.mjs";
import { sample } from "./sample.mjs";

const headings = [
  "Combinations",
  "Error against time",
  "Relative errors, share of targets",
  "Growth with the number of faces",
  "The surface",
];

async function use_everything(page) {
  await page.locator("button.toggle").first().click();
  await page.locator("th[data-column=mean] button").click();
  for (const menu of ["error", "time", "field", "range", "source", "beside"]) await choose(page, menu, 1);
  await page.locator("canvas").first().click();
  await settled(page);
}

test("the page asks nothing of any network and reports no errors, whatever is used", () =>
  with_page(sample(), async (page, log) => {
    await use_everything(page);
    assert.deepEqual(await page.locator("h2").allTextContents(), headings);
    assert.equal(log.requests.length, 1, log.requests.join("\n"));
    assert.match(log.requests[0], /^file:/);
    assert.deepEqual(log.errors, []);
  }));

test("the policy of the page lets no script run but its own", () =>
  with_page(sample(), async (page) => {
    const ran = await page.evaluate(async () => {
      const refused = new Promise((done) => {
        document.addEventListener("securitypolicyviolation", ({ effectiveDirective }) => done(effectiveDirective), {
          once: true,
        });
        setTimeout(() => done("nothing"), 3000);
      });
      const script = document.createElement("script");
      script.textContent = "window.hacked = 1";
      document.body.append(script);
      return [await refused, window.hacked ?? null];
    });
    assert.deepEqual(ran, ["script-src-elem", null]);
  }));

test("strings that look like markup are shown as they are", () =>
  with_page(sample({ hostile: true }), async (page, log) => {
    await use_everything(page);
    await choose(page, "combination", 6);
    assert.equal(await page.evaluate(() => window.hacked ?? null), null);
    assert.equal(await page.locator("img, b").count(), 0);
    assert.match(
      await page.locator("h1").textContent(),
      /^<\/script><img src=x onerror="window\.hacked=1"><b>bold<\/b>\.ply$/,
    );
    assert.match(await page.locator("#surface figcaption").first().textContent(), /^<\/script><img/);
    assert.match(await page.locator(".failed").textContent(), /use delaunay_cut<\/script>/);
    assert.deepEqual(log.errors, []);
  }));

test("the head names input, truth, sources and version", () =>
  with_page(sample(), async (page) => {
    const head = await page.locator("header").textContent();
    for (const text of [
      "torus.ply",
      "1,260 vertices",
      "2,496 faces",
      "Exact distances of chen_han",
      "row 0",
      "581",
      "0.1.0",
      "7, of which 1 did not run",
    ])
      assert.ok(head.includes(text), `${text} is not in: ${head}`);
  }));

test("dark follows the reader's choice", async () => {
  const brightness = async (dark) => {
    let bright;
    await with_page(
      sample(),
      async (page) => {
        bright = share(await picture(page.locator("body")), (colour) => colour.every((c) => c > 200));
      },
      { dark },
    );
    return bright;
  };
  assert.ok((await brightness(false)) > 0.7);
  assert.ok((await brightness(true)) < 0.1);
});

for (const width of [1280, 700, 360])
  test(`nothing makes the body scroll sideways at a width of ${width}`, () =>
    with_page(
      sample({ hostile: true }),
      async (page) => {
        await use_everything(page);
        const [content, window_width] = await page.evaluate(() => [
          document.documentElement.scrollWidth,
          window.innerWidth,
        ]);
        assert.equal(window_width, width);
        assert.ok(content <= width, `${content} pixels wide`);
      },
      { viewport: { width, height: 800 } },
    ));

test("the table of a mesh fits at a width of 1280", () =>
  with_page(sample(), async (page) => {
    const [content, room] = await page
      .locator("#combinations .scroll")
      .evaluate((box) => [box.scrollWidth, box.clientWidth]);
    assert.ok(content <= room, `${content} pixels in ${room}`);
  }));

test("sections without data are left out or say so", () =>
  with_page({ ...sample({ growth: false }), view: undefined }, async (page, log) => {
    assert.deepEqual(
      await page.locator("h2").allTextContents(),
      headings.filter((h) => !h.startsWith("Growth")),
    );
    assert.match(await page.locator("#surface").textContent(), /no surface to show/);
    assert.deepEqual(log.errors, []);
  }));

test("the page is complete when every combination failed", () => {
  const data = sample();
  const failure = data.combinations.at(-1);
  return with_page(
    { ...data, combinations: [failure], view: { surfaces: [], combinations: [null] } },
    async (page, log) => {
      assert.match(await page.locator(".failed").textContent(), /did not run \(status 4\): the stars of 17 points/);
      assert.deepEqual(log.errors, []);
    },
  );
});

test("the empty template says what it is", () =>
  with_page(null, async (page, log) => {
    assert.match(await page.locator("main").textContent(), /shows no comparison: it is the empty template/);
    assert.deepEqual(log.errors, []);
  }));

test("a combination that has nothing to compare has no errors, which is not the same as errors of 0", () => {
  const data = sample();
  const [first, ...rest] = data.combinations;
  const none = { compared: 0, mean: null, max: null };
  const { decades, counts } = first.errors.histogram;
  const errors = {
    ...none,
    max_over: null,
    max_under: null,
    quantiles: {},
    near: none,
    far: none,
    histogram: { decades, counts: counts.map(() => 0), zero: 0 },
  };
  return with_page({ ...data, combinations: [{ ...first, errors }, ...rest] }, async (page, log) => {
    for (const column of ["mean", "max_over", "max_under", "near_max"])
      assert.equal(await page.locator(`tbody [data-column=${column}]`).first().textContent(), "–");
    for (const place of [0, 1, 2, 3, 4]) {
      await choose(page, "error", place);
      assert.equal(await page.locator("#error-time .combination-mark").count(), rest.length - 1);
    }
    assert.deepEqual(log.errors, []);
  });
});

test("data of another schema is refused by name", () =>
  with_page({ ...sample(), schema: "geodrome-comparison/9" }, async (page) => {
    assert.match(
      await page.locator("main").textContent(),
      /the data is "geodrome-comparison\/9", this page shows "geodrome-comparison\/1"/,
    );
  }));

test("the notices of all that is bundled are in the page", () =>
  with_page(sample(), async (page) => {
    const notices = await page.locator("footer pre").textContent();
    for (const name of ["three", "@observablehq/plot", "d3-scale-chromatic", "d3-array"])
      assert.match(notices, new RegExp(`^${name} \\d.*\\((MIT|ISC)\\)$`, "m"));
    assert.match(notices, /Copyright © 2010-2\d+ three\.js authors/);
  }));

test("keys reach the table, its heads, the menus and the canvas", () =>
  with_page(sample(), async (page) => {
    const reached = new Set();
    for (let i = 0; i < 80; ++i) {
      await page.keyboard.press("Tab");
      reached.add(
        await page.evaluate(() => {
          const e = document.activeElement;
          return e.name || e.className || e.closest("[data-column]")?.dataset.column || e.localName;
        }),
      );
    }
    for (const what of ["scroll", "mean", "toggle", "combination", "isolines", "canvas"])
      assert.ok(reached.has(what), `${what} not in ${[...reached]}`);
  }));
