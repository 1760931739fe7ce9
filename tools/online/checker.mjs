// The page's side of worker.mjs.

export function howItWent(records) {
  const hints = {};
  for (const name of records.flatMap((record) => Object.keys(record.hints ?? {}))) {
    const [number] = name.split(' ');
    hints[number] = (hints[number] ?? 0) + 1;
  }
  return { attempts: records.flatMap(({ attempts }) => attempts ?? []), hints };
}

export class Checker {
  #base;
  #worker;
  #waiting = new Map(); // checks that run, by number
  #number = 0;

  // base: the address of the folder that worker.js and manifest.json are in, with a slash at its end
  constructor(base) {
    this.#base = base;
  }

  // Judges an exercise, or all of a section's ('').
  // progress: called with { step: 'load', loaded, total } in bytes, or { step: 'compile' | 'link' }, or { step: 'test', module: what is tested, as bytes }
  check({ section, exercise, text, progress }) {
    return this.#ask({ section, exercise, text }, progress);
  }
  // Compiles a sketch: { module, as bytes }, or as a check says that it can't: { text, place }.
  sketch({ text, progress }) {
    return this.#ask({ text }, progress);
  }
  // How it went, by the store's records, as `./course feedback` writes it: { text }; '' if nothing was checked.
  async feedback(records) {
    const told = howItWent(records);
    return told.attempts.length > 0 ? this.#ask(told) : { text: '' };
  }

  #ask(task, progress = () => {}) {
    this.#worker ??= this.#start();
    const id = ++this.#number;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject, progress });
      this.#worker.postMessage({ id, ...task });
    });
  }

  // Ends what runs; the next check loads all of it again, from the browser's cache.
  stop() {
    this.#worker?.terminate();
    this.#worker = undefined;
    this.#endAll(new DOMException('Stopped.', 'AbortError'));
  }

  #start() {
    const worker = new Worker(new URL('worker.js', this.#base), { type: 'module' });
    worker.addEventListener('message', ({ data }) => this.#hear(data));
    worker.addEventListener('error', (event) => {
      this.#worker = undefined;
      this.#endAll(new Error(event.message || 'The checker could not be started.'));
    });
    return worker;
  }
  #hear({ id, progress, result, error }) {
    const waiting = this.#waiting.get(id);
    if (!waiting) return;
    if (progress) return void waiting.progress(progress);
    this.#waiting.delete(id);
    if (error) waiting.reject(new Error(error));
    else waiting.resolve(result);
  }
  #endAll(error) {
    for (const { reject } of this.#waiting.values()) reject(error);
    this.#waiting.clear();
  }
}
