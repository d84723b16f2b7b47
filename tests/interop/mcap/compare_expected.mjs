// Reads an MCAP file with readers that share no code with Scarab's, and checks that they agree with its writer:
//   node compare_expected.mjs FILE EXPECTED.json
// EXPECTED.json: { "<topic>": [ {<fields of the first message>}, ... ] }; fields that are not named are not compared.
// Exit code 0 and one line of figures when all is well; 1 and the reason when not.
import { readFileSync } from "node:fs";
import { check, run } from "./check.mjs";
import { readLog } from "./log_file.mjs";

/** Where `actual` lacks something of `expected`, as text; undefined when it has all of it. */
function difference(expected, actual, path) {
  if (Array.isArray(expected)) {
    if (actual?.length !== expected.length) return `${path}: ${actual?.length} elements`;
    for (let i = 0; i < expected.length; ++i) {
      const found = difference(expected[i], actual[i], `${path}[${i}]`);
      if (found != undefined) return found;
    }
  } else if (typeof expected === "object") {
    for (const [key, value] of Object.entries(expected)) {
      const found = difference(value, actual?.[key], `${path}.${key}`);
      if (found != undefined) return found;
    }
  } else {
    const plain = typeof actual === "bigint" ? actual.toString() : actual;
    if (!Object.is(plain, expected)) return `${path}: ${plain} instead of ${expected}`;
  }
  return undefined;
}

function compareValues(expected, decoded) {
  let compared = 0;
  for (const [topic, samples] of Object.entries(expected)) {
    const all = decoded.get(topic) ?? [];
    check(all.length >= samples.length, `${topic}: ${all.length} messages, ${samples.length} sent`);
    samples.forEach((sample, i) => {
      const at = all.length - samples.length + i;  // a sample before the first one expected may be there
      const found = difference(sample, all[at], `${topic} message ${at}`);
      check(found == undefined, `${found} (${all.length} messages, ${samples.length} sent)`);
      ++compared;
    });
    check(all.length <= samples.length + 1, `${topic}: ${all.length} messages, ${samples.length} sent`);
  }
  return compared;
}

await run("compare_expected", async ([file, expectedFile]) => {
  const log = await readLog(file);
  const decoded = new Map();
  for (const { topic, value } of log.messages) decoded.set(topic, [...(decoded.get(topic) ?? []), value]);
  const compared = compareValues(JSON.parse(readFileSync(expectedFile, "utf8")), decoded);
  check(log.attachments.length > 0, "no attachment");
  return (
    `${log.messages.length} messages of ${log.topics} topics decoded, ${compared} compared with what was sent, ` +
    `${log.chunks} chunks, ${log.attachments.length} attachments`
  );
});
