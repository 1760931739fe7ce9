// A sketch as one page that needs nothing else, to send to a friend: as `./course sketch --share` writes it.
const base = new URL('.', document.currentScript.src);

const ours = async (section) => (await fetch(new URL(`ours_${section}.js`, base))).text();
const script = (code) => `<script>\n${code}</script>\n`;
const escaped = (words) => words.replaceAll('&', '&amp;').replaceAll('<', '&lt;');

async function packed(module) {
  const zipped = await new Response(new Blob([module]).stream().pipeThrough(new CompressionStream('gzip'))).blob();
  const url = await new Promise((done) => Object.assign(new FileReader(), { onload: ({ target }) => done(target.result) }).readAsDataURL(zipped));
  return url.slice(url.indexOf(',') + 1);
}
async function answersOf(sections) {
  const all = self.playable['sketch/mine'] ?? {}, names = sections.filter((name) => all[name]);
  return Object.fromEntries(await Promise.all(names.map(async (name) => [name, await packed(all[name])])));
}

// page: as the terminal writes it, without what is compiled; sections: those whose functions it calls
export async function sharedPage(page, title, module, sections) {
  const mine = await answersOf(sections), playable = { sketch: await packed(module), ...(Object.keys(mine).length > 0 && { 'sketch/mine': mine }) };
  const data = `self.playable = ${JSON.stringify(playable)};\nself.progress = ${JSON.stringify({ sections: self.progress?.sections ?? [] })};\n`;
  const scripts = [data, ...await Promise.all(sections.map(ours))].map(script).join('');
  return page.replace('<title>sketch</title>', () => `<title>${escaped(title)}</title>`).replace('<!-- compiled -->\n', () => scripts);
}
