// The page in a browser, from file://, as a person uses it: `node page.mjs PAGE chromium|firefox LOOSE
// [FOLDER]`. LOOSE: by how much limits of times are looser than those that are wanted; FOLDER: screenshots go there.
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import puppeteer from "puppeteer-core";

const [page, name, loose, pictures] = process.argv.slice(2);
const root = process.env.WORKBENCH_ROOT;
const isChromium = name === "chromium";
const example = readFileSync(join(root, "examples/rack-and-pinion.lis"), "utf8");

const mistakes = [];
/** From then on the browser reports refused connections, which are wanted. */
let isRefusing = false;
function expect(what, is) {
  if (!is) mistakes.push(what);
}
function within(what, milliseconds, limit) {
  console.log(`  ${name}: ${what} ${milliseconds.toFixed(0)} ms (${limit} ms)`);
  expect(`${what}: ${milliseconds.toFixed(0)} ms, more than ${loose} times ${limit} ms`, milliseconds <= Number(loose) * limit);
}

const chromium = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
const browser = await puppeteer.launch(isChromium
  ? { executablePath: "/usr/bin/chromium", browser: "chrome", headless: true, args: chromium, protocolTimeout: 120000 }
  : { executablePath: "/usr/bin/firefox-esr", browser: "firefox", headless: true, protocolTimeout: 120000 });

async function open(width = 1500) {
  const tab = await browser.newPage();
  await tab.setViewport({ width, height: 950 });
  const report = (words) => expect(`console: ${words}`, isRefusing && words.includes("127.0.0.1"));
  tab.on("console", (message) => ["error", "warn"].includes(message.type()) && report(message.text()));
  tab.on("pageerror", (error) => report(error.message));
  await tab.goto(pathToFileURL(page).href);
  await tab.waitForFunction(() => document.getElementById("state").textContent.startsWith("Ready"));
  return tab;
}

/** Drops files on the page. */
const drop = (tab, files) => tab.evaluate((all) => {
  const transfer = new DataTransfer();
  for (const [name, text] of all) transfer.items.add(new File([text], name));
  document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
}, files);

const text = (tab, id) => tab.evaluate((id) => document.getElementById(id).textContent, id);
const settled = (tab) => tab.waitForFunction(() => client.waiting.size === 0 && !editing.running && "all" in times && "lines" in times, { timeout: 60000 });
const shot = (tab, what) => pictures && tab.screenshot({ path: join(pictures, `${what}.png`) });

async function steps() {
  const tab = await open();
  within("wasm ready", await tab.evaluate(() => times.ready), 500);
  await tab.evaluate(() => { document.getElementById("cycle").value = "1ms"; });
  await drop(tab, [["rack-and-pinion.lis", example]]);
  await settled(tab);
  within("first picture", await tab.evaluate(() => times["first picture"]), 500);
  expect("the state names the file", (await text(tab, "state")).includes("rack-and-pinion.lis: 0 errors"));
  expect("the stages have verdicts", (await text(tab, "verdict0")).includes("stays calm"));
  expect("there are four pictures and the Nyquist curve", await tab.evaluate(() => document.querySelectorAll("#pictures canvas").length === 4 && document.querySelector("#nyquist img").naturalWidth > 0));
  await shot(tab, "workbench");

  // A step of a slider by the keyboard changes the text of the user, the pictures and the marked lines.
  await tab.focus("#range-f00");
  await tab.evaluate(() => delete times.lines);
  await tab.keyboard.press("ArrowRight");
  await settled(tab);
  expect("the lines of the value are marked", await tab.evaluate(() => document.querySelectorAll("#code .touched").length > 0));
  within("slider step", await tab.evaluate(() => times["slider step"]), 50);
  const list = await tab.evaluate(() => document.getElementById("text").value);
  expect("one line of the list has changed", list.split("\n").filter((line, n) => line !== example.split("\n")[n]).length === 1);
  expect("the picture before is grey", await tab.evaluate(() => plots.get("gain").plot.series.some((series) => series.label.startsWith("before"))));
  await shot(tab, "workbench-changed");
  await tab.focus("#code");
  await tab.keyboard.press("ArrowDown");
  await tab.keyboard.press("Enter");
  expect("a line names its parameter", /\w+ -> \w+/.test(await text(tab, "named")));
  await tab.evaluate(() => {
    delete times.lines;
    document.getElementById("undo-f00").click();
  });
  await tab.waitForFunction((example) => document.getElementById("text").value === example, { timeout: 20000 }, example);

  await tab.evaluate(() => document.getElementById("verify").click());
  await tab.waitForFunction(() => document.getElementById("state").textContent.startsWith("verified"), { timeout: 90000 });
  expect("no bit differs", (await text(tab, "state")).includes(" 0 differing bits"));
  await settled(tab);
  return tab;
}

/** A mistake in the list has a message that leads to its place; markup stays text. */
async function messages() {
  const tab = await open();
  await tab.evaluate(() => { document.getElementById("cycle").value = "1ms"; });
  const markup = '<img src=x onerror="window.acted=1">';
  await drop(tab, [[`${markup}.lis`, `${example.replace("q_factor   10", "q_factor   -1")}\n${markup} 5\n`]]);
  await settled(tab);
  expect("the mistake has a message", (await text(tab, "messages")).includes("error"));
  await tab.evaluate(() => document.querySelector("#messages button").click());
  expect("the place is selected", await tab.evaluate(() => document.activeElement.id === "text" && document.activeElement.selectionStart > 0));
  expect("markup stays text", await tab.evaluate(() => !window.acted && document.querySelectorAll("img[src=x]").length === 0));
  await tab.close();
}

/** Nothing leaves: a request of any kind is refused before it reaches a server. */
async function refusesRequests(tab) {
  let reached = 0;
  const server = createServer((_, response) => {
    reached += 1;
    response.writeHead(200, { "access-control-allow-origin": "*" }).end("x");
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const url = `http://127.0.0.1:${server.address().port}/`;
  const refused = await tab.evaluate(async (url) => {
    const fetched = await fetch(url).then(() => "open", () => "refused");
    const image = new Image();
    const loaded = await new Promise((done) => { image.onload = () => done("open"); image.onerror = () => done("refused"); image.src = url; });
    return [fetched, loaded];
  }, url).catch(() => ["refused", "refused"]);
  server.close();
  expect(`requests are refused: ${refused}, ${reached} reached a server`, reached === 0 && refused.every((is) => is === "refused"));
}

/** The keyboard alone reaches every control. */
async function keyboard(tab) {
  await tab.evaluate(() => {
    window.reached = new Set();
    document.addEventListener("focusin", (event) => window.reached.add(event.target));
    document.getElementById("open").focus();
  });
  const count = await tab.evaluate(() => {
    const all = "button:not(:disabled), select, input, textarea, summary, [tabindex='0']";
    window.wanted = [...document.querySelectorAll(all)].filter((of) => of.checkVisibility());
    return window.wanted.length;
  });
  for (let n = 0; n < count + 20; n += 1) await tab.keyboard.press("Tab");
  const left = await tab.evaluate(() => window.wanted.filter((of) => !window.reached.has(of)).map((of) => of.id || of.textContent.slice(0, 40)));
  expect(`the keyboard does not reach ${left}`, count > 20 && left.length === 0);
}

/** axe-core finds nothing serious. */
async function accessible(tab, what) {
  await tab.evaluate(readFileSync(new URL("node_modules/axe-core/axe.min.js", import.meta.url), "utf8"));
  const found = await tab.evaluate(async () => {
    const { violations } = await axe.run();
    return violations.filter((of) => ["serious", "critical"].includes(of.impact)).map((of) => `${of.id}: ${of.nodes.slice(0, 3).map((node) => node.html).join(" ")}`);
  });
  for (const of of found) expect(`axe, ${what}: ${of}`, false);
}

/** 300 axes: the table, and all files for two and for six targets. */
async function many() {
  const tab = await open();
  const set = `cycle_time = "1ms"\n${Array.from({ length: 300 }, (_, n) => `[axis.A${n}]\nlist = "x.lis"\nkopf.achs_nr = ${n + 1}\n`).join("")}`;
  await drop(tab, [["set.toml", set], ["x.lis", example]]);
  await settled(tab);
  within("table of 300 axes", await tab.evaluate(() => times.table), 1000);
  for (const [targets, limit] of [[["c", "st"], 3000], [["c", "rust", "st", "twincat", "codesys", "scl"], 5000]]) {
    const time = await tab.evaluate(async (targets) => {
      const from = performance.now();
      const { data } = await ask({ command: "zip", of: subject(), targets, name: "all.zip" });
      return data.entries.length > 300 ? performance.now() - from : Infinity;
    }, targets);
    within(`300 axes for ${targets.length} targets`, time, limit);
  }
  await tab.close();
}

/** The user ends what takes long, and goes on. */
async function stops() {
  const tab = await open();
  await tab.evaluate(() => { document.getElementById("cycle").value = "1ms"; document.getElementById("example").click(); });
  await settled(tab);
  const ended = await tab.evaluate(async () => {
    const long = ask({ command: "verify", samples: 5000000 }).then(() => "done", (error) => error.message);
    await new Promise((done) => setTimeout(done, 300));
    document.getElementById("stop").click();
    return long;
  });
  expect(`the button ends it: ${ended}`, ended === "stopped by the user");
  const goesOn = await tab.evaluate(() => ask({ command: "check", of: subject() }).then(({ data }) => data.allowed));
  expect("a new worker goes on", goesOn);
  await tab.close();
}

async function narrow() {
  const tab = await open(390);
  await tab.evaluate(() => { document.getElementById("cycle").value = "1ms"; document.getElementById("example").click(); });
  await settled(tab);
  const width = await tab.evaluate(() => document.scrollingElement.scrollWidth);
  expect(`390 px: the page is ${width} px wide`, width <= 390);
  if (isChromium) await accessible(tab, "390 px");
  await shot(tab, "workbench-narrow");
  await tab.close();
}

async function dark() {
  const tab = await browser.newPage();
  await tab.emulateMediaFeatures([{ name: "prefers-color-scheme", value: "dark" }]);
  await tab.setViewport({ width: 1500, height: 950 });
  await tab.goto(pathToFileURL(page).href);
  await tab.waitForFunction(() => document.getElementById("state").textContent.startsWith("Ready"));
  await tab.evaluate(() => { document.getElementById("cycle").value = "1ms"; document.getElementById("example").click(); });
  await settled(tab);
  await accessible(tab, "dark");
  await shot(tab, "workbench-dark");
  await tab.close();
}

try {
  const tab = await steps();
  await keyboard(tab);
  await accessible(tab, "light");
  isRefusing = true;
  await refusesRequests(tab);
  await tab.close();
  await messages();
  await narrow();
  await stops();
  await many();
  if (isChromium) await dark();
} catch (error) {
  expect(error.stack, false);
} finally {
  await browser.close();
}
console.log(`page in ${name}: ${mistakes.length} mistakes`);
if (mistakes.length) {
  console.error(mistakes.join("\n"));
  process.exit(1);
}
