// Sets and lists of the repository, and how the page's archive of one differs from the files of the command.
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, dirname, join, relative } from "node:path";
import { unzipped } from "./library.mjs";

const root = process.env.WORKBENCH_ROOT;
const TARGETS = ["c", "rust", "st", "twincat", "codesys", "scl"];
/** What the page is asked for. */
export const ARCHIVE = { targets: TARGETS, name: "all.zip" };
export const subjectOf = (path) => ({ set: basename(path), cycle_time: "1ms" });

function* filesBelow(folder) {
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) yield* filesBelow(path);
    else yield path;
  }
}

/** Of the sets and lists of the repository one of `every`. */
export function subjects(every) {
  const all = ["golden/cases", "examples", "tests", "generator/tests"].flatMap((folder) => [
    ...filesBelow(join(root, folder)),
  ]);
  const isSet = (path) => path.endsWith(".toml") && /^\s*\[axis\./m.test(readFileSync(path, "utf8"));
  const found = all.filter((path) => !path.includes("node_modules") && (isSet(path) || path.endsWith(".lis"))).sort();
  return found.filter((_, n) => n % every === 0);
}

/** The files that a set may name: those next to it, with names relative to it. `most`: bytes of a file. */
export function* filesBeside(path, most = 1 << 24) {
  const at = dirname(path);
  for (const file of filesBelow(at)) {
    if (statSync(file).size < most) yield [relative(at, file), readFileSync(file)];
  }
}

/** The files of the command, or null if it refuses the set. */
function ofCommand(axgen, path) {
  const folder = mkdtempSync(join(tmpdir(), "workbench-"));
  const options = path.endsWith(".lis") ? ["--cycle-time", "1ms"] : [];
  const targets = TARGETS.flatMap((name) => ["--target", name]);
  const done = spawnSync(axgen, ["generate", path, "--out", folder, ...options, ...targets]);
  if (![0, 2].includes(done.status)) throw new Error(`${path}: ${done.stderr}`);
  const files = [...filesBelow(folder)].filter((file) => basename(file) !== ".axgen.lock");
  const found = done.status === 2 ? null : new Map(files.map((file) => [relative(folder, file), readFileSync(file)]));
  rmSync(folder, { recursive: true });
  return found;
}

/** Compares archives of the page with what the command writes. */
export class Comparison {
  sets = 0;
  refused = 0;
  files = 0;
  mistakes = [];

  constructor(axgen) {
    this.axgen = axgen;
  }

  /** `zip`: the bytes of the page's archive, or null if it refuses the set. */
  add(path, zip) {
    const all = zip && [...unzipped(zip)].filter(([name]) => name.startsWith("generated/"));
    const found = all && new Map(all.map(([name, bytes]) => [name.slice("generated/".length), bytes]));
    const expected = ofCommand(this.axgen, path);
    this.sets += 1;
    this.refused += expected === null;
    if ((expected === null) !== (found === null)) this.mistakes.push(`${path}: refused by one only`);
    for (const name of new Set([...(expected?.keys() ?? []), ...(found?.keys() ?? [])])) {
      this.files += 1;
      if (!expected?.get(name)?.equals(found?.get(name) ?? Buffer.alloc(0))) this.mistakes.push(`${path}: ${name}`);
    }
  }

  toString() {
    return `${this.sets} sets, ${this.refused} of them refused by both, ${this.files} files, ${this.mistakes.length} differ`;
  }
}
