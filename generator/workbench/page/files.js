// The files of the user: opening, dropping, what each is for, saving.
"use strict";

const ROLES = {
  set: "set or list",
  recording: "recording",
  excited: "recording with excitation",
  response: "response of the drive",
  older: "older version",
  part: "named by the set",
};

async function opened(files) {
  for (const file of files) put(file.name, new Uint8Array(await file.arrayBuffer()));
  if (!state.files.has(state.set)) state.set = fileOf("set") ?? "";
  else if (files.length === 1 && state.files.get(files[0].name).role === "set" && files[0].name !== state.set)
    state.set = files[0].name;
  // A set of several files names the others.
  const toml = [...state.files].find(([name, file]) => file.role === "set" && /\.toml$/i.test(name));
  if (toml && files.length > 1) state.set = toml[0];
  begin();
  await refresh();
}

/** Forgets what belonged to another set. */
function begin() {
  state.before.clear();
  state.undo = [];
  state.touched = null;
  state.axis = "";
}

function showFiles() {
  const rows = [...state.files].map(([name, file]) => {
    const role = make("select", { "aria-label": `Use of ${name}` });
    for (const [word, words] of Object.entries(ROLES)) role.append(make("option", { value: word }, words));
    role.value = file.role;
    role.onchange = () => {
      file.role = role.value;
      refresh();
    };
    const remove = button(
      "Remove",
      () => {
        state.files.delete(name);
        if (state.set === name) state.set = fileOf("set") ?? "";
        refresh();
      },
      { "aria-label": `Remove ${name}` },
    );
    return [name, role, remove];
  });
  fill($("files"), table(["file", "use", ""], rows));
  const sets = [...state.files].filter(([, file]) => file.role === "set").map(([name]) => name);
  options($("set"), sets, state.set);
  $("empty").hidden = state.files.size > 0;
}

async function save() {
  const name = "workbench.zip";
  // A list names no targets: the chosen language is meant.
  const isNamed = /\.toml$/i.test(state.set) && /^\s*targets\s*=/m.test(text.of(state.files.get(state.set).bytes).text);
  const { data, files } = await ask({ command: "zip", of: subject(), targets: isNamed ? [] : [$("target").value], name });
  if (data) download(name, files[0][1], "application/zip");
  say(data ? `saved ${name}: ${data.entries.length} generated files and your own` : "nothing is saved: the set has errors");
}

function listen() {
  $("open").onchange = (event) => opened([...event.target.files]);
  $("example").onclick = () => {
    const bytes = new TextEncoder().encode(texts.example);
    put("rack-and-pinion.lis", bytes, "set");
    state.files.get("rack-and-pinion.lis").original = bytes;
    state.set = "rack-and-pinion.lis";
    if (!$("cycle").value) $("cycle").value = "1ms";
    begin();
    refresh();
  };
  document.ondragover = (event) => {
    event.preventDefault();
    document.body.classList.add("over");
  };
  document.ondragleave = () => document.body.classList.remove("over");
  document.ondrop = (event) => {
    event.preventDefault();
    document.body.classList.remove("over");
    opened([...event.dataTransfer.files]);
  };
}
