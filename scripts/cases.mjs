// `npm run cases -- [--command FILE] [--quick] [NAME...]`: every sketch and model of ../shared/cases must end as the table
// beside them says (scripts/lib/case-rows.mjs), and `check` must say the same as `solve`. `--quick` searches hardly at all
// and asks only that nothing breaks, of ../shared/sketches too: for builds that are slow, as `npm run asan` makes one.
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { SKETCH_ROWS } from './lib/case-rows.mjs';
import { compareChecked } from './lib/fuzz-case.mjs';
import { commandDoor } from './lib/fuzz-doors.mjs';
import { readyCommand } from './lib/ready-command.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';

const SHARED = resolve(TOP, '../shared');
const SKETCH = '.sketch.json';
const MODEL = '.model.json';
const QUICK = { effort: '0.05', rounds: '0' };

const { values: options, positionals } = parseArgs({
  options: { command: { type: 'string' }, quick: { type: 'boolean', default: false } },
  allowPositionals: true,
});

/** @returns {{ name: string, text: string }[]} the files of a folder that end so, those that are asked for. */
function filesOf(folder, ending) {
  const wanted = (name) => positionals.length === 0 || positionals.includes(name);
  return readdirSync(resolve(SHARED, folder))
    .filter((file) => file.endsWith(ending))
    .map((file) => ({ name: file.slice(0, -ending.length), file: resolve(SHARED, folder, file) }))
    .filter(({ name }) => wanted(name))
    .map(({ name, file }) => ({ name, text: readFileSync(file, 'utf8') }));
}

/** How a sketch ended, and all that was said of it. */
async function outcomeOf(door, { text }) {
  const settings = { preset: 'simple', set: options.quick ? QUICK : {} };
  const solved = await door.solve(JSON.parse(text), settings);
  if (solved === null) {
    return { ends: 'refused', said: [door.lastRefusal()] };
  }
  const { report, modelText } = solved;
  compareChecked(report, await door.check(modelText, 'the model'));
  const said = [...report.notes, ...report.problems].map(({ message }) => message);
  const pieces = report.items.map(({ detail }) => detail).join('; ');
  return {
    ends: report.buildable ? 'buildable' : 'not buildable',
    said: [...said, pieces],
    seconds: report.seconds.processor,
  };
}

function compare({ ends, said }, row = { ends: 'buildable' }) {
  if (ends !== row.ends) {
    throw new Error(`is ${ends}, expected ${row.ends}: ${said[0]?.slice(0, 200) ?? ''}`);
  }
  if (row.says && !said.some((sentence) => row.says.test(sentence))) {
    throw new Error(`says nothing like ${row.says}, but: ${said.join(' | ').slice(0, 400)}`);
  }
}

async function tryAll(door) {
  const failed = [];
  const counts = {};
  const attempt = async (name, work) => {
    try {
      const { ends, seconds } = await work();
      counts[ends] = (counts[ends] ?? 0) + 1;
      console.log(
        `${name}: ${ends}${seconds === undefined ? '' : `, ${seconds.toFixed(1)} s of one core`}`,
      );
    } catch (error) {
      failed.push(name);
      console.error(`${name}: ${error.message}`);
    }
  };
  for (const sketch of filesOf('cases/sketches', SKETCH)) {
    await attempt(sketch.name, async () => {
      const outcome = await outcomeOf(door, sketch);
      if (!options.quick) {
        compare(outcome, SKETCH_ROWS[sketch.name]);
      }
      return outcome;
    });
  }
  for (const sketch of options.quick ? filesOf('sketches', SKETCH) : []) {
    await attempt(sketch.name, () => outcomeOf(door, sketch));
  }
  for (const { name, text } of filesOf('cases/models', MODEL)) {
    await attempt(name, async () => {
      const report = await door.check(text, name);
      return { ends: report === null ? 'model refused' : 'model judged' };
    });
  }
  return { failed, counts };
}

async function main() {
  const command = await readyCommand(options.command);
  const folder = mkdtempSync(join(tmpdir(), 'liftarm-cases-'));
  try {
    const { failed, counts } = await tryAll(commandDoor(command, folder));
    const told = Object.entries(counts).map(([what, count]) => `${count} ${what}`);
    console.log(`${told.join(', ')}; ${failed.length} not as they should be`);
    if (failed.length > 0) {
      throw new StepError(`not as they should be: ${failed.join(', ')}`);
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

main().catch(exitWith);
