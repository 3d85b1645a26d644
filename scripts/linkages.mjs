// `npm run linkages -- [options]`: asks for a linkage for each of fifty paths, and prints how far it is off, how long
// the answer takes once the table is there, and whether what is chosen is buildable and turns all the way round.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { linkagePaths, pathText } from './lib/linkage-paths.mjs';
import { loadLinkages } from './lib/load-linkages.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { wholeNumber } from './lib/solve.mjs';
import { median } from './lib/statistics.mjs';

const COMMAND = resolve(TOP, 'build/native/liftarm');
const USAGE = `npm run linkages -- [options]
  --seed N     of the thirty random curves (default 1)
  --solve N    of each path the best N are solved and checked (default 1; 0: none)
  --only TEXT  paths whose name has this in it`;

/** The share below which nine tenths of the values are. */
function ninetieth(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.ceil(0.9 * sorted.length) - 1];
}

/** Solves a sketch and checks the model that was written. */
function judge(sketch, folder) {
  const file = join(folder, 'path.sketch.json');
  writeFileSync(file, JSON.stringify(sketch));
  spawnSync(COMMAND, ['solve', file, '-o', folder], { encoding: 'utf8' });
  const checked = spawnSync(COMMAND, ['check', join(folder, 'path.model.json'), '--json'], {
    encoding: 'utf8',
    maxBuffer: 64 << 20,
  });
  const report = JSON.parse(checked.stdout);
  const [crank] = report.joints;
  return {
    buildable: report.buildable,
    turns: crank?.to - crank?.from >= 359.5,
    message: crank?.message,
  };
}

async function main() {
  const { values } = parseArgs({
    options: {
      seed: { type: 'string', default: '1' },
      solve: { type: 'string', default: '1' },
      only: { type: 'string', default: '' },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help) {
    throw new StepError(USAGE);
  }
  const most = values.solve === '0' ? 0 : wholeNumber('solve', values.solve);
  const begin = performance.now();
  const table = await loadLinkages();
  console.log(`table: ${((performance.now() - begin) / 1000).toFixed(2)} s`);
  const folder = mkdtempSync(join(tmpdir(), 'liftarm-linkages-'));
  const rows = [];
  const judged = [];
  for (const path of linkagePaths(Number(values.seed)).filter((p) =>
    p.name.includes(values.only),
  )) {
    const start = performance.now();
    const { ok, text } = table.find(pathText(path));
    const seconds = (performance.now() - start) / 1000;
    if (!ok) {
      throw new StepError(`${path.name}: ${text}`);
    }
    const { answers } = JSON.parse(text);
    const verdicts = answers.slice(0, most).map(({ sketch }) => judge(sketch, folder));
    judged.push(...verdicts);
    const error = answers[0]?.error ?? Number.POSITIVE_INFINITY;
    rows.push({ error, seconds });
    console.log(
      [
        path.name.padEnd(14),
        error.toFixed(2).padStart(6),
        (answers[0]?.largest ?? 0).toFixed(2).padStart(6),
        `${seconds.toFixed(3)} s`,
        (answers[0]?.links ?? []).join(' ').padEnd(20),
        verdicts
          .map(({ buildable, turns, message }) => (buildable && turns ? 'ok' : message))
          .join(', '),
      ].join('  '),
    );
  }
  rmSync(folder, { recursive: true });
  const errors = rows.map(({ error }) => error);
  const share = (test) => `${judged.filter(test).length} of ${judged.length}`;
  console.log(`paths: ${rows.length}`);
  console.log(
    `error: ${median(errors).toFixed(2)} mm at the median, ${ninetieth(errors).toFixed(2)} mm for 90 %`,
  );
  console.log(`answer: ${Math.max(...rows.map(({ seconds }) => seconds)).toFixed(2)} s at most`);
  console.log(
    `buildable: ${share((v) => v.buildable)}, turning all the way round: ${share((v) => v.turns)}`,
  );
}

try {
  await main();
} catch (error) {
  exitWith(error);
}
