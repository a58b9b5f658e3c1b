// The worker: files and a request to WebAssembly, the answer back. It knows nothing of the page.
"use strict";

self.onmessage = ({ data }) => {
  if (data.wasm) {
    wasm_bindgen.initSync({ module: data.wasm });
    wasm_bindgen.begin();
    self.postMessage({ ready: true });
    return;
  }
  try {
    for (const name of data.removed) wasm_bindgen.remove(name);
    for (const [name, bytes] of data.files) wasm_bindgen.put(name, bytes);
    const answer = JSON.parse(wasm_bindgen.ask(JSON.stringify(data.request)));
    // An answer names the files that it has changed, or made.
    const files = (answer.data?.files ?? []).map((name) => [name, wasm_bindgen.get(name)]);
    self.postMessage({ id: data.id, answer, files }, files.map(([, bytes]) => bytes.buffer));
  } catch (error) {
    // Out of stack or memory, a panic has no message of its own.
    self.postMessage({ id: data.id, panic: wasm_bindgen.panicked() || String(error) });
  }
};
