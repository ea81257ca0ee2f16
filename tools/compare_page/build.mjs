// SPDX-License-Identifier: MIT
// Bundles the page into one file: node build.mjs OUTPUT. The modules of the packages lie beside this file (npm ci).
import { build } from "esbuild";
import { createHash } from "node:crypto";
import { mkdir, readFile, readdir, writeFile } from "node:fs/promises";
import path from "node:path";

const marker = "<!--geodrome-comparison-->";
const allowed = /^(MIT|ISC|0BSD|BSD-[23]-Clause|Apache-2\.0|Unlicense)$/;

process.chdir(path.dirname(new URL(import.meta.url).pathname));

async function bundle() {
  const result = await build({
    entryPoints: ["src/main.ts"],
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2022",
    charset: "utf8",
    legalComments: "inline",
    metafile: true,
    write: false,
    logLevel: "warning",
  });
  return { script: result.outputFiles[0].text.trim(), inputs: Object.keys(result.metafile.inputs) };
}

/** The folders of the packages that the bundle has parts of. */
function packages(inputs) {
  const folders = inputs.map((file) => file.match(/^.*node_modules\/(?:@[^/]+\/)?[^/]+/)?.[0]);
  return [...new Set(folders.filter(Boolean))].sort();
}

/** Name, version, licence and notice of a package; an error where the page may not contain it. */
async function notice(folder) {
  const { name, version, license } = JSON.parse(await readFile(path.join(folder, "package.json"), "utf8"));
  if (!allowed.test(license)) throw new Error(`${name} has the licence ${license}, which the page cannot contain`);
  const file = (await readdir(folder)).find((entry) => /^licen[cs]e/i.test(entry));
  if (!file) throw new Error(`${name} has no licence file whose notice the page could keep`);
  return `${name} ${version} (${license})\n\n${(await readFile(path.join(folder, file), "utf8")).trim()}`;
}

const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");

function fill(template, parts) {
  return template.replace(/\{\{([a-z-]+)\}\}/g, (_, name) => parts[name]);
}

const output = process.argv[2];
if (!output) throw new Error("usage: node build.mjs OUTPUT");
const { script, inputs } = await bundle();
const notices = await Promise.all(packages(inputs).map(notice));
const page = fill(await readFile("page.html", "utf8"), {
  script,
  "script-hash": `sha256-${createHash("sha256").update(script).digest("base64")}`,
  style: await readFile("style.css", "utf8"),
  licences: escaped(notices.join(`\n\n${"-".repeat(72)}\n\n`)),
});
if (page.split(marker).length !== 2) throw new Error(`the page must hold ${marker} exactly once`);
await mkdir(path.dirname(output), { recursive: true });
await writeFile(output, page);
console.log(`${output}: ${Math.round(page.length / 1000)} kB, ${notices.length} packages`);
