// The markup of the page: html-validate finds nothing: `node markup.mjs PAGE`.
import { readFileSync } from "node:fs";
import { HtmlValidate } from "html-validate";

const validate = new HtmlValidate({ extends: ["html-validate:recommended"] });
const report = await validate.validateString(readFileSync(process.argv[2], "utf8"));
const found = report.results.flatMap((result) => result.messages);
console.log(`markup: ${found.length} messages`);
for (const { line, column, ruleId, message } of found.slice(0, 30)) console.error(`${line}:${column} ${ruleId}: ${message}`);
if (found.length) process.exit(1);
