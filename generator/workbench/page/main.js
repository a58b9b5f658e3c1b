// Puts the parts of the page together: what follows a file, an axis, a change, a failure.
"use strict";

let texts = {};

/** For tests and for figures: how long each step took [ms]. */
const times = {};
function measure(what, from) {
  times[what] = performance.now() - from;
}

async function refresh(isWhole = true) {
  showFiles();
  if (!state.set) {
    accept(null, []);
    clearLoop();
    showText();
    return showCode();
  }
  const from = performance.now();
  say(`Reading ${state.set}`);
  try {
    bound();
    await checked();
    if (bound()) await checked();
    showFiles();
    measure("table", from);
    await showLoop();
    measure("first picture", from);
    if (isWhole) showText();
    await showCode();
    measure("all", from);
  } catch (error) {
    say(error.message);
  }
}

async function checked() {
  const { data, messages } = await ask({ command: "check", of: subject() });
  accept(data, messages);
}

async function chooseAxis(name) {
  state.axis = name;
  state.touched = null;
  choose();
  await showLoop();
  await showCode();
}

function listenToAll() {
  listen();
  $("cycle").onchange = () => refresh();
  $("set").onchange = () => {
    const was = state.set;
    state.set = $("set").value;
    begin(was);
    refresh();
  };
  $("target").onchange = () => showCode();
  $("file").onchange = showFile;
  $("code").onkeydown = keyInCode;
  $("save").onclick = () => save().catch((error) => say(error.message));
  $("stop").onclick = () => client.fail("stopped by the user");
  $("verify").onclick = () => {
    $("verify-part").open = true;
    $("verify-part").querySelector("button").click();
  };
  $("text").oninput = () => later(typed, 400);
  window.onresize = () => later(resize, 150);
  client.onBusy = (isBusy) => {
    $("stop").disabled = !isBusy;
  };
  client.onRestart = () => {
    sent.clear();
    // The new worker has read no set yet.
    later(reread, 0);
  };
}

/** Reads the set again in a new worker, unless that ended the last one. */
async function reread() {
  if (!state.checked) return;
  await ask({ command: "check", of: subject() }).catch(() => {});
}

async function start() {
  const from = performance.now();
  listenToAll();
  options($("target"), TARGETS);
  showWork();
  showMessages([]);
  showFiles();
  try {
    texts = JSON.parse(new TextDecoder().decode(await unpacked("texts")));
    $("version").textContent = texts.version;
    await client.begin();
    measure("ready", from);
    say(summary());
  } catch (error) {
    say(
      `This browser cannot run the page: ${error.message}. Chromium or Edge from version 103 on, or Firefox from 115 on, can.`,
    );
  }
  $("licences-part").ontoggle = () =>
    fill($("licences"), ...texts.licences.map(([of, words]) => make("div", {}, make("h3", {}, of), make("pre", {}, words))));
}

start();
