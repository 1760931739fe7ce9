// What `./course check` would print of a file, from what the compiler, the linker and the tests of a page have said: words.wasm,
// which is the terminal's own code.
const encoder = new TextEncoder(), decoder = new TextDecoder();
const notThere = 52; // ENOSYS: it asks nothing of a system but at its end

// A function from a request to an answer.
//   request: { section: '08_nt_collisions', sections: [all of them],
//     only: '8.1', or '' for all,
//     exercises: [{ number, tier, function }],                    of the section, as the catalogue has them
//     header, stub, renamed, mistakes,                            texts of the section's files
//     text, name: 'exercises/08_….cpp',                           of the reader's file, and how it's called
//     file: '/own/08_nt_collisions.cpp',                          how the compiler was given it
//     step: 'compiled' | 'not compiled' | 'not linked', compiler, what the compiler and the linker printed
//     verdicts: [{…}],                                            as the tests tell them
//     symbols: ['_ZN…', …] }                                      functions in the file's object: see definedFunctions()
//   answer: { text, with a terminal's colours,
//     states: { '8.1': 'passed' | 'wrong' | 'not started' | … },  of those that this check says something of
//     picture: '<svg…' | null,                                    of the first failure
//     mistake: 'you …' | '',                                      as the text names it
//     place: { line, column } | null }                            from 1, where the compiler stopped in the file
// Or, of all that was checked, what `./course feedback` would write: { attempts: [{ number, state, mistake, when }], hints: { '8.1': 2 } }
// to { text }.
// Needed are section, exercises, file, text and step. A sketch, { sketch: true, section: '00_sketch', … }, belongs to no section.
export function loadWords(module) {
  const wasi = new Proxy({}, { get: () => () => notThere });
  const { exports } = new WebAssembly.Instance(module, { wasi_snapshot_preview1: wasi });
  exports._initialize();
  return (request) => {
    const bytes = encoder.encode(JSON.stringify(request)), at = exports.room(bytes.length);
    new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
    const size = exports.answer(); // which may move the memory
    const answer = JSON.parse(decoder.decode(new Uint8Array(exports.memory.buffer, exports.reply(), size)));
    if (answer.error) throw new Error(`A check can't be put into words: ${answer.error}`);
    return answer;
  };
}
