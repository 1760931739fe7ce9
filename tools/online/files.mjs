// Answers as files, as they lie in a clone of the course: exercises/08_nt_collisions.cpp, or a zip of those.
import { strToU8, unzipSync, zipSync } from 'fflate';
import { make } from './elements.mjs';

const largest = 1 << 20; // no answer has a megabyte

const sectionOf = (name) => name.match(/(?:^|[/\\])(\d\d_\w+)\.cpp$/)?.[1];

export function asZip(records) {
  const files = records.map(({ name, text }) => [`exercises/${name}.cpp`, strToU8(text)]);
  return zipSync(Object.fromEntries(files));
}

const asText = (bytes) => new TextDecoder('utf-8', { fatal: true }).decode(bytes).replace(/\r\n?/g, '\n');

// What is in these files, by section: { answers: [[section, text]], refused: ['what can’t be taken, and why'] }.
export async function read(files, stubs) {
  const answers = [], refused = [];
  const add = (name, bytes) => {
    const section = sectionOf(name);
    if (!section || !(section in stubs)) refused.push(`${name} belongs to no section: name it as in exercises/, like 08_nt_collisions.cpp`);
    else if (bytes.length > largest) refused.push(`${name} is larger than 1 MB, so it’s no answer`);
    else try {
      answers.push([section, asText(bytes)]);
    } catch {
      refused.push(`${name} is no text in UTF-8: save it as UTF-8, and open it again`);
    }
  };
  for (const file of files) {
    const bytes = new Uint8Array(await file.arrayBuffer());
    if (!/\.zip$/i.test(file.name)) add(file.name, bytes);
    else try {
      const inside = unzipSync(bytes, { filter: ({ name, originalSize }) => sectionOf(name) in stubs && originalSize <= largest });
      for (const [name, unpacked] of Object.entries(inside)) add(name, unpacked);
      if (Object.keys(inside).length === 0) refused.push(`${file.name} has no answer in it: there should be files like exercises/08_nt_collisions.cpp`);
    } catch (error) {
      refused.push(`${file.name} can’t be unpacked (${error.message})`);
    }
  }
  return { answers, refused };
}

export function download(name, content, type) {
  const link = make('a', { href: URL.createObjectURL(new Blob([content], { type })), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000); // once the browser has taken it
}
