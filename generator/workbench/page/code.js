// The generated files of the axis, and the lines that depend on each parameter.
"use strict";

let generated = [];

async function showCode() {
  const target = $("target").value;
  const axis = state.axis;
  const from = performance.now();
  if (!axis || !state.allowed) {
    generated = [];
    options($("file"), []);
    fill($("code"));
    $("named").textContent = axis ? "No block is generated: the set has errors." : "";
    measure("lines", from);
    return;
  }
  const { data } = await ask({ command: "files", target, axis });
  generated = data ?? [];
  state.traced = [];
  options($("file"), generated.map((file) => file.name));
  showFile();
  const { data: traced } = await ask({ command: "trace", axis, target });
  if (axis !== state.axis || target !== $("target").value) return;
  state.traced = traced ?? [];
  mark();
  measure("lines", from);
}

function showFile() {
  const file = generated.find((of) => of.name === $("file").value);
  const lines = (file?.text ?? "").split("\n");
  fill($("code"), ...lines.map((line) => make("div", {}, line || " ")));
  mark();
}

/** Marks the lines of this file that depend on a parameter; those of the touched one more, and scrolls to the first of them. */
function mark() {
  const rows = $("code").children;
  for (const row of rows) {
    row.className = "";
    row.removeAttribute("tabindex");
    row.onclick = null;
  }
  const name = $("file").value;
  // The line that declares a coefficient is of more interest than a comment above it.
  let [first, declares] = [null, null];
  for (const of of state.traced) {
    const isTouched = state.touched?.stage === of.stage && state.touched?.value === of.value;
    for (const line of of.lines.filter((line) => line.file === name)) {
      const row = rows[line.line - 1];
      if (!row) continue;
      row.classList.add("mark");
      if (isTouched) {
        row.classList.add("touched");
        first ??= row;
        if (line.coefficient) declares ??= row;
      }
      row.tabIndex = -1;
      row.onclick = () => nameLine(name, line.line);
    }
  }
  const shown = declares ?? first;
  if (shown) $("code").scrollTop = shown.offsetTop - $("code").offsetTop - 60;
}

/** The arrows lead from one marked line to the next, and Enter names its parameter: one stop for the key Tab. */
function keyInCode(event) {
  const marked = [...$("code").querySelectorAll(".mark")];
  const at = marked.indexOf(document.activeElement);
  const next = { ArrowDown: at + 1, ArrowUp: Math.max(0, at - 1) }[event.key];
  if (event.key === "Enter") document.activeElement.onclick?.();
  if (next === undefined || !marked[next]) return;
  event.preventDefault();
  marked[next].focus();
}

/** Names the parameters of a line, and goes to the first one. */
function nameLine(file, number) {
  const found = state.traced.flatMap((of) => of.lines.filter((line) => line.file === file && line.line === number).map((line) => ({ of, line })));
  const words = found.map(({ of, line }) => `stage ${of.stage}: ${of.value}, ${of.parameter ?? ""} (${of.path})${line.coefficient ? ` -> ${line.coefficient}` : ""}`);
  $("named").textContent = words.join("; ");
  const input = found[0] && $(`${found[0].of.value}${found[0].of.stage}`);
  if (input) input.scrollIntoView({ block: "nearest" });
}
