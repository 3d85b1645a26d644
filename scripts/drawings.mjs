// `npm run drawings [-- NAME...]`: writes the gallery's larger drawings, which programs draw (scripts/drawings/), into
// public/gallery. `npm run gallery` then solves them, and draws their pictures.
import { writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { DRAWINGS } from './drawings/list.mjs';
import { sketchText } from './drawings/pen.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';

function main() {
  const names = process.argv.slice(2);
  const unknown = names.find((name) => !(name in DRAWINGS));
  if (unknown !== undefined) {
    throw new StepError(`no drawing '${unknown}'; there are ${Object.keys(DRAWINGS).join(', ')}`);
  }
  for (const [name, draw] of Object.entries(DRAWINGS)) {
    if (names.length === 0 || names.includes(name)) {
      const sketch = draw();
      writeFileSync(resolve(TOP, `public/gallery/${name}.sketch.json`), sketchText(sketch));
      console.log(`${name.padEnd(16)} ${String(sketch.lines.length).padStart(4)} lines`);
    }
  }
}

try {
  main();
} catch (error) {
  exitWith(error);
}
