// Clang and its linker as one WebAssembly program, a WASI command; here and in a page. Each run sees the shared files, and
// leaves what it writes in a folder of its own, /own.
import { ConsoleStdout, Directory, File, OpenFile, PreopenDirectory, WASI } from '@bjorn3/browser_wasi_shim';

const encoder = new TextEncoder(), decoder = new TextDecoder();

// Files as the package has them are copied at each read, and made anew for each write.
class OpenBytes extends OpenFile {
  fd_read(size) {
    const begin = Number(this.file_pos), data = this.file.data.subarray(begin, begin + size);
    this.file_pos += BigInt(data.length);
    return { ret: 0, data };
  }
  fd_pread(size, offset) {
    return { ret: 0, data: this.file.data.subarray(Number(offset), Number(offset) + size) };
  }
  fd_write(data) {
    const begin = Number(this.file_pos), end = begin + data.length;
    this.file.reserve(end);
    this.file.room.set(data, begin);
    this.file.data = this.file.room.subarray(0, Math.max(this.file.data.length, end));
    this.file_pos += BigInt(data.length);
    return { ret: 0, nwritten: data.length };
  }
}
class Bytes extends File {
  constructor(bytes = new Uint8Array()) {
    super(new ArrayBuffer(0)); // it would copy them
    this.room = this.data = bytes;
  }
  reserve(size) {
    if (size <= this.room.length) return;
    this.room = new Uint8Array(Math.max(size, 2 * this.room.length, 1 << 16));
    this.room.set(this.data);
  }
  path_open(oflags) {
    if (oflags & OFLAGS_TRUNC) this.data = this.room = new Uint8Array();
    return { ret: 0, fd_obj: new OpenBytes(this) };
  }
}
const OFLAGS_TRUNC = 8, ERRNO_BADF = 8;

// The package's says that nothing may be written below it, and Clang asks.
class Root extends PreopenDirectory {
  fd_fdstat_get() {
    const { ret, fdstat } = super.fd_fdstat_get();
    fdstat.fs_rights_base = fdstat.fs_rights_inherited = (1n << 30n) - 1n;
    return { ret, fdstat };
  }
}

// A tree of folders from [path, bytes or text] pairs.
export function folder(files) {
  const root = new Directory(new Map());
  for (const [path, bytes] of files) {
    const parts = path.split('/').filter(Boolean), name = parts.pop();
    let at = root;
    for (const part of parts) {
      if (!at.contents.has(part)) at.contents.set(part, new Directory(new Map()));
      at = at.contents.get(part);
    }
    at.contents.set(name, new Bytes(typeof bytes === 'string' ? encoder.encode(bytes) : bytes));
  }
  return root;
}

// Clang writes without a buffer, some bytes at a time, twenty thousand times for an object: the package's makes six things each.
function quickWrite(wasi) {
  let buffer, view, bytes;
  return (fd, parts, count, written) => {
    const open = wasi.fds[fd];
    if (!open) return ERRNO_BADF;
    if (buffer !== wasi.inst.exports.memory.buffer) {
      buffer = wasi.inst.exports.memory.buffer;
      view = new DataView(buffer);
      bytes = new Uint8Array(buffer);
    }
    let size = 0;
    for (let at = parts; count-- > 0; at += 8) {
      const begin = view.getUint32(at, true), length = view.getUint32(at + 4, true);
      open.fd_write(bytes.subarray(begin, begin + length));
      size += length;
    }
    view.setUint32(written, size, true);
    return 0;
  };
}

// What the program printed to both outputs, the exit code, and what it wrote into /own by its name. A function that was cut out
// of the module traps: then `trapped` is what the engine says of it.
export function run(module, args, shared, inputs, ...outputs) {
  const said = [], hear = () => new ConsoleStdout((bytes) => said.push(decoder.decode(bytes, { stream: true })));
  const own = folder(Object.entries(inputs));
  for (const name of outputs) own.contents.set(name, new Bytes());
  const root = new Map([...shared.contents, ['own', own]]);
  const wasi = new WASI(args, [], [hear(), hear(), hear(), new Root('/', root)], { debug: false });
  const instance = new WebAssembly.Instance(module, { wasi_snapshot_preview1: { ...wasi.wasiImport, fd_write: quickWrite(wasi) } });
  const result = (more) => ({ ...more, said: said.join(''), ...Object.fromEntries(outputs.map((name) => [name, own.contents.get(name)?.data])) });
  try {
    return result({ code: wasi.start(instance) });
  } catch (error) {
    if (!(error instanceof WebAssembly.RuntimeError || error instanceof RangeError)) throw error;
    return result({ code: -1, trapped: String(error) });
  }
}

// As the driver calls the compiler proper, with WebAssembly's exceptions.
const language = ['-fno-temp-file', '-std=c++20', '-fdeprecated-macro', '-fgnuc-version=4.2.1', '-fno-implicit-modules', '-fcxx-exceptions',
  '-fexceptions', '-exception-model=wasm', '-target-feature', '+exception-handling', '-mllvm', '-wasm-enable-eh'];
const machine = ['-triple', 'wasm32-unknown-wasip1', '-mrelocation-model', 'static', '-mframe-pointer=none', '-mconstructor-aliases',
  '-target-cpu', 'generic', '-fvisibility=hidden'];
const folders = ['-resource-dir', '/usr', '-isysroot', '/usr', '-internal-isystem', '/tools/judge/page/libcxx', '-internal-isystem',
  '/usr/include/wasm32-wasip1/c++/v1', '-internal-isystem',
  '/usr/include/c++/v1', '-internal-isystem', '/usr/include', '-internal-isystem', '/usr/include/wasm32-wasip1', '-I/chapters', '-I/tools',
  '-isystem', '/eigen'];
// The course's own: see cmake/Flags.cmake.
const course = ['-ffp-contract=off', '-ftrivial-auto-var-init=pattern', '-DEIGEN_INITIALIZE_MATRICES_BY_NAN', '-DEIGEN_NO_IO',
  '-D_LIBCPP_REMOVE_TRANSITIVE_INCLUDES', '-D_LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_EXTENSIVE'];
// As the terminal's first compiler; and what only GCC, its second one, takes for an error.
const warnings = ['-Wall', '-Wextra', '-Wconversion', '-Wno-sign-conversion', '-Wshadow', '-Wno-unused-parameter', '-Werror=return-type',
  '-Werror=return-stack-address', '-Werror=dangling-gsl', '-Werror=duplicate-decl-specifier', '-Wshadow-all',
  '-Wconditional-uninitialized', '-Wimplicit-fallthrough', '-Wtautological-unsigned-zero-compare', '-ferror-limit', '20'];

const compiler = ['clang', '-cc1', ...machine, ...folders, ...language, ...course];
const header = '/loop/quick.hpp', precompiled = '/loop/quick.pch';
const behindHeader = ['-include-pch', precompiled, '-fno-validate-pch'];
const toObject = (name) => ['-emit-obj', '-main-file-name', name];

// The header that stands before a reader's file, with the templates that answers use made once; or another one.
export const precompile = (module, shared, file = header, ...flags) =>
  run(module, [...compiler, ...flags, '-fpch-instantiate-templates', '-fmodules-codegen', '-emit-pch', '-fno-pch-timestamp', '-x', 'c++-header', file,
    '-o', '/own/object'], shared, {}, 'object');
// The code of these templates.
export const compileHeader = (module, shared, file = precompiled) =>
  run(module, [...compiler, ...toObject('quick'), '-O2', '-x', 'precompiled-header', file, '-o', '/own/object'], shared, {}, 'object');

// A file of ours. Behind the header it is quick to compile.
export const compile = (module, shared, file, ...flags) =>
  run(module, [...compiler, ...toObject(file), '-O1', ...flags, '-x', 'c++', file, '-o', '/own/object'], shared, {}, 'object');
export const compileBehindHeader = (module, shared, section, file, ...flags) =>
  compile(module, shared, file, ...behindHeader, `-I/chapters/${section}`, ...flags);

// A reader's file.
export const compileAnswer = (module, shared, section, text, name = `${section}.cpp`) =>
  run(module, [...compiler, ...toObject(name), '-O0', ...behindHeader, ...warnings, `-I/chapters/${section}`, '-x', 'c++', `/own/${name}`,
    '-o', '/own/object'], shared, { [name]: text }, 'object');

// A reader's sketch stands behind a header of its own, and that one behind the other: with scenes, and the functions of all sections.
const sketchHeader = '/loop/sketch.hpp', precompiledSketch = '/loop/sketch.pch';
export const headersOf = (sections) => sections.flatMap((name) => ['-include', `${name}/${name.slice(3)}.hpp`]);
export const sketchFiles = () => [[sketchHeader, '#include <sketch.hpp>\n#include <array>\n#include <cmath>\n#include <string>\n#include <vector>\n']];
export const precompileSketch = (module, shared, sections) => precompile(module, shared, sketchHeader, ...behindHeader, ...headersOf(sections));
export const compileSketchHeader = (module, shared) => compileHeader(module, shared, precompiledSketch);
export const compileSketch = (module, shared, text, name = 'sketch.cpp') =>
  run(module, [...compiler, ...toObject(name), '-O0', '-include-pch', precompiledSketch, '-fno-validate-pch', ...warnings, '-x', 'c++', `/own/${name}`, '-o', '/own/object'],
    shared, { [name]: text }, 'object');

const system = '/usr/lib/wasm32-wasip1';
export const libraries = [`${system}/crt1-reactor.o`, ...['c++', 'c++abi', 'c'].map((name) => `${system}/lib${name}.a`),
  '/usr/lib/wasm32-unknown-wasip1/libclang_rt.builtins.a'];
// The tag of C++'s exceptions is the page's: from version 20 on, the compiler defines none.
const imports = '__cpp_exception\n';
export const link = (module, shared, answer, objects) =>
  run(module, ['wasm-ld', '-o', '/own/linked', '/own/answer.o', ...objects, ...libraries,
    '--allow-undefined-file=/own/imports', '--entry', '_initialize', '--stack-first', '-z', 'stack-size=262144', '--gc-sections',
    '--export=__stack_pointer', '--strip-debug', '--max-memory=134217728'], shared, { 'answer.o': answer, imports }, 'linked');
