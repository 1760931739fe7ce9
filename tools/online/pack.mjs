// Files as one: the length of a list, the list [[path, size]…] as JSON, and all bytes.
import { joined } from '../play/wasm.mjs';

const encoder = new TextEncoder(), decoder = new TextDecoder();

export function pack(files) {
  const list = encoder.encode(JSON.stringify(files.map(([path, bytes]) => [path, bytes.length])));
  return joined([new Uint8Array(new Uint32Array([list.length]).buffer), list, ...files.map(([, bytes]) => bytes)]);
}

export function unpack(all) {
  const size = new DataView(all.buffer, all.byteOffset).getUint32(0, true);
  let at = 4 + size;
  return JSON.parse(decoder.decode(all.subarray(4, at))).map(([path, length]) => [path, all.subarray(at, (at += length))]);
}
