// The tools of the page in a browser: what they show is what the command prints for the same files. And how a worker ends.
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import {
  axgen,
  drop,
  equal,
  example,
  expect,
  isChromium,
  isReleased,
  open,
  openExample,
  root,
  settled,
  text,
} from "./browser.mjs";

/** A folder with files, and the command in it. */
function commandWith(files) {
  const folder = mkdtempSync(join(tmpdir(), "workbench-"));
  const put = (name, text) => writeFileSync(join(folder, name), text);
  const read = (name) => readFileSync(join(folder, name), "utf8");
  for (const [name, text] of Object.entries(files)) put(name, text);
  const run = (line) => spawnSync(axgen, line.split(" "), { cwd: folder, encoding: "utf8" }).stdout;
  return { run, put, read, end: () => rmSync(folder, { recursive: true }) };
}

/** Uses a tool; returns the texts that it shows. */
async function use(tab, id) {
  await tab.evaluate((id) => {
    document.getElementById(id).open = true;
    document.querySelector(`#${id} > button`).click();
  }, id);
  const isDone = (id) =>
    client.waiting.size === 0 && !["", "working"].includes(document.getElementById(`${id}-result`).textContent);
  await tab.waitForFunction(isDone, { timeout: 200000 }, id);
  return tab.evaluate((id) => {
    const result = document.getElementById(`${id}-result`);
    return {
      texts: [...result.querySelectorAll("pre")].map((pre) => pre.textContent),
      pictures: result.querySelectorAll("img").length,
    };
  }, id);
}

/** A value of a stage through its field, as the last thing typed. */
async function type(tab, id, value) {
  await tab.evaluate(
    (id, value) => {
      delete times.lines;
      const field = document.getElementById(id);
      field.value = value;
      field.onchange();
    },
    id,
    value,
  );
  await settled(tab);
}

/** Simulation, commissioning page and differences of a list. */
async function ofList() {
  const command = commandWith({ "rack-and-pinion.lis": example });
  const tab = await openExample();
  const simulated = await use(tab, "simulate-part");
  equal("simulate", simulated.texts[0], command.run("simulate rack-and-pinion.lis --cycle-time 1ms"));
  expect("the simulation has a picture", simulated.pictures === 1);
  command.run("generate rack-and-pinion.lis --cycle-time 1ms --target twincat --out .");
  equal("page", (await use(tab, "page-part")).texts[0], command.read("axis_rack_and_pinion_commissioning.md"));
  await type(tab, "q_factor0", "9");
  command.put("new.lis", await tab.evaluate(() => document.getElementById("text").value));
  const changes = command
    .run("diff rack-and-pinion.lis new.lis --cycle-time 1ms")
    .replaceAll("axis new:", "axis rack_and_pinion:");
  equal("diff", `${(await use(tab, "diff-part")).texts[0]}\n`, changes);
  expect("a change is found", changes.includes("quality factor 10 -> 9"));
  await tab.close();
  command.end();
}

/** A parameter set, and differences, against an older version among the files. */
async function ofVersions() {
  const old = readFileSync(join(root, "generator/cli/tests/params_of.toml"), "utf8");
  const files = { "old.toml": old, "new.toml": old.replace("q_factor = 10.0", "q_factor = 9.0") };
  const command = commandWith(files);
  const tab = await open();
  await drop(tab, Object.entries(files).reverse());
  await tab.evaluate(() => {
    delete times.all;
    const role = document.querySelector('[aria-label="Use of old.toml"]');
    role.value = "older";
    role.onchange();
  });
  await settled(tab);
  expect("the newer version is chosen", (await text(tab, "state")).startsWith("new.toml"));
  for (const form of ["st", "csv"]) {
    await tab.evaluate((form) => (document.getElementById("form").value = form), form);
    const written = command.run(`params-of new.toml --on old.toml --as ${form} --out -`);
    equal(`params-of as ${form}`, (await use(tab, "params-part")).texts[0], written);
  }
  equal("diff of two sets", `${(await use(tab, "diff-part")).texts[0]}\n`, command.run("diff old.toml new.toml"));
  await tab.close();
  command.end();
}

/** Recordings of the demonstration plant: what is measured, and proposed; a proposal in the user's text. */
async function ofRecordings() {
  const walk = /```toml\n(.*?)```/s.exec(readFileSync(join(root, "docs/walk.md"), "utf8"))[1];
  const command = commandWith({ "walk.toml": walk });
  command.run("simulate walk.toml --plant demonstration --moves moves.csv --excited excited.csv --speed 20mm/s --noise 0.1%");
  const tab = await open();
  await drop(
    tab,
    ["walk.toml", "moves.csv", "excited.csv"].map((name) => [name, command.read(name)]),
  );
  const measured = await use(tab, "measure-part");
  equal("measure", measured.texts[0], command.run("measure moves.csv --excited excited.csv"));
  expect("what is measured has a picture", measured.pictures === 1);
  const tuned = await use(tab, "tune-part");
  equal("tune", tuned.texts[0], command.run("tune walk.toml --recording moves.csv --excited excited.csv"));
  expect("the proposals have a picture", tuned.pictures === 1);
  await tab.evaluate(() => {
    delete times.all;
    document.querySelector('[aria-label="Apply recommended"]').click();
  });
  await settled(tab);
  command.run("tune walk.toml --recording moves.csv --excited excited.csv --apply recommended");
  equal("apply", await tab.evaluate(() => document.getElementById("text").value), command.read("walk.toml"));
  await tab.close();
  command.end();
}

/** The user ends what takes long, and goes on; a panic shows its message, and a new worker goes on, too. */
async function ends() {
  const tab = await openExample();
  const ended = await tab.evaluate(async () => {
    const long = ask({ command: "verify", samples: 5000000 }).then(
      () => "done",
      (error) => error.message,
    );
    await new Promise((done) => setTimeout(done, 300));
    document.getElementById("stop").click();
    return long;
  });
  expect(`the button ends it: ${ended}`, ended === "stopped by the user");
  expect("a new worker goes on", await goesOn(tab));
  // More samples than a memory can hold: nothing that the page asks for.
  const panic = await tab.evaluate(() =>
    ask({ command: "verify", samples: 4294967295 }).then(
      () => "done",
      (error) => error.message,
    ),
  );
  expect(
    `a panic has a message with its place: ${panic}`,
    /^axgen failed: panicked at .*:\d+:\s+capacity overflow/s.test(panic),
  );
  expect("a new worker goes on after a panic", await goesOn(tab));
  await tab.close();
}

const goesOn = (tab) => tab.evaluate(() => ask({ command: "check", of: subject() }).then(({ data }) => data.allowed));

export async function tools() {
  await ofList();
  await ofVersions();
  // What is computed depends on no browser, as the files that both compare show.
  if (isChromium || isReleased) await ofRecordings();
  await ends();
}
