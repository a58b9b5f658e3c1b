// Several axes, sets and files on one page: what belongs to which, and what a change leaves. And what users type.
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { axgen, drop, example, expect, open, openExample, root, settled, text } from "./browser.mjs";
import { unzipped } from "./library.mjs";

const walk = /```toml\n(.*?)```/s.exec(readFileSync(join(root, "docs/walk.md"), "utf8"))[1];
const other = example.replace(/fg_f0(\s+)53/, "fg_f0$177");
const set = (x, y) =>
  `cycle_time = "1ms"\n[axis.X]\nkopf.achs_nr = 1\nlist = "${x}"\n[axis.Y]\nkopf.achs_nr = 2\nlist = "${y}"\n`;
const two = [
  ["set.toml", set("x.lis", "y.lis")],
  ["x.lis", example],
  ["y.lis", other],
];
const OUTDATED = "have changed since";

/** Runs the command in a folder of its own with these files: exit code and standard error, and what it wrote. */
function commandWith(files, lines, read = []) {
  const folder = mkdtempSync(join(tmpdir(), "workbench-"));
  for (const [name, content] of files) writeFileSync(join(folder, name), content);
  const done = lines.map((line) => spawnSync(axgen, line.split(" "), { cwd: folder, encoding: "utf8" }));
  const found = read.map((name) => [name, readFileSync(join(folder, name))]);
  rmSync(folder, { recursive: true });
  return { done, found };
}

/** A list that starts ON, and is refused without the response of a slow drive: 1.5 cycles and a time constant of 3 ms. */
const limit = example
  .replace(/fg_f0(\s+)53/, "fg_f0$1300")
  .replace(/stage\[0\].weight_fact_num(\s+)300/, "stage[0].weight_fact_num$1700")
  .replace(/stage\[1\].weight_fact_num(\s+)190/, "stage[1].weight_fact_num$110");
const slow = ["# averages: 20", "f [Hz];re;im;coherence"];
for (let n = 1; n < 1000; n += 1) {
  const [w, gain] = [Math.PI * n, 1 / Math.hypot(1, Math.PI * n * 0.003)];
  const phase = -w * 0.0015 - Math.atan(w * 0.003);
  slow.push(`${n / 2};${(gain * Math.cos(phase)).toFixed(9)};${(gain * Math.sin(phase)).toFixed(9)};0.9999`);
}

const quiet = (tab) =>
  tab.waitForFunction(() => client.waiting.size === 0 && !editing.running && timers.size === 0, { timeout: 200000 });
const look = (tab, id) => tab.evaluate((id) => document.getElementById(id).value, id);
const roles = (tab) => tab.evaluate(() => [...state.files].map(([name, file]) => `${name}:${file.role}`).join(" "));

/** Clicks the first element that a selector and a text find. */
async function click(tab, selector, words = "") {
  const isThere = await tab.evaluate(
    (selector, words) => {
      const found = [...document.querySelectorAll(selector)].find((of) => of.textContent.startsWith(words));
      found?.click();
      return Boolean(found);
    },
    selector,
    words,
  );
  await new Promise((done) => setTimeout(done, 50));
  await quiet(tab);
  return isThere;
}

const axis = (tab, name) => click(tab, "#axes button", name);
async function run(tab, id) {
  await click(tab, `#${id} > button`);
  return text(tab, `${id}-result`);
}

/** Types into a field as a person does. */
async function type(tab, id, keys) {
  await tab.focus(`#${id}`);
  await tab.evaluate((id) => document.getElementById(id).select(), id);
  await tab.keyboard.press("Backspace");
  await tab.keyboard.type(keys);
  await tab.keyboard.press("Enter");
  await new Promise((done) => setTimeout(done, 50));
  await quiet(tab);
  return look(tab, id);
}

/** The files that the page saves. */
async function saved(tab) {
  await tab.evaluate(() => {
    window.saved = null;
    download = (_, bytes) => {
      window.saved = Array.from(bytes);
    };
  });
  await click(tab, "#save");
  const bytes = await tab.evaluate(() => window.saved);
  return bytes && unzipped(Buffer.from(bytes));
}

/** Results, proposals and their buttons belong to an axis of a set; a change takes them away. */
async function results(recordings) {
  const tab = await open();
  const y = walk.slice(walk.indexOf("[axis.X]")).replaceAll("axis.X", "axis.Y").replace("achs_nr = 1", "achs_nr = 2");
  await drop(tab, [["walk.toml", `${walk}\n${y}`], ...recordings]);
  expect("there are proposals", (await run(tab, "tune-part")).includes("recommended"));
  await tab.evaluate(async () => {
    client.fail("stopped by the user");
    await client.ready;
  });
  await click(tab, '[aria-label="Apply recommended"]');
  expect(`a new worker has no proposals: ${await text(tab, "state")}`, (await text(tab, "state")).includes("not applied"));
  await run(tab, "tune-part");
  await axis(tab, "Y");
  expect("no proposal of another axis is offered", !(await click(tab, '[aria-label="Apply recommended"]')));
  const refused = await tab.evaluate(async () => {
    const { data, messages } = await ask({ command: "apply", of: subject(), axis: "Y", proposal: "recommended" });
    return data ? "written" : messages[0].found;
  });
  expect(`nor written: ${refused}`, refused.includes("were made for the axis X"));
  await axis(tab, "X");
  await tab.evaluate(() => applied("recommended"));
  await quiet(tab);
  const f0 = Number(await look(tab, "f00"));
  await tab.focus("#range-f00");
  await tab.keyboard.press("ArrowRight");
  await quiet(tab);
  const moved = Number(await look(tab, "f00"));
  expect(`the slider of a new stage moves from ${f0} to ${moved}`, f0 > 0 && moved > f0 && moved < 1.02 * f0);
  expect(`and is answered: ${await text(tab, "state")}`, (await text(tab, "state")).startsWith("walk.toml: 0 errors"));
  await tab.close();
}

/** What is shown of a tool goes with an edit and with another axis. */
async function outdated() {
  const tab = await open();
  await drop(tab, two);
  for (const id of ["page-part", "verify-part", "params-part"]) await run(tab, id);
  await axis(tab, "Y");
  expect("the page of X is not shown for Y", (await text(tab, "page-part-result")).includes(OUTDATED));
  expect("the parameters of X are not shown for Y", (await text(tab, "params-part-result")).includes(OUTDATED));
  expect("a verification is of all axes", !(await text(tab, "verify-part-result")).includes(OUTDATED));
  await type(tab, "f00", "60");
  expect("a verification of other numbers is not shown", (await text(tab, "verify-part-result")).includes(OUTDATED));
  const changes = await run(tab, "diff-part");
  expect(`a part is compared as it was opened: ${changes}`, changes.includes("77 -> 60"));
  await drop(tab, [["b.csv", "time [s];v_motor [um/s]\n0;1\n0.001;2\n"]]);
  const kept = await tab.evaluate(() => [state.axis, $("f00").value, $("was-f00").textContent, $("undo-f00").hidden]);
  expect(`a recording keeps the axis and Undo: ${kept}`, kept.join() === "Y,60,in the file: 77,false");
  await drop(tab, [["new.toml", set("y.lis", "x.lis")]]);
  const recording = "time [s];v_motor [um/s]\n0;1\n0.001;2\n";
  await drop(tab, [["c.csv", recording], ["d.csv", recording]]);
  expect("recordings keep the chosen set", (await look(tab, "set")) === "new.toml");
  await click(tab, '[aria-label="Remove y.lis"]');
  expect("a removed list is gone", (await text(tab, "axes")).includes("no such file"));
  await tab.close();
}

/** Two files of one name, and two paths to one file. */
async function sameName() {
  const tab = await open();
  const files = [["set.toml", set("x/axis.lis", "y/axis.lis")], ["axis.lis", example], ["axis.lis", other]];
  await drop(tab, files);
  expect("the second file of a name is reported", (await text(tab, "state")).includes("a second file with the name axis.lis"));
  expect("one file is not both", /Y.*takes it for x\/axis.lis/s.test(await text(tab, "axes")));
  await tab.close();
}

/** A response belongs to an axis; the blocks are those of the set alone, as the command makes them. */
async function responses(recordings, response) {
  const tab = await open();
  const lists = [two[0], two[1], ["y.lis", limit]];
  await drop(tab, [...lists, ...recordings.toReversed(), ["response.csv", response]]);
  const found = await roles(tab);
  for (const use of ["excited.csv:excited", "moves.csv:recording", "response.csv:response"])
    expect(`${use}: ${found}`, found.includes(use));
  expect("each use is shown", (await text(tab, "state")).includes("response.csv: response of the drive of the axis X"));
  expect("the response counts for its axis", (await text(tab, "headlines")).includes("the drive of response.csv"));
  await axis(tab, "Y");
  expect("and for no other", !(await text(tab, "headlines")).includes("response.csv"));
  expect("it lifts no refusal of another axis", await tab.evaluate(() => $("save").disabled));
  await click(tab, '[aria-label="Remove response.csv"]');
  await drop(tab, [["again.csv", slow.join("\n")]]);
  expect("nor of its own: the set does not contain it", await tab.evaluate(() => $("save").disabled));
  expect("the reason is said", (await text(tab, "messages")).includes("refused without the dropped response"));
  await tab.close();

  const own = await open();
  await drop(own, [["x.lis", example], ["response.csv", response]]);
  await drop(own, [["one.toml", 'cycle_time = "1ms"\n[axis.X]\nkopf.achs_nr = 1\nlist = "x.lis"\n']]);
  await own.evaluate(() => {
    $("target").value = "c";
    use("response.csv", "response");
    return refresh();
  });
  await quiet(own);
  expect("the own response is used", (await text(own, "headlines")).includes("the drive of response.csv"));
  const zip = await saved(own);
  const made = [...zip].filter(([name]) => name.startsWith("generated/"));
  const files = [...zip].filter(([name]) => !name.startsWith("generated/"));
  expect("it is said that it is not in the set", (await text(own, "state")).includes("not in the set"));
  const command = commandWith(files, ["generate one.toml --target c --out generated"], made.map(([name]) => name));
  expect(`${made.length} files are made`, made.length > 4);
  made.forEach(([name, bytes], n) => expect(`${name} has the bytes of the command`, bytes.equals(command.found[n][1])));
  await own.close();
}

/** What is typed: numbers with a comma, nothing, what is out of range; text that is not read yet; ends of lines. */
async function typing() {
  const tab = await open();
  const crlf = example.replaceAll("\n", "\r\n");
  await drop(tab, [["rack-and-pinion.lis", crlf], ["note.lis", example]], "1ms");
  await tab.evaluate(() => {
    $("set").value = "rack-and-pinion.lis";
    return $("set").onchange();
  });
  await quiet(tab);
  for (const [id, keys, shown] of [
    ["weight0", "1,5", "1.5"],
    ["f00", "0", "53"],
    ["f00", "", "53"],
    ["f00", "x", "53"],
    ["damping1", "2", "0.8"],
  ]) {
    const is = await type(tab, id, keys);
    expect(`${id}: '${keys}' gives ${is}`, is === shown);
    const state = await text(tab, "state");
    expect(`${id}: '${keys}': ${state}`, !state.includes("panicked"));
  }
  await tab.evaluate(() => {
    const field = $("text");
    field.focus();
    const at = field.value.indexOf("53", field.value.indexOf("fg_f0"));
    field.setSelectionRange(at, at + 2);
  });
  await tab.keyboard.type("60");
  const list = (await saved(tab)).get("rack-and-pinion.lis").toString();
  expect("what is typed is saved", /fg_f0 +60/.test(list));
  expect("the ends of lines stay", list.split("\r\n").length === crlf.split("\r\n").length && !/[^\r]\n/.test(list));
  await click(tab, '[aria-label="Remove note.lis"]');
  expect("a removed file is not saved", !(await saved(tab)).has("note.lis"));
  const failed = await tab.evaluate(async () => {
    await opened([{ name: "folder", arrayBuffer: () => Promise.reject(new Error("a folder")) }]);
    return $("state").textContent;
  });
  expect(`a folder is refused: ${failed}`, failed.includes("folder cannot be read"));
  await tab.close();
}

/** A parameter set without an older file is for the block of the set as it was opened. */
async function older() {
  const old = readFileSync(join(root, "generator/cli/tests/params_of.toml"), "utf8");
  const tab = await open();
  await drop(tab, [["set.toml", old]]);
  await tab.evaluate((text) => {
    $("text").value = text;
    $("text").oninput();
  }, old.replace("v_add_max_fact = 500", "v_add_max_fact = 900"));
  const shown = await run(tab, "params-part");
  expect(`a larger limit needs a new block: ${shown.slice(0, 80)}`, shown.includes("needs a new block"));
  await tab.close();
}

export async function several() {
  const names = ["moves.csv", "excited.csv", "response.csv"];
  const simulate = "simulate walk.toml --plant demonstration --moves moves.csv --excited excited.csv --speed 20mm/s --noise 0.1%";
  const measure = "measure moves.csv --excited excited.csv --response response.csv";
  const { done, found } = commandWith([["walk.toml", walk]], [simulate, measure], names);
  expect(`the recordings are there: ${done.map((of) => of.stderr)}`, done.every((of) => of.status !== null));
  const [moves, excited, response] = found.map(([name, bytes]) => [name, bytes.toString()]);
  await typing();
  await outdated();
  await sameName();
  await older();
  await responses([moves, excited], response[1]);
  await results([moves, excited]);
}
