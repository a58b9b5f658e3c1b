// The generated files of the axis, and the lines that depend on each parameter.
"use strict";

let generated = [];

async function showCode() {
  const target = $("target").value;
  const axis = state.axis;
  if (!axis || !state.allowed) {
    generated = [];
    options($("file"), []);
    fill($("code"));
    $("named").textContent = axis ? "No block is generated: the set has errors." : "";
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
    row.removeAttribute("role");
    row.onclick = row.onkeydown = null;
  }
  const name = $("file").value;
  let first = null;
  for (const of of state.traced) {
    const isTouched = state.touched?.stage === of.stage && state.touched?.value === of.value;
    for (const line of of.lines.filter((line) => line.file === name)) {
      const row = rows[line.line - 1];
      if (!row) continue;
      row.classList.add("mark");
      if (isTouched) {
        row.classList.add("touched");
        first ??= row;
      }
      row.tabIndex = 0;
      row.setAttribute("role", "button");
      row.onclick = () => nameLine(name, line.line);
      row.onkeydown = (event) => event.key === "Enter" && nameLine(name, line.line);
    }
  }
  if (first) $("code").scrollTop = first.offsetTop - $("code").offsetTop - 60;
}

/** Names the parameters of a line, and goes to the first one. */
function nameLine(file, number) {
  const found = state.traced.flatMap((of) => of.lines.filter((line) => line.file === file && line.line === number).map((line) => ({ of, line })));
  const words = found.map(({ of, line }) => `stage ${of.stage}: ${of.value}, ${of.parameter ?? ""} (${of.path})${line.coefficient ? ` -> ${line.coefficient}` : ""}`);
  $("named").textContent = words.join("; ");
  const input = found[0] && $(`${found[0].of.value}${found[0].of.stage}`);
  if (input) input.scrollIntoView({ block: "nearest" });
}
