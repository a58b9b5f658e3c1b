// What is done with a set beyond its loop: verification, differences, recordings, simulation, commissioning, parameter sets.
"use strict";

const SAMPLES = 20000;

/** The results that are shown: element -> what they were made from, as a function and as it was. */
const results = new Map();
const ofSet = () => String(state.revision);
const ofAxis = () => `${state.revision} ${state.axis}`;

/** A part that is opened: a title, and a button that fills its result. `basis`: what the result is made from. */
function part(id, title, words, action, basis, ...inputs) {
  const result = make("div", { id: `${id}-result` });
  const run = button(title, async () => {
    results.delete(result);
    fill(result, "working");
    try {
      await flushed();
      const was = basis();
      fill(result, ...(await action()));
      results.set(result, { basis, was });
      outdate();
    } catch (error) {
      fill(result, error.message);
    }
  });
  return make("details", { id }, make("summary", {}, title), make("p", {}, words), ...inputs, run, result);
}

/** Takes away the results of another axis, or of files that have changed. */
function outdate() {
  for (const [result, { basis, was }] of results) {
    if (basis() === was) continue;
    results.delete(result);
    fill(result, "The set, its files or the axis have changed since this was made. Run it again.");
  }
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

/** The older version among the files, else the files as they were opened; with those that only this request needs. */
function older() {
  const name = fileOf("older");
  if (!name) {
    const isNamed = ([, { role }]) => !["recording", "excited"].includes(role);
    const files = [...state.files].filter(isNamed).map(([of, { original }]) => [`older/${of}`, original]);
    return { name: `older/${state.set}`, files };
  }
  if (isToml(name) || !isToml(state.set)) return { name, files: [] };
  return { name: `${name}.toml`, files: [[`${name}.toml`, state.files.get(name).bytes]] };
}

async function difference() {
  const old = older();
  const { data, messages } = await ask({ command: "diff", of: subject(), old: old.name }, old.files);
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
  if (!data) {
    showMessages(messages);
    return say(`not applied: ${messages.map((message) => message.found).join("; ")}`);
  }
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
  const [axis, form, on] = [state.axis, $("form").value, older()];
  const { data, messages } = await ask({ command: "params_of", of: subject(), axis, on: on.name, form }, on.files);
  if (!data) return refusals(messages);
  const bytes = Uint8Array.from(data.bytes);
  return [
    form === "bin" ? `${bytes.length} bytes` : pre(data.text, "Parameter set"),
    button("Save", () => download(`${axis}.${form}`, bytes)),
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
      ofSet,
    ),
    part("measure-part", "Measure", "Sampling, vibrations and the response of the drive in the recordings.", measured, ofAxis),
    part(
      "tune-part",
      "Propose stages",
      "Stages from a recording of moves, with what they would leave of each vibration.",
      tuned,
      ofAxis,
    ),
    part("simulate-part", "Simulate", "The loop of the axis over time, with and without its stages.", simulated, ofAxis),
    part(
      "diff-part",
      "Compare",
      "What has changed for the machine since the file was opened, or since an older version among the files.",
      difference,
      ofSet,
    ),
    part(
      "page-part",
      "Commissioning page",
      "How to put the block into operation at the machine, with the numbers of this axis.",
      commissioning,
      ofAxis,
    ),
    part(
      "params-part",
      "Parameter set",
      "The numbers of this axis for a block that takes parameter sets, generated from an older version " +
        "among the files, else from the set as it was opened.",
      parameterSet,
      ofAxis,
      make("label", {}, "Form ", form),
    ),
  );
}
