// The module that a reader's file became, running: its server (tools/judge/page/server.cpp) answers calls of exercises by the frames of
// tools/judge/protocol/wire.hpp. A page's demos call it, and so do its tests.
(function () {
  'use strict';
  const decoder = new TextDecoder();
  const hello = 0x46624630, kinds = ['hello', 'call', 'result', 'not yet', 'missing', 'refused', 'threw', 'no memory', 'crashed']; // wire::Frame
  const header = 12; // [bytes]
  const fuelPerSecond = 4e8; // see tools/play/fuel.mjs

  // What a module asks for that a page hasn't got, as a function that it can't call.
  function absent(module) {
    const missing = WebAssembly.Module.imports(module).filter(({ module: from, name, kind }) => from === 'env' && kind === 'function' && name);
    return Object.fromEntries(missing.map(({ name }) => [name, () => { throw new Error(`it uses ${name}, which doesn’t exist in a page`); }]));
  }

  // A file of a section that plays the reader's of earlier ones asks for these, but not before it's told to.
  const nobody = new Proxy({}, { get: () => () => -1 });

  class AnswerInstance {
    #exports;
    #asks;
    spent = 0; // [s]

    // wasi: what the module imports of the system's functions. asked: what answers for the reader's other files, { yours, play };
    // nothing where ours are meant.
    constructor(module, wasi, asked) {
      const env = { ...absent(module), __cpp_exception: new WebAssembly.Tag({ parameters: ['i32'] }) };
      this.instance = new WebAssembly.Instance(module, { wasi_snapshot_preview1: wasi, env, yours: nobody, play: nobody, ...asked });
      this.#exports = this.instance.exports;
      this.#asks = Boolean(asked);
    }

    // Calls with what is left of so many seconds.
    #within(seconds, work) {
      const { fuel } = this.#exports, given = Math.max(0, Math.round((seconds - this.spent) * fuelPerSecond));
      fuel.value = BigInt(given);
      try {
        work();
      } finally {
        this.spent += (given - Number(fuel.value)) / fuelPerSecond;
      }
    }
    get isOutOfFuel() {
      return this.#exports.fuel.value < 0n;
    }
    // Below its first kilobytes there is only the guard that the linker put there.
    get stackIsFull() {
      return this.#exports.__stack_pointer.value < 4096;
    }
    get memory() {
      return this.#exports.memory.buffer;
    }

    // The frame with which it says that it's there.
    greet(seconds) {
      this.#within(seconds, () => {
        if (this.#asks) this.#exports.ask_reader?.();
        this.#exports._initialize();
        this.#exports.course_greet();
      });
      return this.#reply();
    }
    // The frame that answers this one.
    answer(message, seconds) {
      this.#within(seconds, () => {
        const at = this.#exports.course_room(message.length); // which may move the memory
        new Uint8Array(this.memory).set(message, at);
        this.#exports.course_answer();
      });
      return this.#reply();
    }
    #reply() {
      return new Uint8Array(this.memory, this.#exports.course_reply(), this.#exports.course_reply_size()).slice();
    }
  }

  // A call of the exercise with this index in its section; its arguments as wire::Writer writes them.
  function callFrame(number, exercise, values) {
    const frame = new Uint8Array(header + 4 + values.length);
    frame.set(new Uint8Array(Uint32Array.of(hello + 1, number, 4 + values.length, exercise).buffer));
    frame.set(values, header + 4);
    return frame;
  }
  // { kind, value } of a result, or { kind, words } with what else it says.
  function readReply(frame) {
    const view = new DataView(frame.buffer), kind = kinds[view.getUint32(0, true) - hello], value = frame.subarray(header), words = [];
    if (kind !== 'result') {
      for (let at = header; at + 4 <= frame.length;) {
        const size = view.getUint32(at, true);
        words.push(decoder.decode(frame.subarray(at + 4, (at += 4 + size))));
      }
    }
    return { kind, value, words };
  }

  const frameOf = (kind) => hello + kinds.indexOf(kind);

  globalThis.courseAnswers = { AnswerInstance, callFrame, frameOf, readReply, fuelPerSecond };
})();
