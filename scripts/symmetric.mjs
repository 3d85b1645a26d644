// `npm run symmetric -- [SKETCHES] [options]`: confirms the symmetries that the core finds in a sketch, solves it with
// and without them, and prints how symmetric the models are and what that costs.
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { sketchFiles, sketchName, solve, wholeNumber } from './lib/solve.mjs';
import { median } from './lib/statistics.mjs';
import { withSymmetries } from './lib/symmetric-sketch.mjs';

const COMMAND = resolve(TOP, 'build/native/liftarm');
const USAGE = `npm run symmetric -- [SKETCHES] [options]
  --seeds N      seeds 1 to N for each sketch (default 3)
  --confirm W    mirrors across principal planes (default), or all that was found`;

function runs(sketch, seeds) {
  return Array.from({ length: seeds }, (_, i) =>
    solve(COMMAND, { sketch, args: ['--seed', String(i + 1)], timeoutMs: 600_000 }),
  ).filter((report) => report !== null);
}

function main() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      seeds: { type: 'string', default: '3' },
      confirm: { type: 'string', default: 'mirrors' },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help || !['mirrors', 'all'].includes(values.confirm)) {
    throw new StepError(USAGE);
  }
  const seeds = wholeNumber('seeds', values.seeds);
  console.log(
    'sketch               found  symmetric  buildable  beams  without  largest  uneven  processor',
  );
  for (const file of sketchFiles(positionals)) {
    const { file: sketch, found } = withSymmetries(COMMAND, file, values.confirm);
    if (found === 0) {
      continue;
    }
    const withThem = runs(sketch, seeds);
    const without = runs(file, seeds);
    const count = (test) => `${withThem.filter(test).length}/${seeds}`;
    console.log(
      [
        sketchName(file).padEnd(20),
        String(found).padStart(5),
        count((r) => r.symmetryDeviation === 0).padStart(10),
        count((r) => r.buildable).padStart(10),
        String(median(withThem.map((r) => r.beams))).padStart(6),
        String(median(without.map((r) => r.beams))).padStart(8),
        Math.max(...withThem.map((r) => r.symmetryDeviation))
          .toFixed(3)
          .padStart(8),
        String(median(withThem.map((r) => r.asymmetric?.length ?? -1))).padStart(7),
        median(withThem.map((r) => r.seconds.processor))
          .toFixed(2)
          .padStart(10),
      ].join(' '),
    );
  }
}

try {
  main();
} catch (error) {
  exitWith(error);
}
