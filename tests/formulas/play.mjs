// Runs formulas.cpp as a page would, which throws nothing.
import {readFileSync} from 'node:fs';
import {WASI} from 'node:wasi';

const wasi = new WASI({version: 'preview1', returnOnExit: true});
const module = new WebAssembly.Module(readFileSync(process.argv[2]));
const env = new Proxy({}, {get: (_, name) => () => { throw new Error(name); }});
process.exit(wasi.start(new WebAssembly.Instance(module, {wasi_snapshot_preview1: wasi.wasiImport, env})));
