// What Doxygen reads in place of a header: `\cite key` becomes a link into the page of references, which
// scripts/api.mjs makes of core/references.bib. Doxygen's own way needs a TeX installation.
import { readFileSync } from 'node:fs';

const text = readFileSync(process.argv[2], 'utf8');
const linked = text.replace(/\\cite(\s+(?:\/\/! )?)(\w+)/g, (_, gap, key) => {
  const [author, year] = key.split('_');
  const name = `${author.charAt(0).toUpperCase()}${author.slice(1)} ${year}`;
  return `${gap}\\ref bib_${key} "${name}"`;
});
process.stdout.write(linked);
