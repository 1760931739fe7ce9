// A module that can't run for ever: each turn of a loop and each call takes one from a counter, the exported global `fuel`, and
// below 0 it traps. Nothing in the module can catch that.
import { countImports, encoded, joined, Reader, section, withBodies, withSections } from './wasm.mjs';

const op = { unreachable: 0x00, loop: 0x03, if: 0x04, end: 0x0b, getGlobal: 0x23, setGlobal: 0x24, i64Const: 0x42, i64LessThan: 0x53, i64Subtract: 0x7d };
const i64 = 0x7e, noResult = 0x40, mutable = 1, exportsGlobal = 3;

// What follows an instruction, by the instruction's first byte.
const immediates = new Map();
const follows = (bytes, skip) => bytes.forEach((byte) => immediates.set(byte, skip));
const range = (from, to) => Array.from({ length: to - from + 1 }, (_, i) => from + i);
const number = (reader) => reader.skipNumber();
const twoNumbers = (reader) => (reader.skipNumber(), reader.skipNumber());
const list = (reader) => {
  for (let left = reader.number(); left > 0; --left) reader.skipNumber();
};
follows([0x02, 0x03, 0x04, 0x06], number); // block, loop, if, try: a type
follows([0x07, 0x08, 0x09, 0x18, 0x0c, 0x0d, 0x10, 0x12, ...range(0x20, 0x26), 0x3f, 0x40, 0x41, 0x42, 0xd0, 0xd2], number);
follows([0x11, 0x13, ...range(0x28, 0x3e)], twoNumbers); // indirect calls, memory
follows([0x1c], list);
follows([0x0e], (reader) => (list(reader), reader.skipNumber())); // br_table
follows([0x43], (reader) => reader.take(4));
follows([0x44], (reader) => reader.take(8));
follows([0xfc], (reader) => {
  const kind = reader.number();
  for (let left = kind < 8 ? 0 : [9, 11, 13, 15, 16, 17].includes(kind) ? 1 : 2; left > 0; --left) reader.skipNumber();
});
follows([...range(0x00, 0x01), 0x05, 0x0b, 0x0f, 0x19, 0x1a, 0x1b, ...range(0x45, 0xc4), 0xd1], () => {});

function skipInstruction(reader) {
  const byte = reader.byte(), skip = immediates.get(byte);
  if (!skip) throw new Error(`an instruction of WebAssembly that isn't known here: 0x${byte.toString(16)}`);
  skip(reader);
  return byte;
}

function burn(fuel) {
  const get = [op.getGlobal, ...encoded(fuel)], set = [op.setGlobal, ...encoded(fuel)];
  return Uint8Array.from([...get, op.i64Const, 1, op.i64Subtract, ...set, ...get, op.i64Const, 0, op.i64LessThan, op.if, noResult, op.unreachable, op.end]);
}

function burning(body, burnt) {
  const reader = new Reader(body), out = [];
  for (let left = reader.number(); left > 0; --left) reader.skipNumber(), reader.byte(); // locals: how many, of what type
  let from = 0;
  const insert = () => {
    out.push(body.subarray(from, reader.at), burnt);
    from = reader.at;
  };
  insert();
  while (!reader.done) if (skipInstruction(reader) === op.loop) insert();
  out.push(body.subarray(from));
  return joined(out);
}

// One more entry of a list.
function extended(content, entry) {
  const reader = new Reader(content), count = reader.number();
  return joined([encoded(count + 1), content.subarray(reader.at), entry]);
}

export function withFuel(module) {
  let fuel = 0;
  const name = new TextEncoder().encode('fuel');
  return withSections(module, (id, content) => {
    if (id === section.imports) fuel += countImports(content).globals;
    if (id === section.globals) {
      fuel += new Reader(content).number();
      return extended(content, [i64, mutable, op.i64Const, 0, op.end]);
    }
    if (id === section.exports) return extended(content, [name.length, ...name, exportsGlobal, ...encoded(fuel)]);
    if (id === section.code) return withBodies(content, (body) => burning(body, burn(fuel)));
    return content;
  });
}
