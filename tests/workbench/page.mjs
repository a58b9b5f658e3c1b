// The page in a browser, from file://, as a person uses it: `node page.mjs PAGE released|quick chromium|firefox AXGEN [FOLDER]`.
// FOLDER: screenshots go there.
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import * as browser from "./browser.mjs";
import { allow, drop, example, expect, isChromium, open, openExample, settled, shot, text, within } from "./browser.mjs";
import { ARCHIVE, Comparison, filesBeside, subjectOf, subjects } from "./sets.mjs";
import { several } from "./several.mjs";
import { tools } from "./tools.mjs";

async function steps() {
  const tab = await open();
  within("wasm ready", await tab.evaluate(() => times.ready), 500);
  await drop(tab, [["rack-and-pinion.lis", example]], "1ms");
  within("first picture", await tab.evaluate(() => times["first picture"]), 500);
  expect("the state names the file", (await text(tab, "state")).includes("rack-and-pinion.lis: 0 errors"));
  expect("the stages have verdicts", (await text(tab, "verdict0")).includes("stays calm"));
  const pictures = await tab.evaluate(() => [
    document.querySelectorAll("#pictures canvas").length,
    document.querySelector("#nyquist img").naturalWidth > 0,
  ]);
  expect("there are four pictures and the Nyquist curve", pictures[0] === 4 && pictures[1]);
  await shot(tab, "workbench");
  await slider(tab);
  await marked(tab);

  await tab.evaluate(() => document.getElementById("verify").click());
  await tab.waitForFunction(() => document.getElementById("state").textContent.startsWith("verified"), { timeout: 90000 });
  expect("no bit differs", (await text(tab, "state")).includes(" 0 differing bits"));
  await settled(tab);
  return tab;
}

/** A step of a slider by the keyboard changes the text of the user, the pictures and the marked lines. */
async function slider(tab) {
  await tab.focus("#range-f00");
  for (const [step, key] of [
    ["the first slider step", "ArrowRight"],
    ["slider step", "ArrowRight"],
  ]) {
    await tab.evaluate(() => delete times.lines);
    await tab.keyboard.press(key);
    await settled(tab);
    within(step, await tab.evaluate(() => times["slider step"]), 50);
  }
  expect("the lines of the value are marked", await tab.evaluate(() => document.querySelectorAll("#code .touched").length > 0));
  const list = await tab.evaluate(() => document.getElementById("text").value);
  const was = example.split("\n");
  expect("one line of the list has changed", list.split("\n").filter((line, n) => line !== was[n]).length === 1);
  const labels = await tab.evaluate(() => plots.get("gain").plot.series.map((series) => series.label));
  const before = labels.filter((label) => label.startsWith("before"));
  expect(`the curves before are there once: ${labels}`, before.length > 0 && labels.length === 2 * before.length + 1);
  await shot(tab, "workbench-changed");
}

async function marked(tab) {
  await tab.focus("#code");
  await tab.keyboard.press("ArrowDown");
  await tab.keyboard.press("Enter");
  expect("a line names its parameter", /\w+ -> \w+/.test(await text(tab, "named")));
  await tab.evaluate(() => {
    delete times.lines;
    document.getElementById("undo-f00").click();
  });
  await tab.waitForFunction((example) => document.getElementById("text").value === example, { timeout: 20000 }, example);
  await settled(tab);
}

/** A mistake in the list has a message that leads to its place; markup stays text. */
async function messages() {
  const tab = await open();
  const markup = '<img src=x onerror="window.acted=1">';
  const list = `${example.replace("q_factor   10", "q_factor   -1")}\n${markup} 5\n`;
  await drop(tab, [[`${markup}.lis`, list]], "1ms");
  expect("the mistake has a message", (await text(tab, "messages")).includes("error"));
  await tab.evaluate(() => document.querySelector("#messages button").click());
  const place = await tab.evaluate(() => [document.activeElement.id, document.activeElement.selectionStart]);
  expect("the place is selected", place[0] === "text" && place[1] > 0);
  const acted = await tab.evaluate(() => window.acted || document.querySelectorAll("img[src=x]").length > 0);
  expect("markup stays text", !acted);
  await tab.close();
}

/** A set with errors is shown as far as it can be read. */
async function partly() {
  const tab = await open();
  const bad = example.replace("q_factor   10", "q_factor   -1");
  const set = `cycle_time = "1ms"\n[axis.BAD]\nlist = "bad.lis"\n[axis.GOOD]\nlist = "good.lis"\n`;
  await drop(tab, [
    ["set.toml", set],
    ["bad.lis", bad],
    ["good.lis", example],
  ]);
  const rows = await tab.evaluate(() => [...document.querySelectorAll("#axes tbody tr")].map((row) => row.innerText));
  expect(`the good axis has a verdict: ${rows}`, rows.length === 2 && /GOOD.*calm/s.test(rows[0]));
  expect(`the other one has an error with its message: ${rows}`, /BAD.*-1.*error/s.test(rows[1] ?? ""));
  expect("the loop of the good axis is shown", await tab.evaluate(() => plots.size === 4));
  expect("no block is generated", (await text(tab, "named")).startsWith("No block is generated"));
  const disabled = await tab.evaluate(() => [
    document.getElementById("save").disabled,
    document.getElementById("verify").disabled,
  ]);
  expect("nothing is saved or verified", disabled[0] && disabled[1]);
  await tab.close();
}

/** Nothing leaves: a request of any kind is refused before it reaches a server. */
async function refusesRequests(tab) {
  allow("127.0.0.1");
  let reached = 0;
  const server = createServer((_, response) => {
    reached += 1;
    response.writeHead(200, { "access-control-allow-origin": "*" }).end("x");
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const url = `http://127.0.0.1:${server.address().port}/`;
  const refused = await tab
    .evaluate(async (url) => {
      const fetched = await fetch(url).then(
        () => "open",
        () => "refused",
      );
      const image = new Image();
      const loaded = await new Promise((done) => {
        image.onload = () => done("open");
        image.onerror = () => done("refused");
        image.src = url;
      });
      return [fetched, loaded];
    }, url)
    .catch(() => ["refused", "refused"]);
  server.close();
  expect(
    `requests are refused: ${refused}, ${reached} reached a server`,
    reached === 0 && refused.every((is) => is === "refused"),
  );
}

/** The keyboard alone reaches every control. */
async function keyboard(tab) {
  const count = await tab.evaluate(() => {
    window.reached = new Set();
    document.addEventListener("focusin", (event) => window.reached.add(event.target));
    document.getElementById("open").focus();
    const all = "button:not(:disabled), select, input, textarea, summary, [tabindex='0']";
    window.wanted = [...document.querySelectorAll(all)].filter((of) => of.checkVisibility());
    return window.wanted.length;
  });
  for (let n = 0; n < count + 20; n += 1) await tab.keyboard.press("Tab");
  const left = await tab.evaluate(() => {
    const missed = window.wanted.filter((of) => !window.reached.has(of));
    return missed.map((of) => of.id || of.textContent.slice(0, 40));
  });
  expect(`the keyboard does not reach ${left}`, count > 20 && left.length === 0);
}

/** axe-core finds nothing serious. */
async function accessible(tab, what) {
  await tab.evaluate(readFileSync(new URL("node_modules/axe-core/axe.min.js", import.meta.url), "utf8"));
  const found = await tab.evaluate(async () => {
    const { violations } = await axe.run();
    const serious = violations.filter((of) => ["serious", "critical"].includes(of.impact));
    return serious.map(
      (of) =>
        `${of.id}: ${of.nodes
          .slice(0, 3)
          .map((node) => node.html)
          .join(" ")}`,
    );
  });
  for (const of of found) expect(`axe, ${what}: ${of}`, false);
}

/** 300 axes: the table, and all files for two and for six targets; a tenth of them in a page for tests. */
async function many() {
  const count = browser.isReleased ? 300 : 30;
  const tab = await open();
  const axes = Array.from({ length: count }, (_, n) => `[axis.A${n}]\nlist = "x.lis"\nkopf.achs_nr = ${n + 1}\n`);
  await drop(tab, [
    ["set.toml", `cycle_time = "1ms"\n${axes.join("")}`],
    ["x.lis", example],
  ]);
  const rows = await tab.evaluate(() => document.querySelectorAll("#axes tbody tr").length);
  expect(`${rows} rows for ${count} axes`, rows === count);
  within(`table of ${count} axes`, await tab.evaluate(() => times.table), 1000);
  for (const [targets, limit] of [
    [["c", "st"], 3000],
    [["c", "rust", "st", "twincat", "codesys", "scl"], 5000],
  ]) {
    const [entries, time] = await tab.evaluate(async (targets) => {
      const from = performance.now();
      const { data } = await ask({ command: "zip", of: subject(), targets, name: "all.zip" });
      return [data.entries.length, performance.now() - from];
    }, targets);
    expect(`${entries} files for ${count} axes`, entries > count * targets.length);
    within(`${count} axes for ${targets.length} targets`, time, limit);
  }
  await tab.close();
}

/** Every file that this browser generates has the bytes of the command's file: all sets for a released page. */
async function sameBytes() {
  const tab = await open();
  const compared = new Comparison(browser.axgen);
  for (const path of subjects(browser.isReleased ? 1 : 24)) {
    // Recordings are large, and no block depends on them.
    const files = [...filesBeside(path, 1 << 18)].map(([name, bytes]) => [name, bytes.toString("base64")]);
    const zip = await tab.evaluate(
      async (files, request) => {
        const bytesOf = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
        // A worker of its own, without the files of the set before.
        client.worker.terminate();
        await client.start();
        const of = files.map(([name, text]) => [name, bytesOf(text)]);
        await client.ask({ command: "check", of: request.of }, of);
        const { data, files: made } = await client.ask(request);
        if (!data) return null;
        const letters = Array.from(made[0][1], (byte) => String.fromCharCode(byte));
        return btoa(letters.join(""));
      },
      files,
      { command: "zip", of: subjectOf(path), ...ARCHIVE },
    );
    compared.add(path, zip && Buffer.from(zip, "base64"));
  }
  console.log(`  ${browser.name}: same bytes: ${compared}`);
  for (const mistake of compared.mistakes.slice(0, 30)) expect(`other bytes: ${mistake}`, false);
  expect(`${compared.files} files are compared`, compared.files > 50);
  await tab.close();
}

async function narrow() {
  const tab = await openExample({ width: 390 });
  const width = await tab.evaluate(() => document.scrollingElement.scrollWidth);
  expect(`390 px: the page is ${width} px wide`, width <= 390);
  await accessible(tab, "390 px");
  await shot(tab, "workbench-narrow");
  await tab.close();
}

async function dark() {
  const tab = await openExample({ isDark: true });
  await accessible(tab, "dark");
  await shot(tab, "workbench-dark");
  await tab.close();
}

try {
  const tab = await steps();
  const isDark = await tab.evaluate(() => matchMedia("(prefers-color-scheme: dark)").matches);
  expect("Chromium begins light, Firefox dark", isDark === !isChromium);
  await keyboard(tab);
  await accessible(tab, "the example");
  await refusesRequests(tab);
  await tab.close();
  await messages();
  await partly();
  await narrow();
  await tools();
  // What belongs to which is decided by the page, not by the browser.
  if (isChromium || browser.isReleased) await several();
  await many();
  await sameBytes();
  if (isChromium) await dark();
} catch (error) {
  expect(error.stack, false);
} finally {
  await browser.end();
}
