// The WebAssembly of the workbench in node, by the same text that the page gives to its worker. It tests nothing.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { gunzipSync } from "node:zlib";

/** The text of a part of the page. */
function part(html, id) {
  const from = html.indexOf(">", html.indexOf(`id="${id}"`)) + 1;
  return html.slice(from, html.indexOf("</script>", from));
}

/** The functions of a page's WebAssembly; every call begins a new module. */
export function loader(file) {
  const html = readFileSync(file, "utf8");
  const digits = readFileSync(join(process.env.WORKBENCH_ROOT, "generator/workbench/page/digits.js"), "utf8");
  const wasm = gunzipSync(new Function(`${digits}\nreturn bytesOf;`)()(part(html, "wasm")));
  const source = part(html, "worker-source");
  const module = new WebAssembly.Module(wasm);
  return () => {
    const functions = new Function("self", `${source}\nreturn wasm_bindgen;`)({});
    functions.initSync({ module });
    functions.begin();
    const ask = (request) => JSON.parse(functions.ask(JSON.stringify(request)));
    return { put: functions.put, get: functions.get, panicked: functions.panicked, ask };
  };
}

/** The files of an archive without compression: name -> bytes. */
export function unzipped(bytes) {
  const view = Buffer.from(bytes);
  const files = new Map();
  let at = 0;
  while (view.readUInt32LE(at) === 0x04034b50) {
    const [length, name] = [view.readUInt32LE(at + 22), view.readUInt16LE(at + 26)];
    const from = at + 30 + name + view.readUInt16LE(at + 28);
    files.set(view.toString("utf8", at + 30, at + 30 + name), view.subarray(from, from + length));
    at = from + length;
  }
  return files;
}
