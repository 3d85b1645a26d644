// `npm run fuzz -- --minutes N [--from SEED] [--count N] [--jobs J] [--motions M] [--small] [--module | --command FILE]`:
// solves random sketches, checks the models, moves them as rigid bodies and checks again. What must hold: no crash, no
// hang, one message where input is refused; solve and check agree; a verdict does not depend on place and turn; what is
// called buildable stays so; a sketch comes back from its link, a model from its .mpd file. Seeds run from SEED on, so that
// a find comes again; inputs that fail are kept in build/fuzz-finds/. `--module` asks the page's module (build/wasm) instead
// of the command and gives up every tenth search first; with `--small`, sketches of up to four lines, it tries hundreds a
// minute. Ends with 1 where anything failed.
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { Worker } from 'node:worker_threads';
import { tryCase } from './lib/fuzz-case.mjs';
import { argumentsOf, fuzzCase } from './lib/fuzz-cases.mjs';
import { commandDoor, HANG_MS } from './lib/fuzz-doors.mjs';
import { loadReaders } from './lib/fuzz-round-trips.mjs';
import { readyCommand } from './lib/ready-command.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { wholeNumber } from './lib/solve.mjs';

const FINDS = resolve(TOP, 'build/fuzz-finds');
const TELL_EVERY = 10_000; // seeds

const { values: options } = parseArgs({
  options: {
    minutes: { type: 'string', default: '1' },
    from: { type: 'string', default: '1' },
    jobs: { type: 'string', default: '2' },
    count: { type: 'string' },
    motions: { type: 'string', default: '1' },
    small: { type: 'boolean', default: false },
    module: { type: 'boolean', default: false },
    command: { type: 'string' },
  },
});
const isSmall = options.small;
const motions = wholeNumber('motions', options.motions);

function keep(seed, message) {
  const { sketch, settings } = fuzzCase(seed, { isSmall });
  mkdirSync(FINDS, { recursive: true });
  writeFileSync(join(FINDS, `${seed}.sketch.json`), JSON.stringify(sketch));
  writeFileSync(join(FINDS, `${seed}.txt`), `${argumentsOf(settings).join(' ')}\n${message}\n`);
  console.error(`seed ${seed}: ${message.slice(0, 400)}`);
}

/** The next seeds, one after the other, until time or count is up; what came of each is noted. */
function makeTally() {
  const end = performance.now() + 60_000 * Number(options.minutes);
  const first = wholeNumber('from', options.from);
  const last = options.count ? first + wholeNumber('count', options.count) : Infinity;
  const counts = { buildable: 0, 'not buildable': 0, refused: 0, failed: 0 };
  let next = first;
  const text = () =>
    `seeds ${first} to ${next - 1}: ` +
    Object.entries(counts)
      .map(([what, count]) => `${count} ${what}`)
      .join(', ');
  return {
    counts,
    text,
    next: () => (performance.now() < end && next < last ? next++ : null),
    note(seed, what, message) {
      counts[what] += 1;
      if (what === 'failed') {
        keep(seed, message);
      }
      if (Object.values(counts).reduce((a, b) => a + b) % TELL_EVERY === 0) {
        console.log(text());
      }
    },
  };
}

async function workWithCommand(tally) {
  const command = await readyCommand(options.command);
  const readers = await loadReaders();
  const one = async () => {
    const folder = mkdtempSync(join(tmpdir(), 'liftarm-fuzz-'));
    const means = { door: commandDoor(command, folder), readers, motions, isSmall };
    try {
      for (let seed = tally.next(); seed !== null; seed = tally.next()) {
        await tryCase(means, seed).then(
          (what) => tally.note(seed, what),
          (error) => tally.note(seed, 'failed', error.message),
        );
      }
    } finally {
      rmSync(folder, { recursive: true, force: true });
    }
  };
  return one;
}

/** One worker until there are no seeds, or until it hangs or dies. @returns whether seeds are left. */
function runWorker(tally) {
  const worker = new Worker(resolve(TOP, 'scripts/lib/fuzz-worker.mjs'), {
    workerData: { motions, isSmall },
  });
  return new Promise((done) => {
    let [current, watch] = [null, undefined];
    const end = (isLeft) => {
      clearTimeout(watch);
      worker.terminate().then(() => done(isLeft));
    };
    const lose = (message) => {
      if (current === null) {
        throw new StepError(`the worker of --module does not start: ${message}`);
      }
      tally.note(current, 'failed', message);
      end(true);
    };
    worker.on('message', ({ seed, what, message }) => {
      clearTimeout(watch);
      if (seed !== undefined) {
        tally.note(seed, what, message);
      }
      current = tally.next();
      if (current === null) {
        end(false);
        return;
      }
      watch = setTimeout(() => lose(`hangs for ${HANG_MS / 1000} s`), HANG_MS);
      worker.postMessage(current);
    });
    worker.on('error', (error) => lose(error.stack ?? `${error}`));
  });
}

async function workWithModule(tally) {
  await loadReaders(); // bundled once before workers ask for them
  return async () => {
    while (await runWorker(tally)) {
      // what hangs or dies takes its worker along; the next seeds get another
    }
  };
}

async function main() {
  const tally = makeTally();
  const work = await (options.module ? workWithModule : workWithCommand)(tally);
  await Promise.all(Array.from({ length: wholeNumber('jobs', options.jobs) }, work));
  const { counts } = tally;
  const moved = motions * (counts.buildable + counts['not buildable']);
  console.log(`${tally.text()}; ${moved} rigid motions changed no verdict`);
  if (counts.failed > 0) {
    throw new StepError(`${counts.failed} failed; they are in build/fuzz-finds/`);
  }
}

main().catch(exitWith);
