// What is done with a set beyond its loop: verification, differences, recordings, simulation, commissioning, parameter sets.
"use strict";

const SAMPLES = 20000;

/** A part that is opened: a title, and a button that fills its result. */
function part(id, title, words, action, ...inputs) {
  const result = make("div", { id: `${id}-result` });
  const run = button(title, async () => {
    fill(result, "working");
    try {
      fill(result, ...(await action(result)));
    } catch (error) {
      fill(result, error.message);
    }
  });
  return make("details", { id }, make("summary", {}, title), make("p", {}, words), ...inputs, run, result);
}

function refusals(messages) {
  return messages.map((message) =>
    make(
      "p",
      { className: message.severity },
      `${message.file}: ${message.found}${message.instead ? `; ${message.instead}` : ""}`,
    ),
  );
}

async function verify() {
  const from = performance.now();
  const { data, messages } = await ask({ command: "verify", samples: SAMPLES });
  if (!data) return refusals(messages);
  const bits = data.rows.reduce((sum, row) => sum + (row.differing_bits ?? 0), 0);
  const time = `${((performance.now() - from) / 1000).toFixed(1)} s`;
  say(`verified: ${data.rows.length} runs of ${SAMPLES} samples, ${bits} differing bits, ${time}`);
  const rows = data.rows.map((row) => [
    row.axis,
    row.block,
    row.engine,
    String(row.samples),
    String(row.differing_bits ?? "-"),
    row.first,
    row.digest,
  ]);
  const reached = pre(data.reached.join("\n"), "Reached states");
  return [table(["axis", "block", "engine", "samples", "differing bits", "first difference", "digest"], rows), reached];
}

async function difference() {
  const old = fileOf("older") ?? "older version";
  if (!fileOf("older"))
    state.files.set(old, { bytes: state.files.get(state.set).original, original: null, role: "older", sent: false });
  const name = /\.toml$/i.test(state.set) && !/\.toml$/i.test(old) ? `${old}.toml` : old;
  if (name !== old) state.files.set(name, { ...state.files.get(old), role: "older", sent: false });
  const { data, messages } = await ask({ command: "diff", of: subject(), old: name });
  for (const of of [old, name]) if (state.files.get(of)?.original === null) state.files.delete(of);
  if (!data) return refusals(messages);
  return [pre(data.lines.join("\n") || "no difference", "Differences")];
}

function recordings() {
  return { recording: fileOf("recording"), excited: fileOf("excited") };
}

async function measured() {
  if (!recordings().recording) return ["Open a recording first: a CSV file with the command and the velocities of the axis."];
  const { data, messages } = await ask({ command: "measure", of: subject(), axis: state.axis || null, ...recordings() });
  if (!data) return refusals(messages);
  const response = () => download("response.csv", new TextEncoder().encode(data.response), "text/csv");
  return [
    pre(data.text, "Measured"),
    data.response ? button("Save the response of the drive", response) : "",
    ...(data.picture ? [picture(data.picture, "Spectra of the recording")] : []),
    ...refusals(messages),
  ];
}

async function tuned() {
  if (!recordings().recording)
    return ["Open a recording of moves with the stages off first, and one with the excitation or a response of the drive."];
  const { data, messages } = await ask({ command: "tune", of: subject(), axis: state.axis, ...recordings() });
  if (!data) return refusals(messages);
  const row = (of) => [
    of.kind,
    of.stages
      .map((stage) => `${stage.mode} ${shown(stage.f0)} Hz Q ${shown(stage.q)} weight ${shown(stage.weight)}`)
      .join(", "),
    shown(of.ms),
    of.residuals.map((left) => `${shown(left.hz)} Hz: ${shown(left.ratio)}`).join(", "),
    button("Apply", () => applied(of.kind), { "aria-label": `Apply ${of.kind}` }),
  ];
  const list = table(["proposal", "stages", "Ms", "left of a vibration", ""], data.proposals.proposals.map(row));
  return [
    list,
    pre(data.text, "Proposals"),
    ...(data.picture ? [picture(data.picture, "Spectra before and after")] : []),
    ...refusals(messages),
  ];
}

async function applied(proposal) {
  const { data, messages, files } = await ask({ command: "apply", of: subject(), axis: state.axis, proposal });
  if (!data) return showMessages(messages);
  keep(files);
  await refresh();
  say(data.changes.join("; "));
}

async function simulated() {
  const { data, messages } = await ask({ command: "simulate", axis: state.axis });
  return data
    ? [pre(data.text, "Simulation"), picture(data.picture, "Simulation with and without the stages")]
    : refusals(messages);
}

async function commissioning() {
  const { data, messages } = await ask({ command: "page", axis: state.axis, target: $("target").value });
  return data
    ? [
        pre(data.text, "Commissioning page"),
        button("Save the page", () => download(data.name, new TextEncoder().encode(data.text), "text/markdown")),
      ]
    : refusals(messages);
}

async function parameterSet() {
  const on = fileOf("older") ?? state.set;
  const form = $("form").value;
  const { data, messages } = await ask({ command: "params_of", of: subject(), axis: state.axis, on, form });
  if (!data) return refusals(messages);
  const bytes = Uint8Array.from(data.bytes);
  return [
    form === "bin" ? `${bytes.length} bytes` : pre(data.text, "Parameter set"),
    button("Save", () => download(`${state.axis}.${form}`, bytes)),
    ...refusals(messages),
  ];
}

function showWork() {
  const form = make("select", { id: "form" });
  options(form, ["st", "scl", "c", "rust", "csv", "bin"]);
  fill(
    $("work"),
    part(
      "verify-part",
      "Verify",
      `Every block of every axis with ${SAMPLES} samples in every engine of this page: the reference, its program, and the ` +
        "emitted Structured Text of four dialects. Every bit is compared.",
      verify,
    ),
    part("measure-part", "Measure", "Sampling, vibrations and the response of the drive in the recordings.", measured),
    part(
      "tune-part",
      "Propose stages",
      "Stages from a recording of moves, with what they would leave of each vibration.",
      tuned,
    ),
    part("simulate-part", "Simulate", "The loop of the axis over time, with and without its stages.", simulated),
    part(
      "diff-part",
      "Compare",
      "What has changed for the machine since the file was opened, or since an older version among the files.",
      difference,
    ),
    part(
      "page-part",
      "Commissioning page",
      "How to put the block into operation at the machine, with the numbers of this axis.",
      commissioning,
    ),
    part(
      "params-part",
      "Parameter set",
      "The numbers of this axis for a block that takes parameter sets, generated from an older version.",
      parameterSet,
      make("label", {}, "Form ", form),
    ),
  );
}
