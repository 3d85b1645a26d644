// `npm run scorer [-- --count N --faults M]`: whether scripts/score.py and `liftarm check` agree, on models of the first
// N sketches of the data set and on M models with a planted fault.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { dataset } from './lib/families/families.mjs';
import { FAULTS } from './lib/families/faults.mjs';
import { random } from './lib/random-sketches.mjs';
import { readyCommand } from './lib/ready-command.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { wholeNumber } from './lib/solve.mjs';

const USAGE = `npm run scorer [-- options]
  --count N      sketches of the data set that are solved and judged (default 48)
  --faults M     models with one planted fault that are judged as well (default 28)
  --effort E     of the search: a poor one leaves models that are not buildable (default 1)
  --command FILE the command to run (default build/native/liftarm, built first)`;
const WORK = resolve(TOP, 'build/scorer');
const ITEMS = ['realParts', 'interpenetration', 'connections', 'assembly', 'coverage'];
const BUFFER = 1 << 28;

function readOptions() {
  const { values } = parseArgs({
    options: {
      count: { type: 'string', default: '48' },
      faults: { type: 'string', default: '28' },
      effort: { type: 'string', default: '1' },
      command: { type: 'string' },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help) {
    throw new StepError(USAGE);
  }
  return {
    count: wholeNumber('count', values.count),
    faults: wholeNumber('faults', values.faults),
    effort: values.effort,
    command: values.command,
  };
}

/** Solves a sketch. @returns the file of its model */
function modelOf(command, { name, sketch }, effort) {
  const file = resolve(WORK, `${name}.sketch.json`);
  writeFileSync(file, JSON.stringify(sketch));
  const args = ['solve', file, '-o', WORK, '--json', '--set', `effort=${effort}`];
  const { status, stderr } = spawnSync(command, args, { encoding: 'utf8', maxBuffer: BUFFER });
  if (status !== 0 && status !== 2) {
    throw new StepError(`${name}: ${stderr}`);
  }
  return { name, file: resolve(WORK, `${name}.model.json`) };
}

/** A copy of a model with the fault of this number in it. */
function faulty(model, number) {
  const kinds = Object.keys(FAULTS);
  const kind = kinds[number % kinds.length];
  const name = `fault-${number + 1}`;
  const changed = FAULTS[kind](JSON.parse(readFileSync(model.file, 'utf8')), random(number + 1));
  const file = resolve(WORK, `${name}.model.json`);
  writeFileSync(file, JSON.stringify(changed));
  return { name: `${name} (${model.name}: ${kind})`, file };
}

/** Which items hold by \`liftarm check\`. */
function checked(command, file) {
  const { status, stdout, stderr } = spawnSync(command, ['check', file, '--json'], {
    encoding: 'utf8',
    maxBuffer: BUFFER,
  });
  if (status !== 0 && status !== 2) {
    throw new StepError(`liftarm check ${file}: ${stderr}`);
  }
  const { items } = JSON.parse(stdout);
  return Object.fromEntries(ITEMS.map((id) => [id, items.find((item) => item.id === id).ok]));
}

/** What the scorer says of each file, in their order. */
function scored(partsFile, files) {
  const script = resolve(TOP, 'scripts/score.py');
  const args = [script, '--parts', partsFile, ...files];
  const { status, stdout, stderr } = spawnSync('python3', args, {
    encoding: 'utf8',
    maxBuffer: BUFFER,
  });
  if (status !== 0 && status !== 2) {
    throw new StepError(`score.py: ${stderr}`);
  }
  return stdout
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line).items);
}

function compare(command, partsFile, models) {
  const found = scored(
    partsFile,
    models.map(({ file }) => file),
  );
  let agreed = 0;
  let valid = 0;
  models.forEach(({ name, file }, i) => {
    const ours = checked(command, file);
    const apart = ITEMS.filter((id) => ours[id] !== (found[i][id] === 0));
    agreed += apart.length === 0 ? 1 : 0;
    valid += ITEMS.every((id) => ours[id]) ? 1 : 0;
    for (const id of apart) {
      console.log(
        `${name}: ${id}: liftarm ${ours[id] ? 'holds' : 'fails'}, score.py ${found[i][id]}`,
      );
    }
  });
  return { agreed, valid };
}

async function main() {
  const { count, faults, effort, command: named } = readOptions();
  const command = await readyCommand(named);
  rmSync(WORK, { recursive: true, force: true });
  mkdirSync(WORK, { recursive: true });
  const partsFile = resolve(WORK, 'parts.json');
  writeFileSync(partsFile, execFileSync(command, ['parts'], { maxBuffer: BUFFER }));
  const models = dataset(count).map((one) => modelOf(command, one, effort));
  const good = compare(command, partsFile, models);
  console.log(
    `${good.agreed} of ${count} models judged alike, ${good.valid} of them without fault`,
  );
  const planted = Array.from({ length: faults }, (_, i) => faulty(models[i % models.length], i));
  const bad = compare(command, partsFile, planted);
  console.log(
    `${bad.agreed} of ${faults} planted faults judged alike, ${faults - bad.valid} of them are faults`,
  );
  if (good.agreed < count || bad.agreed < faults) {
    process.exitCode = 1;
  }
}

main().catch(exitWith);
