// `npm run shafts -- [options]`: gear trains in frames of their own between random pairs of parallel shafts: how many
// are found and built, whether their ratio is near enough, and how long it takes (docs/shafts.md). Needs build/native.
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { dice } from './lib/dice.mjs';
import { capture, exitWith, StepError, TOP } from './lib/run.mjs';
import { wholeNumber } from './lib/solve.mjs';
import { greatest, median } from './lib/statistics.mjs';

const USAGE = `npm run shafts -- [options]
  --count N      pairs (default 100)
  --seed N       of the pairs (default 1)
  --distance N   between two shafts at most, modules (default 24)
  --ratio N      at most, either way (default 20)`;

const TOLERANCE = 0.03;

/** What the command prints; null where it finds nothing or nothing buildable. */
function liftarm(...args) {
  const begun = performance.now();
  const { code, stdout, stderr } = capture(join(TOP, 'build/native/liftarm'), args);
  if (code !== 0 && code !== 2) {
    throw new StepError(`liftarm ${args.join(' ')}: ${stderr}`);
  }
  return { good: code === 0, text: stdout, seconds: (performance.now() - begun) / 1000 };
}

/** Ways between shafts are spread evenly over a disc, ratios evenly over their logarithm. */
function* pairs({ count, seed, distance, ratio }) {
  const random = dice(seed);
  const whole = () => Math.round((2 * random() - 1) * distance);
  for (let i = 0; i < count; ) {
    const way = [whole(), whole()];
    const wanted = ratio ** (2 * random() - 1);
    if (Math.hypot(...way) >= 1 && Math.hypot(...way) <= distance) {
      i++;
      yield { way, wanted };
    }
  }
}

function build({ way, wanted }, folder) {
  const found = liftarm(
    'train',
    '--ratio',
    String(wanted),
    '--json',
    '-o',
    folder,
    '--',
    ...way.map(String),
  );
  if (!found.good) {
    return { way, wanted, found };
  }
  const { ratio } = JSON.parse(found.text);
  const solved = liftarm('solve', join(folder, 'Gear-train.sketch.json'), '-o', folder, '--json');
  const checked = liftarm('check', join(folder, 'Gear-train.model.json'), '--json');
  const sketch = JSON.parse(readFileSync(join(folder, 'Gear-train.model.json'), 'utf8')).sketch;
  // The processor's: on a busy machine a search waits more than it works.
  const seconds = JSON.parse(solved.text).seconds.processor;
  return { way, wanted, found, solved, checked, ratio, seconds, drives: sketch.drives.length };
}

function lineOf({ way, wanted, found, solved, checked, ratio, seconds }) {
  const said = !found.good
    ? 'no train'
    : `${ratio.toFixed(3)}, ${solved.good ? 'built' : 'NOT BUILT'}, ${checked.good ? 'checked' : 'CHECK FAILS'}`;
  return `${way.join(', ')} at ${wanted.toFixed(3)}: ${said}, ${(seconds ?? found.seconds).toFixed(2)} s`;
}

function main() {
  const { values } = parseArgs({
    options: {
      count: { type: 'string', default: '100' },
      seed: { type: 'string', default: '1' },
      distance: { type: 'string', default: '24' },
      ratio: { type: 'string', default: '20' },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help) {
    throw new StepError(USAGE);
  }
  const folder = mkdtempSync(join(tmpdir(), 'shafts-'));
  try {
    const rows = [];
    const options = Object.fromEntries(
      ['count', 'seed', 'distance', 'ratio'].map((key) => [key, wholeNumber(key, values[key])]),
    );
    for (const pair of pairs(options)) {
      rows.push(build(pair, folder));
      console.log(lineOf(rows.at(-1)));
    }
    const share = (good) => `${rows.filter(good).length} of ${rows.length}`;
    const near = ({ ratio, wanted }) => Math.abs(ratio / wanted - 1) <= TOLERANCE;
    console.log(`train found: ${share(({ found }) => found.good)}`);
    console.log(`ratio within 3 %: ${share((row) => row.found.good && near(row))}`);
    console.log(
      `built, all checks green: ${share(({ solved, checked }) => solved?.good && checked.good)}`,
    );
    const seconds = rows.flatMap((row) => row.seconds ?? []);
    console.log(
      `seconds of the processor a model: ${median(seconds)?.toFixed(2)}, at most ${greatest(seconds)?.toFixed(2)}`,
    );
  } finally {
    rmSync(folder, { recursive: true });
  }
}

try {
  main();
} catch (error) {
  exitWith(error);
}
