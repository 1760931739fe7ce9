// What a page of the site gets in the online edition.

// Nothing comes from another host, and of what may run only WebAssembly is compiled on the page. Formulas and the editor
// have styles of their own, and the site's icon is a `data:`.
const policy = [
  "default-src 'self'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self' 'unsafe-inline'",
  "img-src 'self' data: blob:",
  "object-src 'none'",
  "base-uri 'self'", // 404.html has one
  "form-action 'none'",
].join('; ');

// The same page with the editor, if it has exercises, or else with ticks for what is done. They lie in this folder.
export function onlinePage(html, folder) {
  const charset = '<meta charset="utf-8">', end = '</head>';
  if (!html.includes(charset) || !html.includes(end)) throw new Error(`a page has no ${charset} or no ${end}: ${html.slice(0, 100)}`);
  const isExercise = /class="turn"[^>]* data-exercise=/.test(html);
  const scripts = isExercise
    ? `<link rel="stylesheet" href="${folder}/editor.css">\n<script src="${folder}/editor.js" defer></script>\n`
    : `<script src="${folder}/ticks.js" defer></script>\n`;
  return html.replace(charset, `${charset}\n<meta http-equiv="Content-Security-Policy" content="${policy}">`).replace(end, scripts + end);
}
