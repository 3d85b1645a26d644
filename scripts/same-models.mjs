// `npm run same-models -- OLD_COMMAND NEW_COMMAND SKETCHES...`: solves sketches with two builds of the command and
// compares the models byte for byte: a change of the code that is to change no model is proved by it.
import { spawnSync } from 'node:child_process';
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { exitWith, StepError } from './lib/run.mjs';
import { sketchFiles, sketchName, wholeNumber } from './lib/solve.mjs';

const USAGE = `npm run same-models -- OLD_COMMAND NEW_COMMAND [SKETCHES...] [options]
  SKETCHES       files, folders, or names in ../shared/sketches; none: all of those
  --presets A,B  (default balanced,simple,simple-rigid)
  --seeds N      seeds 1 to N (default 1)
  --set k=v      handed to both; can be repeated
  --timeout S    seconds after which a run is stopped and left out (default 600)
  --keep DIR     keeps what OLD_COMMAND makes there, and takes it from there the next time
Ends with 1 where a model differs, or where nothing was compared.`;

function readOptions() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      presets: { type: 'string', default: 'balanced,simple,simple-rigid' },
      seeds: { type: 'string', default: '1' },
      set: { type: 'string', multiple: true, default: [] },
      timeout: { type: 'string', default: '600' },
      keep: { type: 'string' },
      help: { type: 'boolean', default: false },
    },
  });
  const [before, after, ...names] = positionals;
  if (values.help || after === undefined) {
    throw new StepError(USAGE);
  }
  for (const command of [before, after]) {
    if (!existsSync(command)) {
      throw new StepError(`${command}: no such command`);
    }
  }
  return {
    commands: [resolve(before), resolve(after)],
    sketches: sketchFiles(names.flatMap(inFolder)),
    presets: values.presets.split(','),
    seeds: wholeNumber('seeds', values.seeds),
    passed: values.set.flatMap((pair) => ['--set', pair]),
    timeoutMs: wholeNumber('timeout', values.timeout) * 1000,
    keep: values.keep === undefined ? null : resolve(values.keep),
  };
}

/** The sketches of a folder, or the name itself. */
function inFolder(name) {
  if (!existsSync(name) || !statSync(name).isDirectory()) {
    return [name];
  }
  return readdirSync(name)
    .filter((file) => file.endsWith('.sketch.json'))
    .sort()
    .map((file) => join(name, file));
}

/**
 * What a build of the command makes of a sketch.
 * @returns {{text: string, seconds: number} | null} the model's bytes, or what the command said where it wrote
 *     none; null when it took too long.
 */
export function modelOf(command, { sketch, args, timeoutMs }) {
  const folder = mkdtempSync(join(tmpdir(), 'liftarm-same-'));
  try {
    const begin = performance.now();
    const { signal, status, stderr } = spawnSync(
      command,
      ['solve', sketch, '-o', folder, '--json', ...args],
      { encoding: 'utf8', maxBuffer: 64 << 20, timeout: timeoutMs, killSignal: 'SIGKILL' },
    );
    if (signal === 'SIGKILL') {
      return null;
    }
    const file = readdirSync(folder).find((name) => name.endsWith('.model.json'));
    const text =
      file === undefined ? `${status} ${stderr}` : readFileSync(join(folder, file), 'utf8');
    return { text, seconds: (performance.now() - begin) / 1000 };
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

/** `make()`, or what it gave the last time, from a folder. */
function kept(folder, name, make) {
  if (folder === null) {
    return make();
  }
  const file = join(folder, `${name}.json`);
  if (existsSync(file)) {
    return JSON.parse(readFileSync(file, 'utf8'));
  }
  const model = make();
  mkdirSync(folder, { recursive: true });
  writeFileSync(file, JSON.stringify(model));
  return model;
}

/** What is to be solved: every sketch with every preset and seed. */
function* pairs({ sketches, presets, seeds, passed }) {
  for (const sketch of sketches) {
    for (const preset of presets) {
      for (let seed = 1; seed <= seeds; ++seed) {
        const title = `${sketchName(sketch)}, preset ${preset}, seed ${seed}`;
        yield { sketch, title, args: ['--preset', preset, '--seed', `${seed}`, ...passed] };
      }
    }
  }
}

/** Whether two runs came to the same. */
function verdict(before, after) {
  if (before === null || after === null) {
    return 'stopped';
  }
  return before.text === after.text ? 'same' : 'different';
}

/** Solves everything with both; prints one line for each model that is not the same. */
function compare(options) {
  const { commands, timeoutMs, keep } = options;
  const counts = { same: 0, different: 0, stopped: 0 };
  const seconds = [0, 0];
  for (const { sketch, title, args } of pairs(options)) {
    const name = [sketchName(sketch), ...args].join(' ').replaceAll('/', '_');
    const models = [
      kept(keep, name, () => modelOf(commands[0], { sketch, args, timeoutMs })),
      modelOf(commands[1], { sketch, args, timeoutMs }),
    ];
    const kind = verdict(...models);
    counts[kind] += 1;
    if (kind !== 'same') {
      console.log(`${kind}: ${title}`);
    }
    for (const [i, model] of models.entries()) {
      seconds[i] += model?.seconds ?? 0;
    }
  }
  return { counts, seconds };
}

function main() {
  const { counts, seconds } = compare(readOptions());
  const [before, after] = seconds.map((sum) => sum.toFixed(1));
  console.log(
    `${counts.same} models the same, ${counts.different} different, ${counts.stopped} stopped; ` +
      `${before} s before, ${after} s after`,
  );
  process.exitCode = counts.different > 0 || counts.same === 0 ? 1 : 0;
}

try {
  main();
} catch (error) {
  exitWith(error);
}
