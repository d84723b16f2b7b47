// Reads an MCAP file with readers that share no code with Scarab's, and checks that they agree with its writer:
//   node read_mcap.mjs FILE EXPECTED.json
// EXPECTED.json: { "<topic>": [ {<fields of the first message>}, ... ] }; fields that are not named are not compared.
// Exit code 0 and one line of figures when all is well; 1 and the reason when not.
import { readFileSync } from "node:fs";
import { crc32 } from "@foxglove/crc";
import { parseIDL } from "@foxglove/omgidl-parser";
import { MessageReader } from "@foxglove/omgidl-serialization";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";

function check(condition, message) {
  if (!condition) throw new Error(message);
}

/** Every record from front to back; the reader throws for a wrong chunk CRC. */
function readAsStream(bytes, decompressHandlers) {
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  const records = [];
  reader.append(bytes);
  for (let record; (record = reader.nextRecord()) != undefined; ) records.push(record);
  check(reader.done(), "the stream reader does not find the end of the file");
  check(reader.bytesRemaining() === 0, "bytes are left after the end of the file");
  return records;
}

/** By the summary, whose CRC Initialize checks, chunk indexes and message indexes. */
async function openIndexed(bytes, decompressHandlers) {
  const readable = {
    size: async () => BigInt(bytes.length),
    read: async (offset, length) => bytes.subarray(Number(offset), Number(offset + length)),
  };
  return await McapIndexedReader.Initialize({ readable, decompressHandlers });
}

async function collect(iterator) {
  const items = [];
  for await (const item of iterator) items.push(item);
  return items;
}

function makeDecoders(reader) {
  const decoders = new Map();
  for (const channel of reader.channelsById.values()) {
    const schema = reader.schemasById.get(channel.schemaId);
    check(channel.messageEncoding === "cdr", `${channel.topic}: encoding ${channel.messageEncoding}`);
    check(schema?.encoding === "omgidl", `${channel.topic}: schema encoding ${schema?.encoding}`);
    const definitions = parseIDL(new TextDecoder().decode(schema.data));
    decoders.set(channel.id, new MessageReader(schema.name, definitions));
  }
  return decoders;
}

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

/** The same messages both ways, as many as the statistics say. */
function compareReadings(streamed, indexed, reader) {
  check(BigInt(indexed.length) === reader.statistics.messageCount, "messages by index != statistics");
  check(streamed.length === indexed.length, `${streamed.length} messages streamed, ${indexed.length} indexed`);
  const key = (m) => `${m.channelId} ${m.sequence} ${m.logTime} ${m.publishTime} ${crc32(m.data)}`;
  const keys = new Set(streamed.map(key));
  check(indexed.every((message) => keys.has(key(message))), "an indexed message is not in the stream");
  for (const [id, count] of reader.statistics.channelMessageCounts) {
    const found = BigInt(indexed.filter((m) => m.channelId === id).length);
    check(found === count, `channel ${id}: ${found} messages, ${count} in the statistics`);
  }
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

async function main(file, expectedFile) {
  const bytes = new Uint8Array(readFileSync(file));
  const decompressHandlers = await loadDecompressHandlers();
  const records = readAsStream(bytes, decompressHandlers);
  const reader = await openIndexed(bytes, decompressHandlers);

  const dataSection = bytes.subarray(0, Number(reader.dataEndOffset));
  check(reader.dataSectionCrc !== undefined, "no CRC of the data section");
  check(crc32(dataSection) === reader.dataSectionCrc, "the CRC of the data section is wrong");

  const indexed = await collect(reader.readMessages());
  compareReadings(records.filter((r) => r.type === "Message"), indexed, reader);
  check(reader.chunkIndexes.length > 1, "too few chunks for a test of the index");
  check(reader.chunkIndexes.every((c) => c.compression === "zstd"), "a chunk is not zstd");

  const decoders = makeDecoders(reader);
  const decoded = new Map();
  for (const message of indexed) {
    const { topic } = reader.channelsById.get(message.channelId);
    const value = decoders.get(message.channelId).readMessage(message.data);
    decoded.set(topic, [...(decoded.get(topic) ?? []), value]);
  }
  const compared = compareValues(JSON.parse(readFileSync(expectedFile, "utf8")), decoded);

  const attachments = await collect(reader.readAttachments());
  check(attachments.length > 0, "no attachment");
  console.log(
    `${indexed.length} messages of ${decoders.size} topics decoded, ${compared} compared with what was sent, ` +
      `${reader.chunkIndexes.length} chunks, ${attachments.length} attachments`,
  );
}

try {
  await main(process.argv[2], process.argv[3]);
} catch (error) {
  console.error(`read_mcap: ${error.message}`);
  process.exitCode = 1;
}
