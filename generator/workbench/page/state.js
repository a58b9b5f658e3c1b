// What the page shows: the files, the set, the last answers. No element is touched here.
"use strict";

const TARGETS = ["twincat", "codesys", "scl", "st", "c", "rust"];

const state = {
  /** name -> { bytes, original, role, sent } */
  files: new Map(),
  set: "",
  /** the answer to the last check: the axes that can be shown, the others, and whether blocks are generated */
  checked: null,
  refused: [],
  allowed: false,
  messages: [],
  axis: "",
  /** axis -> the check and the loop before the first change */
  before: new Map(),
  loop: null,
  /** { stage, value } */
  touched: null,
  traced: [],
  undo: [],
};

/** The set and what a list does not contain, for a request. */
function subject() {
  const response = [...state.files].find(([, file]) => file.role === "response");
  return { set: state.set, cycle_time: $("cycle").value.trim(), response: response ? response[0] : null };
}

function fileOf(role) {
  const found = [...state.files].find(([, file]) => file.role === role);
  return found ? found[0] : null;
}

/** Asks the worker, after the files that it does not have yet. */
async function ask(request) {
  const files = [...state.files].filter(([, file]) => !file.sent);
  for (const [, file] of files) file.sent = true;
  return client.ask(
    request,
    files.map(([name, file]) => [name, file.bytes]),
  );
}

function put(name, bytes, role) {
  const known = state.files.get(name);
  state.files.set(name, {
    bytes,
    original: known ? known.original : bytes,
    role: role ?? known?.role ?? kindOf(name, bytes),
    sent: false,
  });
}

/** What a file probably is. The user can say something else. */
function kindOf(name, bytes) {
  const head = new TextDecoder().decode(bytes.subarray(0, 2000)).toLowerCase();
  if (/\.(toml|lis|xti|tsproj)$/i.test(name)) return "set";
  if (/freq|\bhz\b|magnitude/.test(head) && !/v_command|x_command|v_motor/.test(head)) return "response";
  if (/[;,\t]/.test(head) || /\.(csv|txt|svcsv|tsv)$/i.test(name)) return fileOf("recording") ? "excited" : "recording";
  return "set";
}

/** Keeps files that an answer has changed: the worker has them. */
function keep(files) {
  for (const [name, bytes] of files) state.files.get(name).bytes = bytes;
}

const axisRow = () => state.checked?.axes.find((row) => row.axis === state.axis) ?? null;

/** The bytes of a file as text and back: UTF-8 if it is, else each byte is a character. UTF-16 is not edited here. */
const text = {
  of(bytes) {
    if ((bytes[0] === 0xff && bytes[1] === 0xfe) || (bytes[0] === 0xfe && bytes[1] === 0xff)) {
      return { text: new TextDecoder(bytes[0] === 0xff ? "utf-16le" : "utf-16be").decode(bytes), form: null };
    }
    try {
      return { text: new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes), form: "utf-8" };
    } catch {
      return { text: Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""), form: "latin-1" };
    }
  },
  bytes(characters, form) {
    if (form === "utf-8") return new TextEncoder().encode(characters);
    return Uint8Array.from(characters, (letter) => letter.charCodeAt(0));
  },
};
