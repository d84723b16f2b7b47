// Every message of an MCAP file, as readers of others decode it, against `scarab-log cat FILE --json`:
//   node compare_cat.mjs FILE CAT.ndjson
import { readFileSync } from "node:fs";
import { check, run } from "./check.mjs";
import { readLog } from "./log_file.mjs";
import { jsonStructDifference, parseJson } from "./same_value.mjs";

function compareMessage(message, line, place) {
  const printed = parseJson(line);
  check(printed.topic === message.topic, `${place}: topic ${printed.topic}, by others ${message.topic}`);
  check(printed.sequence.number === String(message.sequence), `${place}: sequence ${printed.sequence.number}`);
  check(BigInt(printed.log_time_ns) === message.logTime, `${place}: log time ${printed.log_time_ns}`);
  check(BigInt(printed.publish_time_ns) === message.publishTime, `${place}: publish time ${printed.publish_time_ns}`);
  const { schema, value } = message;
  const difference = jsonStructDifference(schema, schema.name, value, printed.value);
  check(difference == undefined, `${place}, ${message.topic}: ${difference}`);
}

await run("compare_cat", async ([file, catFile]) => {
  const log = await readLog(file);
  const lines = readFileSync(catFile, "utf8").split("\n").slice(0, -1);
  check(lines.length === log.messages.length, `${lines.length} lines, by others ${log.messages.length} messages`);
  lines.forEach((line, i) => compareMessage(log.messages[i], line, `line ${i + 1}`));
  return `${lines.length} messages of ${log.topics} topics agree (${log.chunks} chunks, ${log.compressions})`;
});
