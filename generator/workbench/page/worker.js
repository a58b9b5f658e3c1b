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
    for (const [name, bytes] of data.files) wasm_bindgen.put(name, bytes);
    const answer = JSON.parse(wasm_bindgen.ask(JSON.stringify(data.request)));
    // An answer names the file that it has changed, or made.
    const file = answer.data?.file ? wasm_bindgen.get(answer.data.file) : null;
    self.postMessage({ id: data.id, answer, file }, file ? [file.buffer] : []);
  } catch (error) {
    // Out of stack or memory, a panic has no message of its own.
    self.postMessage({ id: data.id, panic: wasm_bindgen.panicked() || String(error) });
  }
};
