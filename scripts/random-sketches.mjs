// `npm run random-sketches`: writes sketches made by a seeded generator, to see what the search does with
// drawings that nobody tuned it to: `npm run evaluate -- build/random`.
import { mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join, relative, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { randomSketch } from './lib/random-sketches.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { wholeNumber } from './lib/solve.mjs';

const USAGE = `npm run random-sketches [-- options]
  --count N   how many (default 140, ten of each kind)
  --first N   number of the first one (default 1); a number is always the same sketch
  --out DIR   default build/random; emptied first`;

function main() {
  const { values } = parseArgs({
    options: {
      count: { type: 'string', default: '140' },
      first: { type: 'string', default: '1' },
      out: { type: 'string', default: 'build/random' },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help) {
    throw new StepError(USAGE);
  }
  const [count, first] = [wholeNumber('count', values.count), wholeNumber('first', values.first)];
  const folder = resolve(TOP, values.out);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  for (let number = first; number < first + count; ++number) {
    const { name, sketch } = randomSketch(number);
    writeFileSync(join(folder, `${name}.sketch.json`), JSON.stringify(sketch));
  }
  console.log(`${count} sketches in ${relative(process.cwd(), folder) || folder}`);
}

try {
  main();
} catch (error) {
  exitWith(error);
}
