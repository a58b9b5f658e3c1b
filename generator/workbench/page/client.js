// The page's side of the worker: one request at a time, a stop at any time, and a new worker after a panic.
"use strict";

const client = {
  worker: null,
  wasm: null,
  waiting: new Map(),
  next: 0,
  ready: null,
  /** called when the worker has begun anew: it has lost the files */
  onRestart: () => {},
  onBusy: () => {},

  /** Unpacks the WebAssembly once, and starts a worker. */
  async begin() {
    this.wasm = await unpacked("wasm");
    this.source = URL.createObjectURL(
      new Blob([document.getElementById("worker-source").textContent], { type: "text/javascript" }),
    );
    await this.start();
  },

  start() {
    this.worker = new Worker(this.source);
    this.ready = new Promise((resolve, reject) => {
      this.worker.onmessage = ({ data }) => (data.ready ? resolve() : this.answered(data));
      this.worker.onerror = (event) => {
        event.preventDefault();
        reject(new Error(event.message));
        this.fail(event.message || "the worker cannot be started");
      };
    });
    this.worker.postMessage({ wasm: this.wasm });
    return this.ready;
  },

  /** The answer to a request: data, messages, and the files that the data name. `files`: changed ones; `removed`: names. */
  async ask(request, files = [], removed = []) {
    await this.ready;
    const id = this.next++;
    this.onBusy(true);
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.worker.postMessage({ id, request, files, removed });
    });
  },

  answered({ id, answer, files, panic }) {
    if (panic !== undefined) {
      this.fail(`axgen failed: ${panic}`);
      return;
    }
    const { resolve } = this.waiting.get(id);
    this.waiting.delete(id);
    this.onBusy(this.waiting.size > 0);
    resolve({ ...answer, files });
  },

  /** Ends all that runs, says why, and begins anew. */
  fail(why) {
    this.worker.terminate();
    const waiting = [...this.waiting.values()];
    this.waiting.clear();
    this.onBusy(false);
    this.start().catch(() => {});
    this.onRestart();
    for (const { reject } of waiting) reject(new Error(why));
  },
};

/** The bytes of a part of the page, which are gzip as text. */
async function unpacked(id) {
  const stream = new Blob([bytesOf(document.getElementById(id).textContent)])
    .stream()
    .pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
