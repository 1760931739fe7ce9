import { keepSite } from './keeping.mjs';
import { load } from './load.mjs';

const base = new URL('.', document.currentScript.src);

// A script that can't be had doesn't tell why.
const loadScript = (name) => import(new URL(name, base).href).catch(async (error) => {
  await load(new URL(name, base), 'the compiler');
  throw error;
});

// One task of the checker's at a time, whoever asked for it. The checker, and with it the compiler, comes with the first.
export const checks = {
  checker: null,
  running: null,
  // what: 'check', 'sketch' or 'feedback', as checker.mjs has them
  async run(what, task) {
    if (!this.checker) {
      const { Checker } = await loadScript('checker.js');
      this.checker ??= new Checker(base.href);
    }
    if (this.running) this.stop();
    const running = this.checker[what](task);
    this.running = running;
    try {
      const result = await running;
      keepSite(base);
      return result;
    } finally {
      if (this.running === running) this.running = null;
    }
  },
  stop() {
    this.checker?.stop();
    this.running = null;
  },
};
