// A section's tests, a WebAssembly module, call the module that a reader's file became: each case in a new instance of it, by
// the frames of tools/judge/protocol/wire.hpp. What goes wrong there is told as a process would have ended.
import { ConsoleStdout, WASI, WASIProcExit } from '@bjorn3/browser_wasi_shim';

const encoder = new TextEncoder(), decoder = new TextDecoder();
const fuelPerSecond = 4e8; // see fuel.mjs
const longestPrint = 4 << 20; // [bytes], as in judge/runner/student_process.hpp
const silence = { ended: -1, late: -2 }; // -1 - StudentProcess::Silence
const signals = { abort: 6, division: 8, printedTooMuch: 25 };
const crashed = 0x46624630 + 8, crash = { memory: 0, fullStack: 1 }; // wire::Frame and wire::Crash

class PrintedTooMuch extends Error {}

function outputs(write) {
  return [0, 1, 2].map(() => new ConsoleStdout(write));
}

// One instance of the reader's module.
class Student {
  #wasi;
  #exports;
  #printed = [];
  #size = 0;
  spent = 0; // [s]

  constructor(module) {
    this.#wasi = new WASI(['answer'], [], outputs((bytes) => this.#print(bytes)), { debug: false });
    const instance = new WebAssembly.Instance(module, {
      wasi_snapshot_preview1: this.#wasi.wasiImport,
      env: { __cpp_exception: new WebAssembly.Tag({ parameters: ['i32'] }) },
    });
    this.#wasi.inst = instance;
    this.#exports = instance.exports;
  }
  #print(bytes) {
    const room = longestPrint - this.#size;
    this.#printed.push(bytes.slice(0, room));
    this.#size += bytes.length;
    if (bytes.length > room) throw new PrintedTooMuch();
  }
  get printed() {
    const all = new Uint8Array(Math.min(this.#size, longestPrint));
    let at = 0;
    for (const part of this.#printed) {
      all.set(part, at);
      at += part.length;
    }
    return all;
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

  greet(seconds) {
    this.#within(seconds, () => {
      this.#exports._initialize();
      this.#exports.course_greet();
    });
    return this.#reply();
  }
  answer(message, seconds) {
    this.#within(seconds, () => {
      const at = this.#exports.course_room(message.length); // which may move the memory
      new Uint8Array(this.#exports.memory.buffer).set(message, at);
      this.#exports.course_answer();
    });
    return this.#reply();
  }
  #reply() {
    return new Uint8Array(this.#exports.memory.buffer, this.#exports.course_reply(), this.#exports.course_reply_size()).slice();
  }
  // Below its first kilobytes there is only the guard that the linker put there.
  get stackIsFull() {
    return this.#exports.__stack_pointer.value < 4096;
  }
}

// How a process would have ended that does what this error tells: a wait status, or the frame that its server sends.
function ending(error, student, call) {
  if (error instanceof WASIProcExit) return { status: (error.code & 0xff) << 8 };
  if (error instanceof PrintedTooMuch) return { status: signals.printedTooMuch };
  if (error instanceof RangeError || student.stackIsFull) return { frame: crashFrame(call, crash.fullStack) };
  if (error instanceof WebAssembly.Exception) return { status: signals.abort }; // nobody caught it
  if (!(error instanceof WebAssembly.RuntimeError)) throw error;
  if (/unreachable/.test(error.message)) return { status: signals.abort };
  if (/divide|remainder|float unrepresentable/.test(error.message)) return { status: signals.division };
  return { frame: crashFrame(call, crash.memory) };
}
const somewhere = 1 << 16; // an address that is no null pointer
const crashFrame = (call, why) => new Uint8Array(new Uint32Array([crashed, call, 12, why, somewhere, 0]).buffer);

// Runs the tests of an exercise, or all of them, on a module withFuel; `tell` is called with each verdict.
export function judge(tests, answer, exercise, seed, tell) {
  let memory, student, reply, status;
  const bytes = (at, size) => new Uint8Array(memory.buffer, at, size);
  const copy = (from, to, most) => {
    const part = from.subarray(0, most);
    bytes(to, part.length).set(part);
    return part.length;
  };
  const callOf = (message) => (message.length < 8 ? 0 : new DataView(message.buffer).getUint32(4, true));
  const studentCalls = {
    start() {
      student = new Student(answer);
      status = 0;
    },
    call(at, size, seconds) {
      const message = bytes(at, size).slice();
      try {
        reply = size === 0 ? student.greet(seconds) : student.answer(message, seconds);
      } catch (error) {
        if (student.isOutOfFuel) return silence.late;
        const how = ending(error, student, callOf(message));
        if (!how.frame) {
          status = how.status;
          return silence.ended;
        }
        reply = how.frame;
      }
      return reply.length;
    },
    take: (to) => void copy(reply, to),
    spent: () => student.spent,
    finish: () => status,
    printed: (to, most) => copy(student.printed, to, most),
  };
  const wasi = new WASI(['tests'], [], outputs(() => {}), { debug: false });
  const instance = new WebAssembly.Instance(tests, {
    wasi_snapshot_preview1: wasi.wasiImport,
    student: studentCalls,
    page: { verdict: (at, size) => tell(JSON.parse(decoder.decode(bytes(at, size)))) },
  });
  ({ memory } = instance.exports);
  wasi.initialize(instance);
  const number = encoder.encode(`${exercise}\0`), at = instance.exports.room(number.length);
  bytes(at, number.length).set(number);
  instance.exports.judge(at, seed);
}
