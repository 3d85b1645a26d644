// `npm run fuzz -- --minutes N [--from SEED] [--jobs J] [--motions M] [--command FILE]`: solves random sketches, checks the models,
// moves them as rigid bodies and checks again. What must hold: no crash, no hang, exit 0, 1 or 2 with one message for
// 1; solve and check agree; a verdict does not depend on place and turn; what is called buildable stays so; a sketch
// comes back from its link, a model from its .mpd file. Seeds run
// from SEED on, so that a find comes again; inputs that fail are kept in build/fuzz-finds/. Ends with 1 where any did.
import { spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { fuzzCase, rigidMotion } from './lib/fuzz-cases.mjs';
import { movedModel } from './lib/fuzz-motion.mjs';
import { compareLink, compareMpd, loadReaders } from './lib/fuzz-round-trips.mjs';
import { readyCommand } from './lib/ready-command.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { wholeNumber } from './lib/solve.mjs';

const FINDS = resolve(TOP, 'build/fuzz-finds');
const HANG_MS = 180_000;
const ANGLE = 0.5; // degrees between two ranges of one joint

const { values: options } = parseArgs({
  options: {
    minutes: { type: 'string', default: '1' },
    from: { type: 'string', default: '1' },
    jobs: { type: 'string', default: '2' },
    count: { type: 'string' },
    motions: { type: 'string', default: '1' },
    command: { type: 'string' },
  },
});

function run(command, args) {
  return new Promise((done) => {
    const child = spawn(command, args, { timeout: HANG_MS, killSignal: 'SIGKILL' });
    let [out, err] = ['', ''];
    child.stdout.on('data', (text) => (out += text));
    child.stderr.on('data', (text) => (err += text));
    child.on('error', (error) => done({ code: -1, out, err: error.message }));
    child.on('close', (code, signal) => done({ code, signal, out, err }));
  });
}

/** @throws {Error} where the command did not end as it must. */
function answerOf({ code, signal, out, err }, what) {
  if (signal !== null || code === null || code < 0 || code > 2) {
    throw new Error(`${what}: ended with ${signal ?? `code ${code}`}: ${err.slice(0, 500)}`);
  }
  if (code === 1 && (out !== '' || err.trim().split('\n').length !== 1)) {
    throw new Error(`${what}: refused with other than one line: ${err.slice(0, 500)}`);
  }
  return code === 1 ? null : JSON.parse(out);
}

/** What two reports on one model must agree in. */
function verdictOf(report) {
  const items = report.items.map(({ id, ok }) => `${id} ${ok}`);
  return [...items, `collisions ${report.collisions}`, `uncovered ${report.uncovered}`].join(', ');
}

function sameJoints(a, b) {
  return (a.joints ?? []).every((joint, i) => {
    const other = b.joints?.[i];
    return (
      joint.turns === other?.turns &&
      Math.abs((joint.from ?? 0) - (other?.from ?? 0)) <= ANGLE &&
      Math.abs((joint.to ?? 0) - (other?.to ?? 0)) <= ANGLE
    );
  });
}

function compareChecked(solved, checked) {
  if (solved.buildable && !checked.buildable) {
    throw new Error(`solve says buildable, check not: ${JSON.stringify(checked.problems)}`);
  }
  const items = (report) => report.items.map(({ id, ok }) => `${id} ${ok}`).join(', ');
  if (items(solved) !== items(checked)) {
    throw new Error(`solve: ${items(solved)}; check: ${items(checked)}`);
  }
}

function compareMoved(checked, moved) {
  if (checked.buildable !== moved.buildable || verdictOf(checked) !== verdictOf(moved)) {
    throw new Error(`before the motion: ${verdictOf(checked)}; after: ${verdictOf(moved)}`);
  }
  if (!sameJoints(checked, moved)) {
    throw new Error(
      `joints before: ${JSON.stringify(checked.joints)}; after: ${JSON.stringify(moved.joints)}`,
    );
  }
}

/** Solves, checks, moves and checks one seed. @returns what came of it. */
async function tryCase({ command, readers, motions }, seed, folder) {
  const { sketch, args } = fuzzCase(seed);
  const file = (name) => join(folder, `${seed}.${name}`);
  writeFileSync(file('sketch.json'), JSON.stringify(sketch));
  const solved = answerOf(
    await run(command, ['solve', file('sketch.json'), '-o', folder, '--json', ...args]),
    'solve',
  );
  if (solved === null) {
    return 'refused';
  }
  const check = async (name) =>
    answerOf(await run(command, ['check', file(name), '--json']), `check of ${name}`);
  const checked = await check('model.json');
  if (checked === null) {
    throw new Error('check refuses the model that solve wrote');
  }
  compareChecked(solved, checked);
  await compareLink(readers, sketch);
  const model = JSON.parse(readFileSync(file('model.json'), 'utf8'));
  compareMpd(readers, model, readFileSync(file('mpd'), 'utf8'));
  for (let motion = 0; motion < motions; ++motion) {
    const way = rigidMotion(seed + 1e6 * motion, model.sketch);
    writeFileSync(file('moved.json'), JSON.stringify(movedModel(model, way)));
    const moved = await check('moved.json');
    if (moved === null) {
      throw new Error(`check refuses the model after motion ${motion}`);
    }
    try {
      compareMoved(checked, moved);
    } catch (error) {
      throw new Error(`motion ${motion}: ${error.message}`);
    }
  }
  return solved.buildable ? 'buildable' : 'not buildable';
}

function keep(seed, error) {
  const { sketch, args } = fuzzCase(seed);
  mkdirSync(FINDS, { recursive: true });
  writeFileSync(join(FINDS, `${seed}.sketch.json`), JSON.stringify(sketch));
  writeFileSync(join(FINDS, `${seed}.txt`), `${args.join(' ')}\n${error.message}\n`);
  console.error(`seed ${seed}: ${error.message.slice(0, 400)}`);
}

async function main() {
  const command = await readyCommand(options.command);
  const end = performance.now() + 60_000 * Number(options.minutes);
  const first = wholeNumber('from', options.from);
  const last = options.count ? first + wholeNumber('count', options.count) : Infinity;
  const folder = mkdtempSync(join(tmpdir(), 'liftarm-fuzz-'));
  const motions = wholeNumber('motions', options.motions);
  const means = { command, motions, readers: await loadReaders() };
  const counts = { buildable: 0, 'not buildable': 0, refused: 0, failed: 0 };
  let next = first;
  const work = async () => {
    while (performance.now() < end && next < last) {
      const seed = next++;
      const mine = join(folder, `${seed}`);
      mkdirSync(mine);
      try {
        counts[await tryCase(means, seed, mine)] += 1;
      } catch (error) {
        counts.failed += 1;
        keep(seed, error);
      }
      rmSync(mine, { recursive: true });
    }
  };
  try {
    await Promise.all(Array.from({ length: wholeNumber('jobs', options.jobs) }, work));
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
  const told = Object.entries(counts).map(([what, count]) => `${count} ${what}`);
  const moved = motions * (counts.buildable + counts['not buildable']);
  console.log(
    `seeds ${first} to ${next - 1}: ${told.join(', ')}; ${moved} rigid motions changed no verdict`,
  );
  if (counts.failed > 0) {
    throw new StepError(`${counts.failed} failed; they are in build/fuzz-finds/`);
  }
}

main().catch(exitWith);
