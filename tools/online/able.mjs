// Whether this browser can compile and judge here; if not, why.

// A function with a `try` in it, as compiled code has them.
const withTry = Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 8, 1, 6, 0, 6, 64, 25, 11, 11);

export function whyNot() {
  if (location.protocol === 'file:') return 'a page that was opened as a file can’t start a compiler';
  const missing = [
    [!self.WebAssembly || !WebAssembly.validate(withTry), 'WebAssembly with exceptions'],
    [!self.Worker, 'workers'],
    [!self.indexedDB, 'a place to keep your code'],
    [!self.DecompressionStream, 'decompression'],
    [!self.BroadcastChannel, 'channels between tabs'],
  ].filter(([isMissing]) => isMissing).map(([, what]) => what);
  return missing.length > 0 ? `this browser has no ${missing.join(', no ')}` : '';
}
