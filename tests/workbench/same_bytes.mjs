// Every file that the page generates has the bytes of the command's file: `node same_bytes.mjs PAGE released|quick AXGEN`.
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, dirname, join, relative } from "node:path";
import { loader, unzipped } from "./library.mjs";

const [page, kind, axgen] = process.argv.slice(2);
/** Of how many sets one is compared. */
const EVERY = kind === "released" ? 1 : 8;
const root = process.env.WORKBENCH_ROOT;
const TARGETS = ["c", "rust", "st", "twincat", "codesys", "scl"];
const begin = loader(page);

function* filesBelow(folder) {
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) yield* filesBelow(path);
    else yield path;
  }
}

/** Sets and lists of the repository. */
function subjects() {
  const all = ["golden/cases", "examples", "tests", "generator/tests", "generator/unit"].flatMap((folder) => [
    ...filesBelow(join(root, folder)),
  ]);
  const isSet = (path) => path.endsWith(".toml") && /^\s*\[axis\./m.test(readFileSync(path, "utf8"));
  return all.filter((path) => !path.includes("node_modules") && (isSet(path) || path.endsWith(".lis"))).sort();
}

/** The files of the command, or null if it refuses the set. */
function ofCommand(path, folder) {
  const options = path.endsWith(".lis") ? ["--cycle-time", "1ms"] : [];
  const done = spawnSync(axgen, [
    "generate",
    path,
    "--out",
    folder,
    ...options,
    ...TARGETS.flatMap((name) => ["--target", name]),
  ]);
  if (done.status === 2) return null;
  if (done.status !== 0) throw new Error(`${path}: ${done.stderr}`);
  return new Map(
    [...filesBelow(folder)]
      .filter((file) => basename(file) !== ".axgen.lock")
      .map((file) => [relative(folder, file), readFileSync(file)]),
  );
}

/** The same of the page. */
function ofPage(path) {
  const own = begin();
  const at = dirname(path);
  for (const file of filesBelow(at)) {
    if (statSync(file).size < 1 << 24) own.put(relative(at, file), readFileSync(file));
  }
  const of = { set: basename(path), cycle_time: "1ms" };
  own.ask({ command: "check", of });
  const { data } = own.ask({ command: "zip", of, targets: TARGETS, name: "all.zip" });
  if (!data) return null;
  const all = [...unzipped(own.get("all.zip"))].filter(([name]) => name.startsWith("generated/"));
  return new Map(all.map(([name, bytes]) => [name.slice("generated/".length), bytes]));
}

let [sets, refused, files] = [0, 0, 0];
const mistakes = [];
for (const [n, path] of subjects().entries()) {
  if (n % EVERY) continue;
  const folder = mkdtempSync(join(tmpdir(), "workbench-"));
  const [expected, found] = [ofCommand(path, folder), ofPage(path)];
  rmSync(folder, { recursive: true });
  sets += 1;
  refused += expected === null;
  const names = new Set([...(expected?.keys() ?? []), ...(found?.keys() ?? [])]);
  if ((expected === null) !== (found === null)) mistakes.push(`${path}: refused by one only`);
  for (const name of names) {
    files += 1;
    if (!expected?.get(name)?.equals(found?.get(name) ?? Buffer.alloc(0))) mistakes.push(`${path}: ${name}`);
  }
}
console.log(`same bytes: ${sets} sets, ${refused} of them refused by both, ${files} files, ${mistakes.length} differ`);
if (mistakes.length || files < 100) {
  console.error(mistakes.slice(0, 30).join("\n"));
  process.exit(1);
}
