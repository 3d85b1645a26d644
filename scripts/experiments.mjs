// `npm run experiments [NAME...] [-- --quick]`: the paper's whole evaluation and ours, as docs/experiments/.
import { rmSync } from 'node:fs';
import { relative, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { writeExperiment, writeIndex } from './experiments/documents.mjs';
import { Laboratory } from './experiments/laboratory.mjs';
import { EXPERIMENTS } from './experiments/list.mjs';
import { readyCommand } from './lib/ready-command.mjs';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { wholeNumber } from './lib/solve.mjs';

const OWN = resolve(TOP, 'build/native/liftarm');

const USAGE = `npm run experiments [NAME...] [-- options]
  NAME           some of: ${EXPERIMENTS.map(({ name }) => name).join(', ')}; all for none
  --quick        a small part of each, in build/experiments/quick
  --seed N       seed of every run (default 1)
  --out DIR      default docs/experiments
  --command FILE the command to run (default build/native/liftarm, built first)`;

function readOptions() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      quick: { type: 'boolean', default: false },
      seed: { type: 'string', default: '1' },
      out: { type: 'string' },
      command: { type: 'string' },
      help: { type: 'boolean', default: false },
    },
  });
  const unknown = positionals.find((name) => !EXPERIMENTS.some((one) => one.name === name));
  if (values.help || unknown !== undefined) {
    throw new StepError(unknown === undefined ? USAGE : `no experiment '${unknown}'\n${USAGE}`);
  }
  const folder = values.quick ? 'build/experiments/quick' : 'docs/experiments';
  return {
    wanted: EXPERIMENTS.filter(
      ({ name }) => positionals.length === 0 || positionals.includes(name),
    ),
    quick: values.quick,
    seed: wholeNumber('seed', values.seed),
    out: values.out === undefined ? resolve(TOP, folder) : resolve(values.out),
    command: values.command,
  };
}

async function main() {
  const { wanted, quick, seed, out, command: named } = readOptions();
  const command = await readyCommand(named);
  if (quick) {
    rmSync(out, { recursive: true, force: true });
  }
  for (const experiment of wanted) {
    const laboratory = new Laboratory({ command, quick, seed });
    const begun = performance.now();
    const { timePlots, ...found } = await experiment.run(laboratory, out);
    await writeExperiment(out, experiment, {
      found,
      clocked: { times: laboratory.times, timePlots, own: command === OWN },
      how: `npm run experiments ${experiment.name}${seed === 1 ? '' : ` -- --seed ${seed}`}`,
    });
    const seconds = ((performance.now() - begun) / 1000).toFixed(1);
    console.log(`${experiment.name.padEnd(14)} ${seconds.padStart(7)} s`);
  }
  writeIndex(out, EXPERIMENTS);
  console.log(`written: ${relative(process.cwd(), out)}`);
}

main().catch(exitWith);
