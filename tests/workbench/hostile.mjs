// Hostile and broken files: each gets an answer within 10 s of this processor and no panic: `node hostile.mjs PAGE
// released|quick`.
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { loader } from "./library.mjs";

const [page, kind] = process.argv.slice(2);
const begin = loader(page);
const root = process.env.WORKBENCH_ROOT;
const LONGEST = 10000;
/** A page for tests gets a part of a large file: more than a message for each line needs. */
const PART = kind === "released" ? 1 : 0.05;

const encoded = (text) => new TextEncoder().encode(text);
const times = (text, count) => encoded(text.repeat(count * PART));
const files = new Map([
  ["nothing.lis", encoded("")],
  ["zeros.lis", new Uint8Array(1 << 20)],
  ["lines.lis", times("kopf.achs_nr 1\n", 1400000)],
  ["unknown.lis", times("lr_param.improved_position_control.stage[9].mode X\n", 400000)],
  ["quotes.toml", times('"', 200000)],
  ["brackets.toml", encoded(`[axis.X]\na = ${"[".repeat(100000)}`)],
  ["tables.toml", encoded("[axis.X]\n".repeat(50000))],
  ["markup.lis", encoded('<img src=x onerror="document.title=1"> 5\n')],
  ["elements.xti", encoded("<a>".repeat(100000))],
  ["half.toml", new Uint8Array([0xff, 0xfe, 0x61])],
  ["long.lis", encoded(`kopf.achs_nr ${"9".repeat(5000000 * PART)}\n`)],
]);
// The texts of the readers' own tests, as they are: lists, sets and their mistakes.
for (const folder of ["generator/tests/config/messages", "generator/tests/real_files/listings", "generator/tests/real_files"]) {
  for (const entry of readdirSync(join(root, folder), { withFileTypes: true })) {
    if (!entry.isFile()) continue;
    const bytes = readFileSync(join(root, folder, entry.name));
    for (const extension of ["lis", "toml", "xti"]) files.set(`${entry.name}.${extension}`, bytes);
  }
}

let [longest, slowest] = [0, ""];
const mistakes = [];
for (const [name, bytes] of files) {
  for (const command of ["check", "measure", "kinds"]) {
    const own = begin();
    const from = process.cpuUsage();
    try {
      own.put(name, bytes);
      const { data, messages } = own.ask({ command, of: { set: name, cycle_time: "1ms" }, recording: name, names: [name] });
      if (!messages.length && !data) mistakes.push(`${command} ${name}: neither data nor a message`);
    } catch (error) {
      mistakes.push(`${command} ${name}: ${own.panicked() || error}`);
    }
    const time = process.cpuUsage(from).user / 1000;
    if (time > LONGEST) mistakes.push(`${command} ${name}: ${time.toFixed(0)} ms`);
    if (time > longest) [longest, slowest] = [time, `${command} ${name}`];
  }
}
console.log(`hostile: ${files.size} files, the slowest ${slowest}: ${longest.toFixed(0)} ms, ${mistakes.length} mistakes`);
if (mistakes.length) {
  console.error(mistakes.slice(0, 30).join("\n"));
  process.exit(1);
}
