// Reads a recording with the MCAP project's own reader, decodes each message by the schema that the file carries, and
// compares every field with what Skein's own dump says was sent.
//
// usage: node compare.mjs FILE.mcap DUMP.jsonl     exit code 0: equal, 1: the first difference is printed
import { parseIDL } from "@foxglove/omgidl-parser";
import { MessageReader } from "@foxglove/omgidl-serialization";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { FileHandleReadable } from "@mcap/nodejs";
import { decompress } from "fzstd";
import { open, readFile } from "node:fs/promises";

const decompressHandlers = { zstd: (bytes, size) => decompress(bytes, new Uint8Array(Number(size))) };

// As the dump writes values: 64-bit integers as texts, numbers that are not finite as texts, lists as lists.
function plain(value) {
  if (typeof value === "bigint") return value.toString();
  if (typeof value === "number" && Number.isNaN(value)) return "nan";
  if (value === Infinity) return "inf";
  if (value === -Infinity) return "-inf";
  if (ArrayBuffer.isView(value) || Array.isArray(value)) return Array.from(value, plain);
  if (value !== null && typeof value === "object") {
    return Object.fromEntries(Object.entries(value).map(([key, inside]) => [key, plain(inside)]));
  }
  return value;
}

function difference(a, b, path) {
  if (Object.is(a, b)) return null;
  if (typeof a !== "object" || typeof b !== "object" || a === null || b === null) {
    return `${path}: decoded ${JSON.stringify(a)}, sent ${JSON.stringify(b)}`;
  }
  for (const key of new Set([...Object.keys(a), ...Object.keys(b)])) {
    const found = difference(a[key], b[key], `${path}.${key}`);
    if (found !== null) return found;
  }
  return null;
}

class Comparison {
  #lines;
  #channels = new Map();
  #readers = new Map();
  count = 0;
  fields = 0;
  topics = new Set();

  constructor(lines) {
    this.#lines = lines;
  }

  addSchema(schema) {
    if (schema.encoding !== "omgidl") throw new Error(`schema encoding is ${schema.encoding}`);
    const definitions = parseIDL(new TextDecoder().decode(schema.data));
    this.#readers.set(schema.id, new MessageReader(schema.name, definitions));
  }

  addChannel(channel) {
    if (channel.messageEncoding !== "cdr") throw new Error(`message encoding is ${channel.messageEncoding}`);
    this.#channels.set(channel.id, channel);
  }

  add(message) {
    const channel = this.#channels.get(message.channelId);
    const decoded = plain(this.#readers.get(channel.schemaId).readMessage(message.data));
    const sent = this.#lines[this.count];
    const where = `message ${this.count} (${channel.topic})`;
    if (sent === undefined) throw new Error(`${where}: not in the dump`);
    const outside = {
      topic: channel.topic,
      writer: channel.metadata.get("writer"),
      sequence: message.sequence,
      log_time: message.logTime.toString(),
      publish_time: message.publishTime.toString(),
      sample: decoded,
    };
    const found = difference(outside, sent, where);
    if (found !== null) throw new Error(found);
    this.topics.add(channel.topic);
    this.fields += Object.keys(decoded).length;
    ++this.count;
  }
}

const [file, dump] = process.argv.slice(2);
const lines = (await readFile(dump, "utf8")).split("\n").filter((line) => line !== "").map((line) => JSON.parse(line));

// record by record, with all checksums
const comparison = new Comparison(lines);
const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
stream.append(await readFile(file));
for (let record; (record = stream.nextRecord()) !== undefined; ) {
  if (record.type === "Schema") comparison.addSchema(record);
  if (record.type === "Channel") comparison.addChannel(record);
  if (record.type === "Message") comparison.add(record);
}
if (!stream.done()) throw new Error("the stream reader found no end of the file");
if (comparison.count !== lines.length) throw new Error(`${comparison.count} messages, ${lines.length} in the dump`);

// by the indexes
const handle = await open(file, "r");
const indexed = await McapIndexedReader.Initialize({ readable: new FileHandleReadable(handle), decompressHandlers });
if (indexed.statistics.messageCount !== BigInt(lines.length)) throw new Error("the statistics count other messages");
let messages = 0;
let time = 0n;
for await (const message of indexed.readMessages({ validateCrcs: true })) {
  if (message.logTime < time) throw new Error("the indexes are not in order of time");
  time = message.logTime;
  ++messages;
}
if (messages !== lines.length) throw new Error(`the indexes lead to ${messages} of ${lines.length} messages`);
const attachments = [];
for await (const attachment of indexed.readAttachments({ validateCrcs: true })) attachments.push(attachment.name);
const metadata = [];
for await (const item of indexed.readMetadata()) metadata.push(item.name);
await handle.close();
console.log(JSON.stringify({ messages, topics: [...comparison.topics].sort(), attachments, metadata }));
