// An MCAP file as two readers of others see it, which share no code with Scarab's.
import { readFileSync } from "node:fs";
import { crc32 } from "@foxglove/crc";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { loadDecompressHandlers } from "@mcap/support";
import { check } from "./check.mjs";
import { Schema } from "./schema.mjs";

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

/**
 * Reads all of a file both ways and compares them. Returns the decoded messages in the order of the file,
 * { topic, sequence, logTime, publishTime, schema, value }, with chunks and attachments.
 */
export async function readLog(file) {
  const bytes = new Uint8Array(readFileSync(file));
  const decompressHandlers = await loadDecompressHandlers();
  const records = readAsStream(bytes, decompressHandlers);
  const reader = await openIndexed(bytes, decompressHandlers);
  const streamed = records.filter((record) => record.type === "Message");
  compareReadings(streamed, await collect(reader.readMessages()), reader);

  const channels = new Map();
  for (const channel of reader.channelsById.values()) {
    check(channel.messageEncoding === "cdr", `${channel.topic}: encoding ${channel.messageEncoding}`);
    channels.set(channel.id, { topic: channel.topic, schema: new Schema(reader.schemasById.get(channel.schemaId)) });
  }
  const messages = streamed.map(({ channelId, sequence, logTime, publishTime, data }) => {
    const { topic, schema } = channels.get(channelId);
    return { topic, sequence, logTime, publishTime, schema, value: schema.decode(data) };
  });
  const attachments = await collect(reader.readAttachments());
  const compressions = [...new Set(reader.chunkIndexes.map((chunk) => chunk.compression || "none"))];
  return { messages, attachments, chunks: reader.chunkIndexes.length, compressions, topics: channels.size };
}
