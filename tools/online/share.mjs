// A sketch as one page that needs nothing else, to send to a friend: as `./course sketch --share` writes it.
const base = new URL('.', document.currentScript.src), site = new URL('../..', base);

const text = async (address) => (await fetch(address)).text();
const ofSite = (name) => text(new URL(name, site)), ours = (section) => text(new URL(`ours_${section}.js`, base));
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

// sections: those whose functions it calls
export async function sharedPage(title, module, sections) {
  const style = (await Promise.all(['site.css', 'play.css'].map(ofSite))).join('').replace(/@font-face \{[^}]*\}\n?/g, ''), mine = await answersOf(sections);
  const scripts = await Promise.all([ofSite('theme.js'), ...sections.map(ours), ...['draw.js', 'answers.js', 'play.js'].map(ofSite)]);
  const playable = { sketch: await packed(module), ...(Object.keys(mine).length > 0 && { 'sketch/mine': mine }) };
  const data = `self.playable = ${JSON.stringify(playable)};\nself.progress = ${JSON.stringify({ sections: self.progress?.sections ?? [] })};\n`;
  return `<!DOCTYPE html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escaped(title)}</title>
<style>
${style}main { padding-top: 0; }
</style>
<main>
<figure class="play" id="demo" data-demo="sketch" data-mine><figcaption>${escaped(title)}</figcaption></figure>
<p class="above">I wrote this with <em>Frame by Frame</em>, a course in game physics.</p>
</main>
${script(data)}${scripts.map(script).join('')}</html>
`;
}
