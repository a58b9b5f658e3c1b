// The files of the user: opening, dropping, what each is for, saving.
"use strict";

const ROLES = {
  set: "set or list",
  recording: "recording",
  excited: "recording with excitation",
  response: "response of the drive",
  older: "older version",
  part: "named by the set",
  unused: "not used",
};

async function opened(files) {
  await flushed();
  const [names, said] = [[], []];
  for (const file of files) {
    if (names.includes(file.name)) {
      said.push(`a second file with the name ${file.name} is left out: rename it`);
      continue;
    }
    try {
      put(file.name, new Uint8Array(await file.arrayBuffer()));
      names.push(file.name);
    } catch (error) {
      said.push(`${file.name} cannot be read; folders cannot be opened: ${error.message}`);
    }
  }
  await recognised(names);
  chooseSet(names);
  await refresh();
  const uses = names.filter((name) => name !== state.set).map((name) => `${name}: ${useOf(state.files.get(name))}`);
  if (uses.length) $("files-part").open = true;
  if (uses.length || said.length) say([...said, summary(), ...uses].join("; "));
}

/** Chooses a set among new files, and begins anew if the set or a part of it is among them. */
function chooseSet(names) {
  const was = state.set;
  const sets = names.filter((name) => state.files.get(name).role === "set");
  const toml = sets.find(isToml);
  const isAlone = names.length === 1 && sets.length === 1;
  if (!state.files.has(was)) state.set = toml ?? sets[0] ?? fileOf("set") ?? "";
  else if (toml ? isAlone || !isToml(was) : isAlone && !isToml(was)) state.set = sets[0];
  const chosen = state.files.get(state.set);
  const isPart = (name) => name === state.set || (chosen && text.of(chosen.bytes).text.includes(name));
  if (state.set !== was || names.some(isPart)) begin(was);
}

/** Forgets what belonged to another version of the set, or to another set. */
function begin(was) {
  state.before.clear();
  state.touched = null;
  if (state.set !== was) state.axis = "";
}

/** The use of a file in words. */
function useOf({ role, of }) {
  if (!of) return ROLES[role];
  return `${ROLES[role]} of the axis ${of.axis}${of.set === state.set ? "" : ` of ${of.set}`}`;
}

function showFiles() {
  const rows = [...state.files].map(([name, file]) => {
    const role = make("select", { "aria-label": `Use of ${name}` });
    for (const [word, words] of Object.entries(ROLES))
      role.append(make("option", { value: word }, word === file.role ? useOf(file) : words));
    role.value = file.role;
    role.onchange = () => {
      use(name, role.value);
      refresh();
    };
    const remove = button(
      "Remove",
      () => {
        state.files.delete(name);
        if (state.set === name) {
          state.set = fileOf("set") ?? "";
          begin(name);
        }
        return refresh();
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
  await flushed();
  const isNamed = isToml(state.set) && /^\s*targets\s*=/m.test(text.of(state.files.get(state.set).bytes).text);
  const { data, files } = await ask({ command: "zip", of: subject(), targets: isNamed ? [] : [$("target").value], name });
  if (data) download(name, files[0][1], "application/zip");
  const without = subject().responses.length ? "; they are made without the dropped response, which is not in the set" : "";
  if (!data) return say("nothing is saved: the set has errors");
  say(`saved ${name}: ${data.entries.length} generated files and your own${without}`);
}

function listen() {
  const open = (files) => opened([...files]).catch((error) => say(error.message));
  $("open").onchange = (event) => open(event.target.files);
  $("example").onclick = () => {
    const bytes = new TextEncoder().encode(texts.example);
    put("rack-and-pinion.lis", bytes, "set");
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
    open(event.dataTransfer.files);
  };
}
