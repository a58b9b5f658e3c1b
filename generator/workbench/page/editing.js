// Changes of a value: the newest one of a moving slider is sent, those between are left out.
"use strict";

const editing = {
  running: false,
  next: null,
  isRunning() {
    return this.running || this.next !== null;
  },
};

async function change(stage, value, to) {
  if (!Number.isFinite(to)) return;
  touch(stage, value, false);
  editing.next = { stage, value, to };
  if (editing.running) return;
  editing.running = true;
  try {
    while (editing.next) {
      const { stage: of, value: what, to: number } = editing.next;
      editing.next = null;
      await edited({ command: "edit", of: subject(), axis: state.axis, stage: of, value: what, to: number });
    }
  } catch (error) {
    say(error.message);
  }
  editing.running = false;
  showStages();
  showText();
  later(showCode, 300);
}

async function edited(request) {
  const from = performance.now();
  const { data, messages, files } = await ask(request);
  if (!data) {
    showMessages(messages);
    return;
  }
  keep(files);
  accept(data.checked, messages);
  drawLoop(data.loop);
  measure("slider step", from);
}

/** Takes over the result of a check; null: nothing could be read. */
function accept(data, messages) {
  state.revision += 1;
  state.checked = data?.checked ?? null;
  state.refused = data?.refused ?? [];
  state.allowed = data?.allowed ?? false;
  state.messages = messages;
  choose();
  showMessages(messages);
  $("verify").disabled = !data?.whole;
  $("save").disabled = !state.allowed;
  say(summary());
}

/** Shows the chosen axis, else the first one. */
function choose() {
  if (!axisRow()) state.axis = state.checked?.axes[0]?.axis ?? "";
  const row = axisRow();
  if (row && !state.before.has(state.axis)) state.before.set(state.axis, { row: structuredClone(row), loop: null });
  if (row) complete(state.before.get(state.axis).row, row.stages);
  showAxes();
  showStages();
  outdate();
}

function touch(stage, value, shows = true) {
  const isSame = state.touched?.stage === stage && state.touched?.value === value;
  state.touched = { stage, value };
  if (shows && !isSame) mark();
}

const timers = new Map();

/** Does something a little later, once. */
function later(what, milliseconds) {
  clearTimeout(timers.get(what));
  const then = () => {
    timers.delete(what);
    what();
  };
  timers.set(what, setTimeout(then, milliseconds));
}
