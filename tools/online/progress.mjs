// What a task of the checker's is doing, in a line and a bar.
const megabytes = (bytes) => (bytes / 1e6).toFixed(1);
const steps = { load: 'Loading the compiler', compile: 'Compiling', link: 'Linking', test: 'Running the tests' };

export function showProgress({ step: line, bar }, { step, loaded, total }) {
  line.hidden = false;
  bar.hidden = step !== 'load';
  line.textContent = step === 'load' ? `${steps.load}, this once: ${megabytes(loaded)} of ${megabytes(total)} MB` : `${steps[step]} …`;
  if (step === 'load') Object.assign(bar, { max: total, value: loaded });
}
