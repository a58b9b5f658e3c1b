// What the page shows: the files, the set, the last answers. No element is touched here.
"use strict";

const TARGETS = ["twincat", "codesys", "scl", "st", "c", "rust"];

const state = {
  /** name -> { bytes, original, role, of }: the bytes now and when it was opened; for a response its set and its axis */
  files: new Map(),
  set: "",
  /** the answer to the last check: the axes that can be shown, the others, and whether blocks are generated */
  checked: null,
  refused: [],
  allowed: false,
  messages: [],
  axis: "",
  /** counts the checks: a result of a tool belongs to one */
  revision: 0,
  /** axis -> the check and the loop before the first change */
  before: new Map(),
  loop: null,
  /** { stage, value } */
  touched: null,
  traced: [],
};

/** What the worker has: name -> bytes. */
const sent = new Map();

const isToml = (name) => /\.toml$/i.test(name);

/** The set, what a list does not contain, and the responses of its axes, for a request. */
function subject() {
  const own = [...state.files].filter(([, file]) => file.role === "response" && file.of?.set === state.set);
  const responses = own.map(([name, file]) => ({ file: name, axis: file.of.axis }));
  return { set: state.set, cycle_time: $("cycle").value.trim(), responses };
}

function fileOf(role) {
  const found = [...state.files].find(([, file]) => file.role === role);
  return found ? found[0] : null;
}

/** Asks the worker, after it has the files of the page, and those of this request only. */
async function ask(request, more = []) {
  await flushed();
  const files = [...state.files].map(([name, { bytes }]) => [name, bytes]).concat(more);
  const names = new Set(files.map(([name]) => name));
  const changed = files.filter(([name, bytes]) => sent.get(name) !== bytes);
  const removed = [...sent.keys()].filter((name) => !names.has(name));
  for (const name of removed) sent.delete(name);
  for (const [name, bytes] of changed) sent.set(name, bytes);
  return client.ask(request, changed, removed);
}

/** Adds a file as it was opened; one that was there keeps its use. */
function put(name, bytes, role = state.files.get(name)?.role) {
  state.files.set(name, { bytes, original: bytes, role, of: state.files.get(name)?.of ?? null });
}

/** Gives a file its use. Those of the table in ONE have one file each, a response one for an axis. */
const ONE = ["recording", "excited", "response", "older"];
function use(name, role) {
  const file = state.files.get(name);
  file.role = role;
  file.of = role === "response" && state.axis ? { set: state.set, axis: state.axis } : null;
  for (const other of state.files.values()) {
    const isSame = other.role === role && other.of?.set === file.of?.set && other.of?.axis === file.of?.axis;
    if (ONE.includes(role) && other !== file && isSame) other.role = "unused";
  }
}

/** Gives the chosen axis the responses that have none yet; whether there were any. */
function bound() {
  const free = [...state.files].filter(([, file]) => file.role === "response" && !file.of);
  if (state.axis) for (const [name] of free) use(name, "response");
  return state.axis !== "" && free.length > 0;
}

/** Gives new files the use that their readers find: a list, if it is neither a response nor a recording. */
async function recognised(names) {
  const isSet = (name) => /\.(toml|lis|xti|tsproj)$/i.test(name);
  const open = names.filter((name) => !state.files.get(name).role);
  for (const name of open.filter(isSet)) use(name, "set");
  const others = open.filter((name) => !isSet(name));
  if (!others.length) return;
  // What a reader cannot end with has the use that its name says.
  const { data } = await ask({ command: "kinds", names: others }).catch(() => ({ data: null }));
  others.forEach((name, n) => {
    const kind = data?.[n] ?? (/\.(csv|svcsv|tsv)$/i.test(name) ? "recording" : "set");
    const isSecond = kind === "recording" && fileOf("recording") && !fileOf("excited");
    use(name, isSecond ? "excited" : kind);
  });
}

/** Keeps files that an answer has changed: the worker has them. */
function keep(files) {
  for (const [name, bytes] of files) {
    state.files.get(name).bytes = bytes;
    sent.set(name, bytes);
  }
}

const axisRow = () => state.checked?.axes.find((row) => row.axis === state.axis) ?? null;

const LINE_END = /\r\n|\r|\n/g;

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
  /** An edited text as bytes: lines that are as before keep their ends, the others get that of the first line. */
  bytes(edited, before) {
    const { text: was, form } = this.of(before);
    const ends = was.match(LINE_END) ?? [];
    const [old, now] = [was.split(LINE_END), edited.split("\n")];
    const shorter = Math.min(old.length, now.length);
    let [above, below] = [0, 0];
    while (above < shorter && old[above] === now[above]) above += 1;
    while (below < shorter - above && old[old.length - 1 - below] === now[now.length - 1 - below]) below += 1;
    const endOf = (n) => (n < above ? ends[n] : n >= now.length - below ? ends[n - now.length + old.length] : ends[0]);
    const lines = now.map((line, n) => (n === now.length - 1 ? line : line + (endOf(n) ?? ends[0] ?? "\n")));
    const all = lines.join("");
    if (form === "utf-8" || /[^\0-\xff]/.test(all)) return new TextEncoder().encode(all);
    return Uint8Array.from(all, (letter) => letter.charCodeAt(0));
  },
};
