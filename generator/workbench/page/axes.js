// The axes with their verdicts, and the stages of one axis with their numbers.
"use strict";

const VALUES = {
  f0: { label: "f0 [Hz]", field: "f0", from: 0.2, to: 5 },
  q_factor: { label: "Q", field: "q_factor", from: 0.2, to: 5 },
  damping: { label: "Damping", field: "damping", from: 0.2, to: 5 },
  weight: { label: "Weight", field: "asked_weight", from: 0, to: 7 },
};
const STEPS = 1000;

/** The axes with their verdicts; those that cannot be designed with what is wrong. */
function showAxes() {
  const axes = (state.checked?.axes ?? []).map(({ axis, blocks, reserve }) => ({ axis, words: blocks.join(", "), reserve }));
  const refused = state.refused.map(({ axis, found }) => ({ axis, words: found, reserve: "error" }));
  const rows = [...axes, ...refused];
  if (isShown("axes", [rows, state.axis])) return;
  const body = rows.map(({ axis, words, reserve }) => {
    // The worker's name of a verdict is its words with lines between them.
    const verdict = reserve ? make("span", { className: reserve }, reserve.replace("_", " ")) : "-";
    const name = reserve === "error" ? axis : button(axis, () => chooseAxis(axis));
    const line = make("tr", {}, make("td", {}, name), make("td", {}, words), make("td", {}, verdict));
    if (axis === state.axis) line.setAttribute("aria-current", "true");
    return line;
  });
  const head = make("tr", {}, ...["axis", "blocks", "loop"].map((name) => make("th", { scope: "col" }, name)));
  fill(
    $("axes"),
    make("caption", {}, `${rows.length} ${rows.length === 1 ? "axis" : "axes"}`),
    make("thead", {}, head),
    make("tbody", {}, ...body),
  );
}

/** The cards of the stages; a card that is there keeps its elements, so that a slider keeps the focus. */
function showStages() {
  const row = axisRow();
  const cards = $("stages");
  const key = row ? `${state.set}/${row.axis}/${row.stages.map((stage) => stage.mode).join()}` : "";
  if (cards.dataset.of !== key) {
    cards.dataset.of = key;
    fill(cards, ...(row?.stages ?? []).map(card));
  }
  for (const stage of row?.stages ?? []) update(stage);
}

function card(stage) {
  const at = stage.stage;
  const title = make("legend", {}, `Stage ${at}: ${stage.mode}`);
  if (!stage.active) return make("fieldset", { id: `stage${at}` }, title);
  const values = Object.keys(VALUES).filter((value) => stage.active[VALUES[value].field] !== null);
  return make(
    "fieldset",
    { id: `stage${at}` },
    title,
    make("p", { id: `verdict${at}` }),
    ...values.map((value) => control(at, value)),
  );
}

function control(stage, value) {
  const id = `${value}${stage}`;
  // A field for numbers would drop the comma of 1,5 in some browsers.
  const number = make("input", { type: "text", inputMode: "decimal", autocomplete: "off", id });
  const range = make("input", {
    type: "range",
    id: `range-${id}`,
    min: 0,
    max: STEPS,
    step: 1,
    "aria-label": `${VALUES[value].label} of stage ${stage}`,
  });
  number.onchange = () => entered(stage, value, number);
  range.oninput = () => change(stage, value, atStep(Number(range.value), stage, value));
  range.onchange = number.onfocus = range.onfocus = () => touch(stage, value);
  const undo = button("Undo", () => change(stage, value, originalOf(stage, value)), {
    id: `undo-${id}`,
    "aria-label": `Undo ${value} of stage ${stage}`,
  });
  const label = make("label", { htmlFor: id }, VALUES[value].label);
  return make("div", { className: "value" }, label, number, range, make("small", { id: `was-${id}` }), undo);
}

/** Takes over a number that was typed, with a decimal point or comma; nothing and other text change nothing. */
function entered(stage, value, field) {
  const typed = field.value.trim();
  const to = Number(typed.replace(",", "."));
  if (typed !== "" && Number.isFinite(to)) return change(stage, value, to);
  say(`${VALUES[value].label} of stage ${stage}: ${typed === "" ? "nothing" : `"${typed}"`} is not a number`);
  showStages();
}

function originalOf(stage, value) {
  const before = state.before.get(state.axis)?.row.stages[stage];
  return before?.active?.[VALUES[value].field] ?? null;
}

/** A number that a stage did not have when the file was opened begins as it is now. */
function complete(before, stages) {
  for (const { stage, active } of stages) {
    if (!active) continue;
    const of = (before.stages[stage] ??= { stage, active: null });
    const was = (of.active ??= structuredClone(active));
    for (const { field } of Object.values(VALUES)) was[field] ??= active[field];
  }
}

/** A position of the slider as a value: the weight evenly from 0 to 7, all else by ratios around the value in the file. */
function atStep(step, stage, value) {
  const { from, to } = VALUES[value];
  if (value === "weight") return Number(((step / STEPS) * to).toFixed(2));
  return Number((originalOf(stage, value) * from * (to / from) ** (step / STEPS)).toPrecision(4));
}

function stepOf(number, stage, value) {
  const { from, to } = VALUES[value];
  if (value === "weight") return Math.round((number / to) * STEPS);
  return Math.round((Math.log(number / (originalOf(stage, value) * from)) / Math.log(to / from)) * STEPS);
}

function update(stage) {
  if (!stage.active) return;
  const verdict = $(`verdict${stage.stage}`);
  verdict.textContent = stage.active.verdict;
  verdict.className = stage.active.reserve ?? "";
  for (const value of Object.keys(VALUES)) {
    const id = `${value}${stage.stage}`;
    const number = $(id);
    if (!number) continue;
    const now = stage.active[VALUES[value].field];
    const was = originalOf(stage.stage, value);
    number.value = shown(now);
    const range = $(`range-${id}`);
    if (document.activeElement !== range || !editing.isRunning()) range.value = stepOf(now, stage.stage, value);
    range.setAttribute("aria-valuetext", shown(now));
    $(`was-${id}`).textContent = `in the file: ${shown(was)}`;
    $(`undo-${id}`).hidden = now === was;
  }
}
