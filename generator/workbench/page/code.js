// The generated files of the axis, and the lines that depend on each parameter.
"use strict";

let generated = [];
const HINT = $("named").textContent;

async function showCode() {
  const target = $("target").value;
  const axis = state.axis;
  const from = performance.now();
  const hasErrors = state.checked && !state.allowed;
  const { data } = axis && state.allowed ? await ask({ command: "code", of: subject(), axis, target }) : { data: null };
  if (axis !== state.axis || target !== $("target").value) return;
  $("named").textContent = hasErrors ? "No block is generated: the set has errors." : HINT;
  generated = data?.emitted ?? [];
  state.traced = data ? linesOf(data.trace) : [];
  options(
    $("file"),
    generated.map((file) => file.name),
  );
  showFile();
  measure("lines", from);
}

const VALUE_OF = { fg_f0: "f0", q_factor: "q_factor", osc_damping: "damping", damping: "damping", weight_fact_num: "weight" };

/** The parameters that have coefficients, each with its lines; those of the stages with the number of the page. */
function linesOf({ parameters, coefficients }) {
  return parameters
    .filter((of) => of.coefficients.length)
    .map((of) => {
      const stage = /stage\[(\d)\]/.exec(of.path);
      const value = VALUE_OF[of.path.split(".").pop()];
      const lines = of.coefficients
        .map((at) => coefficients[at])
        .flatMap(({ path, lines: files }) =>
          files.flatMap(({ file, lines }) => lines.map((line) => ({ file, line, coefficient: path }))),
        );
      return {
        stage: stage && value ? Number(stage[1]) : null,
        value,
        parameter: of.id,
        path: of.path,
        given: of.given,
        lines,
      };
    });
}

/** Shows a file; lines that are there keep their elements. */
function showFile() {
  const file = generated.find((of) => of.name === $("file").value);
  const lines = file?.text.split("\n") ?? [];
  const rows = [...$("code").children];
  for (const row of rows.slice(lines.length)) row.remove();
  lines.forEach((line, n) => {
    const row = rows[n] ?? $("code").appendChild(make("div"));
    if (row.textContent !== (line || " ")) row.textContent = line || " ";
  });
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
      row.tabIndex = -1;
      row.onclick = () => nameLine(name, line.line);
    }
  }
  if (first) $("code").scrollTop = first.offsetTop - $("code").offsetTop - 60;
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
  const found = state.traced.flatMap((of) =>
    of.lines.filter((line) => line.file === file && line.line === number).map((line) => ({ of, line })),
  );
  const words = found.map(({ of, line }) => `${of.parameter ?? ""} ${of.path} -> ${line.coefficient}`);
  $("named").textContent = words.join("; ");
  const input = found[0] && $(`${found[0].of.value}${found[0].of.stage}`);
  if (input) input.scrollIntoView({ block: "nearest" });
}
