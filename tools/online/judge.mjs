// A section's tests, a WebAssembly module, call the module that a reader's file became: each case in a new instance of it, by
// the frames of tools/judge/protocol/wire.hpp. What goes wrong there is told as a process would have ended.
import { ConsoleStdout, WASI, WASIProcExit } from '@bjorn3/browser_wasi_shim';
import '../../docs/answers.js';

const encoder = new TextEncoder(), decoder = new TextDecoder();
const longestPrint = 4 << 20; // [bytes], as in judge/runner/student_process.hpp
const silence = { ended: -1, late: -2 }; // -1 - StudentProcess::Silence
const signals = { abort: 6, division: 8, printedTooMuch: 25 };
const crash = { memory: 0, fullStack: 1 }; // wire::Crash

class PrintedTooMuch extends Error {}

function outputs(write) {
  return [0, 1, 2].map(() => new ConsoleStdout(write));
}

// One instance of the reader's module, and what it prints.
class Student extends courseAnswers.AnswerInstance {
  #printed = [];
  #size = 0;

  constructor(module) {
    let print;
    const wasi = new WASI(['answer'], [], outputs((bytes) => print(bytes)), { debug: false });
    super(module, wasi.wasiImport);
    wasi.inst = this.instance;
    print = (bytes) => this.#print(bytes);
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
const crashFrame = (call, why) => new Uint8Array(new Uint32Array([courseAnswers.frameOf('crashed'), call, 12, why, somewhere, 0]).buffer);

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
