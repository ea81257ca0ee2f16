// SPDX-License-Identifier: MIT
// node run.mjs PAGE PROGRAM TEST: one file of tests on a built page, and on those that the program `geodrome` writes.
// Chromium is the one in GEODROME_CHROMIUM, or on the PATH.
import { spawnSync } from "node:child_process";
import { existsSync } from "node:fs";
import path from "node:path";

const [page, program, test] = process.argv.slice(2);

function chromium() {
  if (process.env.GEODROME_CHROMIUM) return process.env.GEODROME_CHROMIUM;
  const folders = process.env.PATH.split(path.delimiter);
  return ["chromium", "chromium-browser", "google-chrome"]
    .flatMap((name) => folders.map((folder) => path.join(folder, name)))
    .find(existsSync);
}

const browser = chromium();
if (!browser) {
  console.log("skipped: no Chromium on the PATH or in GEODROME_CHROMIUM (Debian: chromium)");
  process.exit(0);
}
if (!existsSync(page)) throw new Error(`${page} is not there: build the target compare_page`);
const env = { ...process.env, GEODROME_PAGE: page, GEODROME_PROGRAM: program, GEODROME_CHROMIUM: browser };
const { status } = spawnSync(process.execPath, ["--test", test], { env, stdio: "inherit" });
process.exit(status ?? 1);
