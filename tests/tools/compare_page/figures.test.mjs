// SPDX-License-Identifier: MIT
// How numbers are written, and what becomes of numbers that JSON does not have.
import assert from "node:assert/strict";
import { test } from "node:test";
import { with_page } from "./browser.mjs";
import { sample } from "./sample.mjs";

/** What the table shows for these values as mean errors, of combinations that are otherwise alike. */
async function shown(values) {
  const data = sample({ growth: false });
  const [first] = data.combinations;
  const combinations = values.map((mean, i) => ({ ...first, name: String(i), errors: { ...first.errors, mean } }));
  let texts;
  await with_page({ ...data, combinations, view: undefined }, async (page, log) => {
    texts = await page.locator("tbody [data-column=mean]").allTextContents();
    assert.deepEqual(log.errors, []);
  });
  return texts;
}

test("numbers are plain where that is short, else have exponents that are multiples of three", async () => {
  const cases = {
    0: "0",
    1: "1.00",
    0.2085: "0.208",
    0.01: "0.0100",
    0.009999: "0.0100",
    0.00729: "7.29e-3",
    0.000244: "244e-6",
    "1.655e-15": "1.66e-15",
    "9.999e-7": "1.00e-6",
    "-0.0447": "-0.0447",
    12.34: "12.3",
    999.9: "1,000",
    123456: "123,456",
    12345678: "12.3e6",
    "5e-324": "4.94e-324",
  };
  assert.deepEqual(
    await shown(Object.keys(cases).map(Number)),
    Object.keys(cases).map((key) => cases[key]),
  );
});

test("numbers that JSON does not have are told, and names that look like them stay names", async () => {
  assert.deepEqual(await shown(["inf", "-inf", "nan", null]), ["inf", "-inf", "nan", "–"]);
  const data = sample({ growth: false });
  const named = data.combinations.map((c, i) => (i === 0 ? { ...c, name: "inf" } : c));
  await with_page({ ...data, combinations: named }, async (page) => {
    assert.equal((await page.locator("tbody [data-column=name]").first().textContent()).trim(), "inf");
  });
});
