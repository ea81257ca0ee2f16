// SPDX-License-Identifier: MIT
// A headless Chromium with one page of sample data: what all tests of the page share.
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import path from "node:path";
import { after } from "node:test";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { PNG } from "pngjs";
import { page_of } from "./sample.mjs";

const quiet = [
  "--no-sandbox",
  "--disable-gpu",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
];
const software_webgl = ["--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"];
const screenshot_warning = "GPU stall due to ReadPixels"; // Chromium's own, when a screenshot is taken without a GPU
const no_webgl = ["--disable-3d-apis"];

// One browser for each kind that a file of tests needs; every page has a context of its own.
const browsers = new Map();

function browser(webgl) {
  if (!browsers.has(webgl))
    browsers.set(
      webgl,
      chromium.launch({
        executablePath: process.env.GEODROME_CHROMIUM,
        args: [...quiet, ...(webgl ? software_webgl : no_webgl)],
      }),
    );
  return browsers.get(webgl);
}

after(async () => {
  for (const open of browsers.values()) await (await open).close();
});

/** Runs `work(folder)` in a folder that is removed afterwards. */
export async function in_folder(work) {
  const folder = await mkdtemp(path.join(tmpdir(), "geodrome_page_"));
  try {
    await work(folder);
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
}

/** Runs `test(page, log)` on a page with `data` (null: the empty template); `log` has all requests and errors. */
export async function with_page(data, test, options) {
  const template = await readFile(process.env.GEODROME_PAGE, "utf8");
  await in_folder(async (folder) => {
    const file = path.join(folder, "page.html");
    await writeFile(file, data === null ? template : page_of(template, data));
    await with_file(file, test, options);
  });
}

/** The same on a page that is there. */
export async function with_file(
  file,
  test,
  { viewport = { width: 1280, height: 800 }, dark = false, webgl = true } = {},
) {
  const context = await (await browser(webgl)).newContext({ viewport, colorScheme: dark ? "dark" : "light" });
  try {
    const page = await context.newPage();
    const log = listen(page);
    await page.goto(pathToFileURL(file).href);
    await page.waitForFunction(() => window.geodrome?.ready);
    await settled(page);
    await test(page, log);
  } finally {
    await context.close();
  }
}

function listen(page) {
  const log = { requests: [], errors: [] };
  page.on("request", (request) => log.requests.push(request.url()));
  page.on("pageerror", (error) => log.errors.push(String(error)));
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !message.text().includes(screenshot_warning))
      log.errors.push(message.text());
  });
  return log;
}

/** Waits until layout, plots and the 3D view have caught up. */
export async function settled(page) {
  let before = -1;
  for (;;) {
    const frames = await page.evaluate(
      () =>
        new Promise((done) =>
          requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(() => done(window.geodrome.frames), 30))),
        ),
    );
    if (frames === before) return;
    before = frames;
  }
}

/** What a person sees of an element, as pixels. */
export async function picture(locator) {
  const { width, height, data } = PNG.sync.read(await locator.screenshot());
  const at = (x, y) => [...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 3)];
  return { width, height, at };
}

/** The share of pixels for which `holds(colour, x, y)`. */
export function share({ width, height, at }, holds) {
  let count = 0;
  for (let y = 0; y < height; ++y) for (let x = 0; x < width; ++x) if (holds(at(x, y), x, y)) ++count;
  return count / (width * height);
}

/** The share of pixels in which two pictures of one size differ visibly. */
export function difference(a, b) {
  return share(a, (colour, x, y) => b.at(x, y).some((value, i) => Math.abs(value - colour[i]) > 12));
}

/** Chooses an entry of a menu of the page by its place. */
export async function choose(page, menu, place) {
  await page.locator(`select[name=${menu}]`).selectOption({ index: place });
  await settled(page);
}
