// `npm run api`: pages of the core's public headers by Doxygen, in build/api/html; a warning is an error.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { exitWith, run, TOP } from './lib/run.mjs';
import { installDebianPackages } from './setup.mjs';

const FOLDER = join(TOP, 'build/api');

/** The works of core/references.bib as a page with an anchor for each. */
function referencesPage(bibliography) {
  const works = bibliography.split(/^@/m).slice(1).map(readWork);
  const rows = works.map(({ key, author, title, year, where }) => {
    const source = where === '' ? '' : `, ${where}`;
    return `\\anchor bib_${key} **${author}**: *${title}*${source}, ${year}.`;
  });
  return `# References {#references}\n\n${rows.join('\n\n')}\n`;
}

function readWork(entry) {
  const field = (name) => {
    const value = entry.match(new RegExp(`^\\s*${name}\\s*=\\s*\\{(.*)\\},?$`, 'm'))?.[1] ?? '';
    return value.replace(/[{}]|\\(?=&)/g, '').replace(/\\"|\\'|\\AA/g, '');
  };
  return {
    key: entry.match(/\{([^,]+),/)?.[1] ?? '',
    author: field('author'),
    title: field('title'),
    year: field('year'),
    where: field('journal') || field('booktitle') || field('publisher') || field('school'),
  };
}

async function main() {
  // Nothing else needs it.
  await installDebianPackages(['doxygen']);
  rmSync(FOLDER, { recursive: true, force: true });
  mkdirSync(FOLDER, { recursive: true });
  const bibliography = readFileSync(join(TOP, 'core/references.bib'), 'utf8');
  writeFileSync(join(FOLDER, 'references.md'), referencesPage(bibliography));
  await run('doxygen', ['docs/Doxyfile']);
  console.log('build/api/html/index.html');
}

main().catch(exitWith);
