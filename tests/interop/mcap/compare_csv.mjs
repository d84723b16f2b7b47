// Every value of an MCAP file, as readers of others decode it, against `scarab-log export --format csv --times`:
//   node compare_csv.mjs FILE FOLDER ELEMENTS
// FOLDER has a table for each topic, <topic, its slashes as dots>.csv, made with --elements ELEMENTS.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { check, run } from "./check.mjs";
import { readLog } from "./log_file.mjs";
import { scalarDifference } from "./same_value.mjs";

/** RFC 4180. */
function parseCsv(text) {
  const rows = [[]];
  const cells = /("(?:[^"]|"")*"|[^",\n]*)(,|\n)/gy;
  for (let match; (match = cells.exec(text)) != null; ) {
    const [, cell, end] = match;
    rows.at(-1).push(cell.startsWith('"') ? cell.slice(1, -1).replaceAll('""', '"') : cell);
    if (end === "\n") rows.push([]);
    if (cells.lastIndex === text.length) return rows.slice(0, -1);
  }
  throw new Error("no CSV");
}

function compareRow(message, columns, row, place) {
  check(row[0] === String(message.logTime) && row[1] === String(message.publishTime), `${place}: times`);
  columns.forEach(({ path, field, value }, i) => {
    const actual = value(message.value);
    const cell = row[i + 2];
    const found = actual == undefined ? cell || undefined : scalarDifference(message.schema, field, actual, cell);
    check(found == undefined, `${place}, ${path}: ${found}`);
  });
  return columns.length;
}

function compareTable(messages, rows, elements, place) {
  const columns = messages[0].schema.columns(elements);
  const header = ["log_time_ns", "publish_time_ns", ...columns.map(({ path }) => path)];
  check(rows[0].join() === header.join(), `${place}: columns ${rows[0]}, by others ${header}`);
  check(rows.length - 1 === messages.length, `${place}: ${rows.length - 1} rows, by others ${messages.length}`);
  const counts = messages.map((message, i) => compareRow(message, columns, rows[i + 1], `${place}:${i + 2}`));
  return counts.reduce((sum, count) => sum + count, 0);
}

await run("compare_csv", async ([file, folder, elements]) => {
  const { messages } = await readLog(file);
  const topics = [...new Set(messages.map((message) => message.topic))];
  let cells = 0;
  for (const topic of topics) {
    const name = `${topic.replaceAll("/", ".")}.csv`;
    const rows = parseCsv(readFileSync(join(folder, name), "utf8"));
    cells += compareTable(messages.filter((message) => message.topic === topic), rows, Number(elements), name);
  }
  return `${cells} cells of ${topics.length} tables agree`;
});
