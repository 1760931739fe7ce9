// Modules of WebAssembly, taken apart (webassembly.github.io/spec/core/binary).

export const section = { custom: 0, imports: 2, globals: 6, exports: 7, code: 10 };

export class Reader {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
  }
  get done() {
    return this.at >= this.bytes.length;
  }
  byte() {
    return this.bytes[this.at++];
  }
  number() {
    let value = 0, byte, shift = 0;
    do {
      byte = this.byte();
      value += (byte & 0x7f) * 2 ** shift;
      shift += 7;
    } while (byte & 0x80);
    return value;
  }
  skipNumber() {
    while (this.byte() & 0x80);
  }
  take(size) {
    return this.bytes.subarray(this.at, (this.at += size));
  }
}

export function encoded(number) {
  const bytes = [];
  for (; number > 0x7f; number = Math.floor(number / 128)) bytes.push((number & 0x7f) | 0x80);
  return [...bytes, number];
}

export function joined(parts) {
  const all = new Uint8Array(parts.reduce((size, part) => size + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

// How many functions and globals a module imports.
export function countImports(content) {
  const reader = new Reader(content), counts = { functions: 0, globals: 0 };
  for (let left = reader.number(); left > 0; --left) {
    reader.take(reader.number());
    reader.take(reader.number());
    const kind = reader.byte();
    if (kind === 0) ++counts.functions;
    if (kind === 3) ++counts.globals;
    if (kind === 1) reader.byte(); // a table: of what
    if (kind === 1 || kind === 2) skipLimits(reader);
    else if (kind === 3) reader.take(2);
    else if (kind === 4) reader.take(1), reader.skipNumber();
    else reader.skipNumber();
  }
  return counts;
}
function skipLimits(reader) {
  const hasMost = reader.byte() & 1;
  reader.skipNumber();
  if (hasMost) reader.skipNumber();
}

// The same module with other contents of sections: `change` gets the number and the content of each, and gives the new content,
// or nothing if the section goes.
export function withSections(module, change) {
  const reader = new Reader(module), out = [reader.take(8)];
  while (!reader.done) {
    const id = reader.byte(), changed = change(id, reader.take(reader.number()));
    if (changed) out.push([id], encoded(changed.length), changed);
  }
  return joined(out);
}

// The code section with other bodies: `change` gets each one's bytes and its place among them.
export function withBodies(content, change) {
  const reader = new Reader(content), count = reader.number(), out = [encoded(count)];
  for (let i = 0; i < count; ++i) {
    const body = change(reader.take(reader.number()), i);
    out.push(encoded(body.length), body);
  }
  return joined(out);
}

// The functions that an object defines (github.com/WebAssembly/tool-conventions, Linking.md): `see` gets each one's name for a
// linker, the bytes around it, and where its flags are.
function eachFunction(object, see) {
  const table = 8, aFunction = 0, aSection = 3, undefinedFlag = 0x10, named = 0x40;
  const decoder = new TextDecoder(), text = (reader) => decoder.decode(reader.take(reader.number()));
  const readSymbol = (reader) => {
    const kind = reader.byte(), at = reader.at, flags = reader.number(), isDefined = !(flags & undefinedFlag);
    if (kind === 1) { // data
      text(reader);
      if (isDefined) reader.number(), reader.number(), reader.number();
      return;
    }
    reader.number(); // its place among its like
    const name = kind !== aSection && (isDefined || flags & named) ? text(reader) : '';
    if (kind === aFunction && isDefined) see(name, reader.bytes, at);
  };
  const readLinking = (content) => {
    const reader = new Reader(content);
    if (text(reader) !== 'linking') return;
    reader.number(); // version
    while (!reader.done) {
      const kind = reader.byte(), part = new Reader(reader.take(reader.number()));
      if (kind === table) for (let left = part.number(); left > 0; --left) readSymbol(part);
    }
  };
  withSections(object, (id, content) => void (id === section.custom && readLinking(content)));
}

export function definedFunctions(object) {
  const names = [];
  eachFunction(object, (name) => names.push(name));
  return names;
}

// The same object, whose functions give way to others of their names.
export function weakened(object) {
  const weak = 1, local = 2, copy = object.slice();
  eachFunction(copy, (_, bytes, at) => (bytes[at] |= bytes[at] & local ? 0 : weak));
  return copy;
}
