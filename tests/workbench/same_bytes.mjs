// Every file that the page generates has the bytes of the command's file: `node same_bytes.mjs PAGE released|quick AXGEN`.
import { loader } from "./library.mjs";
import { ARCHIVE, Comparison, filesBeside, subjectOf, subjects } from "./sets.mjs";

const [page, kind, axgen] = process.argv.slice(2);
const begin = loader(page);

/** The archive of the page, or null if it refuses the set. */
function ofPage(path) {
  const own = begin();
  for (const [name, bytes] of filesBeside(path)) own.put(name, bytes);
  const of = subjectOf(path);
  own.ask({ command: "check", of });
  return own.ask({ command: "zip", of, ...ARCHIVE }).data ? own.get(ARCHIVE.name) : null;
}

const compared = new Comparison(axgen);
for (const path of subjects(kind === "released" ? 1 : 8)) compared.add(path, ofPage(path));
console.log(`same bytes: ${compared}`);
if (compared.mistakes.length || compared.files < 100) {
  console.error(compared.mistakes.slice(0, 30).join("\n"));
  process.exit(1);
}
