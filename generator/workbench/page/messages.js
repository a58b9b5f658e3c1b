// The messages, the state of the page, and the text of the set.
"use strict";

function say(words) {
  $("state").textContent = words;
}

function summary() {
  if (!state.set) return "Ready: no file is open";
  const errors = state.messages.filter((message) => message.severity === "error").length;
  const warnings = state.messages.length - errors;
  const counted = (count, what) => `${count} ${what}${count === 1 ? "" : "s"}`;
  const end = state.allowed ? "" : "; no block is generated";
  return `${state.set}: ${counted(errors, "error")}, ${counted(warnings, "warning")}${end}`;
}

const MOST_SHOWN = 200;

function showMessages(messages) {
  if (isShown("messages", [messages, state.set, [...state.files.keys()]])) return;
  const items = messages.slice(0, MOST_SHOWN).map((message) => {
    const place = message.line ? `${message.file}:${message.line}${message.column ? `:${message.column}` : ""}` : message.file;
    const go = message.line && state.files.has(message.file) ? button(place, () => jump(message)) : make("span", {}, place);
    const more = [
      message.allowed && `allowed: ${message.allowed}`,
      message.instead && `write instead: ${message.instead}`,
    ].filter(Boolean);
    const kind = make("strong", { className: message.severity }, `${message.severity}[${message.code}]`);
    return make("li", {}, go, " ", kind, ` ${message.found}`, ...more.map((line) => make("div", {}, line)));
  });
  if (messages.length > MOST_SHOWN) items.push(make("li", {}, `too many messages: the first ${MOST_SHOWN} are shown`));
  if (!items.length) items.push(make("li", {}, state.set ? "none" : "no file is open"));
  fill($("messages"), ...items);
}

/** A larger text is not shown: a field for it would hold up the page. */
const LARGEST_TEXT = 2000000;
let shownFile = "";

function showText(name = state.set) {
  if (timers.has(typed)) takeTyped();
  const field = $("text");
  const file = state.files.get(name);
  shownFile = name;
  if (!file) {
    field.value = "";
    field.readOnly = true;
    return;
  }
  const { text: characters, form } = text.of(file.bytes.subarray(0, LARGEST_TEXT));
  field.readOnly = form === null || file.bytes.length > LARGEST_TEXT;
  const lines = characters.replace(LINE_END, "\n");
  if (field.value !== lines) field.value = lines;
}

/** Goes to the place of a message in its file. */
function jump({ file, line, column }) {
  showText(file);
  const field = $("text");
  const lines = field.value.split("\n");
  const from = lines.slice(0, line - 1).reduce((sum, text) => sum + text.length + 1, 0);
  const to = from + (lines[line - 1] ?? "").length;
  field.focus();
  field.setSelectionRange(column ? Math.min(from + column - 1, to) : from, to);
  field.scrollTop = Math.max(0, (line - 4) * 18);
}

function takeTyped() {
  const file = state.files.get(shownFile);
  if (file && !$("text").readOnly) file.bytes = text.bytes($("text").value, file.bytes);
}

/** Takes over what the user has typed. */
async function typed() {
  takeTyped();
  await refresh(false);
}

/** Takes over at once what was typed: every request is about the text that is shown. */
async function flushed() {
  if (!timers.has(typed)) return;
  clearTimeout(timers.get(typed));
  timers.delete(typed);
  await typed();
}
