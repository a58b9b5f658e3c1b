// Puts workbench.html together: `node assemble.mjs FOLDER PAGE`. FOLDER has what wasm-bindgen wrote. It uses no package.
import { execFileSync } from "node:child_process";
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const here = dirname(fileURLToPath(import.meta.url));
const root = join(here, "../..");
const [folder, file] = process.argv.slice(2);
const page = (name) => readFileSync(join(here, "page", name), "utf8");
const { textOf } = new Function(`${page("digits.js")}\nreturn { textOf };`)();
const packed = (bytes) => textOf(gzipSync(bytes, { level: 9 }));
const wasm = join(folder, "workbench_bg.wasm");

const OWN = ["digits", "dom", "state", "client", "files", "axes", "editing", "pictures", "code", "messages", "work", "main"];
const SCRIPTS = ["vendor/uPlot.iife.min.js", ...OWN.map((name) => `${name}.js`)];

/** The packages that are in the WebAssembly, with their licences: those that it depends on for its target. */
function licences() {
  const options = ["metadata", "--format-version", "1", "--locked", "--filter-platform", "wasm32-unknown-unknown"];
  const metadata = JSON.parse(execFileSync("cargo", options, { cwd: root, maxBuffer: 1 << 30 }));
  const nodes = new Map(metadata.resolve.nodes.map((node) => [node.id, node]));
  const packages = new Map(metadata.packages.map((of) => [of.id, of]));
  const found = new Set();
  const visit = (id) => {
    const isMacro = packages.get(id).targets.some((target) => target.kind.includes("proc-macro"));
    if (found.has(id) || isMacro) return;
    found.add(id);
    for (const { pkg, dep_kinds } of nodes.get(id).deps) if (dep_kinds.some(({ kind }) => kind === null)) visit(pkg);
  };
  visit(metadata.packages.find((of) => of.name === "axgen-workbench").id);
  return [...found].map((id) => packages.get(id));
}

/** A licence text once, under the names of all parts that have it. */
function licenceTexts() {
  const texts = new Map();
  const add = (name, text) => texts.set(text, (texts.get(text) ?? new Set()).add(name));
  for (const of of licences()) {
    const at = dirname(of.manifest_path);
    const own = of.source ? at : root;
    const all = readdirSync(own)
      .filter((name) => /^(licen[cs]e|copying|notice|unlicense)/i.test(name))
      .sort();
    const names = all.some((name) => /mit/i.test(name)) ? all.filter((name) => /mit|notice/i.test(name)) : all;
    const name = of.source ? `${of.name} ${of.version}` : "axgen";
    if (!names.length) add(name, `${of.license}, ${of.authors.join(", ")}; the package has no text of its own`);
    for (const text of names) add(name, readFileSync(join(own, text), "utf8"));
  }
  add("uPlot 1.6.32", page("vendor/LICENSE-uPlot"));
  // Its own text is that of serde's, which names nobody.
  const serde = licences().find((of) => of.name === "serde");
  add("The Rust standard library", readFileSync(join(dirname(serde.manifest_path), "LICENSE-MIT"), "utf8"));
  return [...texts].map(([text, names]) => [[...names].join(", "), text]);
}

const version = /^version = "(.*)"/m.exec(readFileSync(join(root, "Cargo.toml"), "utf8"))[1];
const texts = { version, example: readFileSync(join(root, "examples/rack-and-pinion.lis"), "utf8"), licences: licenceTexts() };
const parts = {
  STYLE: page("vendor/uPlot.min.css") + page("style.css"),
  WORKER: readFileSync(join(folder, "workbench.js"), "utf8") + page("worker.js"),
  // The page as it is released has been compressed already.
  WASM: existsSync(`${wasm}.gz`) ? textOf(readFileSync(`${wasm}.gz`)) : packed(readFileSync(wasm)),
  TEXTS: packed(Buffer.from(JSON.stringify(texts))),
  SCRIPT: SCRIPTS.map(page).join("\n"),
};
for (const [name, text] of Object.entries(parts)) {
  if (/<\/(script|style)/i.test(text)) throw new Error(`${name} would end its element`);
}
const html = page("page.html").replace(/\/\*([A-Z]+)\*\//g, (_, name) => parts[name]);
writeFileSync(file, html);
console.log(`${file}: ${html.length} bytes, of these WebAssembly ${parts.WASM.length}`);
