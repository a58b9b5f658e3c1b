// A browser with the page in it, from file://, and what the tests find wrong. It tests nothing.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import puppeteer from "puppeteer-core";

const [page, kind, name, axgen, pictures] = process.argv.slice(2);
const root = process.env.WORKBENCH_ROOT;
export const isReleased = kind === "released";
export const isChromium = name === "chromium";
export const example = readFileSync(join(root, "examples/rack-and-pinion.lis"), "utf8");
export { axgen, name, root };

const mistakes = [];
/** Words that a message of the browser may have: what is wanted is an error for it. */
const wanted = [];

export function expect(what, is) {
  if (!is) mistakes.push(what);
}

export function equal(what, found, expected) {
  const at = [...found].findIndex((letter, n) => letter !== expected[n]);
  expect(`${what}: at ${at} '${found.slice(at, at + 80)}', not '${expected.slice(at, at + 80)}'`, found === expected);
}

/** From then on the browser may report errors with these words. */
export function allow(words) {
  wanted.push(words);
}

/** Prints a time. It may be three times what is wanted; a page for tests has no limit. */
export function within(what, milliseconds, limit) {
  console.log(`  ${name}: ${what} ${milliseconds.toFixed(0)} ms (${limit} ms)`);
  expect(`${what}: ${milliseconds.toFixed(0)} ms, more than 3 times ${limit} ms`, !isReleased || milliseconds <= 3 * limit);
}

const DARK = [{ name: "prefers-color-scheme", value: "dark" }];
const ARGUMENTS = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"];
// Firefox is dark from its start, Chromium where a test asks for it.
const OPTIONS = isChromium
  ? {
      executablePath: "/usr/bin/chromium",
      browser: "chrome",
      args: [...ARGUMENTS, "--disable-component-update", "--disable-sync"],
    }
  : {
      executablePath: "/usr/bin/firefox-esr",
      browser: "firefox",
      extraPrefsFirefox: { "layout.css.prefers-color-scheme.content-override": 0 },
    };
const browser = await puppeteer.launch({ headless: true, protocolTimeout: 300000, ...OPTIONS });

/** Opens the page. Every error that it or the browser reports is a mistake. */
export async function open({ width = 1500, isDark = false } = {}) {
  const tab = await browser.newPage();
  if (isDark) await tab.emulateMediaFeatures(DARK);
  await tab.setViewport({ width, height: 950 });
  const report = (words) =>
    expect(
      `console: ${words}`,
      wanted.some((of) => words.includes(of)),
    );
  tab.on("console", (message) => ["error", "warn"].includes(message.type()) && report(message.text()));
  tab.on("pageerror", (error) => report(error.message));
  await tab.goto(pathToFileURL(page).href);
  await tab.waitForFunction(() => document.getElementById("state").textContent.startsWith("Ready"));
  return tab;
}

/** Drops files on the page. */
export async function drop(tab, files, cycle = "") {
  await tab.evaluate(
    (all, cycle) => {
      delete times.all;
      document.getElementById("cycle").value = cycle;
      const transfer = new DataTransfer();
      for (const [name, text] of all) transfer.items.add(new File([text], name));
      document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
    },
    files,
    cycle,
  );
  await settled(tab);
}

/** Opens the page with the example. */
export async function openExample(options) {
  const tab = await open(options);
  await tab.evaluate(() => document.getElementById("example").click());
  await settled(tab);
  return tab;
}

export const text = (tab, id) => tab.evaluate((id) => document.getElementById(id).textContent, id);

/** Waits until everything is shown. */
export const settled = (tab) =>
  tab.waitForFunction(() => client.waiting.size === 0 && !editing.running && "all" in times && "lines" in times, {
    timeout: 60000,
  });

export const shot = (tab, what) => pictures && isChromium && tab.screenshot({ path: join(pictures, `${what}.png`) });

export async function end() {
  await browser.close();
  console.log(`page in ${name}: ${mistakes.length} mistakes`);
  if (mistakes.length) {
    console.error(mistakes.join("\n"));
    process.exit(1);
  }
}
