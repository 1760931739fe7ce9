// The files that the compiler of pages reads, as they lie here: of npm's package, of Eigen and of the course.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = fileURLToPath(new URL('../..', import.meta.url));
const llvm = new URL('node_modules/@yowasp/clang/gen/', import.meta.url);

export const llvmProgram = () => fs.readFileSync(new URL('llvm.core.wasm', llvm));

// The stub of each section, as the editor gets them: ours, or those of a handout.
export const stubs = (from = root) => Object.fromEntries(sections().map((name) => [name, { stub: fs.readFileSync(path.join(from, 'tests', name, 'stub.cpp'), 'utf8') }]));
export const sections = () => fs.readdirSync(path.join(root, 'tests')).filter((name) => /^\d\d_/.test(name)).sort();

// Of the archive with the compiler's own headers and libraries: [path, bytes] pairs.
function* archived() {
  const bytes = fs.readFileSync(new URL('llvm-resources.tar', llvm));
  const text = (from, size) => bytes.toString('utf8', from, from + size).replace(/\0.*/s, '');
  for (let at = 0; text(at, 100); ) {
    const size = parseInt(text(at + 124, 12), 8), folder = text(at + 345, 155);
    const isFile = ['', '0'].includes(text(at + 156, 1));
    if (isFile) yield [path.posix.join('/usr', folder, text(at, 100)), new Uint8Array(bytes.subarray(at + 512, at + 512 + size))];
    at += 512 + Math.ceil(size / 512) * 512;
  }
}

function* below(folder, as, isWanted = () => true) {
  for (const entry of fs.readdirSync(folder, { withFileTypes: true, recursive: true }))
    if (entry.isFile() && isWanted(entry.name)) {
      const file = path.join(entry.parentPath ?? entry.path, entry.name);
      yield [path.posix.join(as, path.relative(folder, file)), new Uint8Array(fs.readFileSync(file))];
    }
}

// What no answer in a page needs: other machines' instructions, older and unfinished libraries.
const notForPages = /^\/usr\/(share|include\/(__clang_cuda|__clang_hip|__clang_hexagon|[^/]*intrin|cuda_wrappers|openmp_wrappers|opencl|ppc_wrappers|llvm_|hlsl|arm_|riscv|altivec)|include\/c\+\+\/v1\/(__cxx03|experimental))/;

export function compilerFiles() {
  return [...archived()].filter(([name]) => !notForPages.test(name));
}
export function courseFiles(eigen) {
  const isSource = (name) => /\.[ch]pp$|^__assertion_handler$/.test(name);
  const own = ['chapters', 'tools/base', 'tools/judge', 'tools/play/host', 'solutions', ...sections().map((name) => `tests/${name}`)].flatMap((folder) => [...below(path.join(root, folder), `/${folder}`, isSource)]);
  return [...own, ...below(path.join(eigen, 'Eigen'), '/eigen/Eigen'),
    ...['quick.hpp', 'student.hpp'].map((name) => [`/loop/${name}`, new Uint8Array(fs.readFileSync(path.join(root, 'tools/judge/server', name)))])];
}
