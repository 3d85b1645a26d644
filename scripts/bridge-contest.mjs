// `npm run bridge-contest -- MODEL... [--contest FILE]`: scores bridges again, whatever their makers say, and ranks them.
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { basename } from 'node:path';
import { parseArgs } from 'node:util';
import { loadTypeScript } from './lib/load-typescript.mjs';
import { readyCommand } from './lib/ready-command.mjs';
import { exitWith, StepError } from './lib/run.mjs';

const USAGE = `npm run bridge-contest -- MODEL... [options]
  MODEL          model files (NAME.model.json)
  --contest FILE deck, truck, prices: docs/contests.md (without it: a deck along the model, at its top)
  --json         one line of JSON for each
  --command FILE the command to run (default build/native/liftarm, built first)`;

/** Without a contest of its own: along x through the middle of the model, at the height of its highest beam's middle. */
function deckOf({ parts }) {
  const along = (axis, pick) => pick(...parts.map(({ position }) => position[axis]));
  const middle = (along(1, Math.min) + along(1, Math.max)) / 2;
  const top = along(2, Math.max);
  return { from: [along(0, Math.min), middle, top], to: [along(0, Math.max), middle, top] };
}

/** What the command prints, which is one JSON object. */
function told(command, args) {
  const { status, stdout, stderr } = spawnSync(command, args, {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
  });
  if (status !== 0) {
    throw new StepError(`${args[1] ?? args[0]}: ${stderr}`);
  }
  return JSON.parse(stdout);
}

function isBuildable(command, file) {
  const { status, stderr } = spawnSync(command, ['check', file, '--json'], { encoding: 'utf8' });
  if (status !== 0 && status !== 2) {
    throw new StepError(`${file}: ${stderr}`);
  }
  return status === 0;
}

function judge(file, { command, bridge, contest, masses }) {
  const model = JSON.parse(readFileSync(file, 'utf8'));
  const rules = { ...bridge.BRIDGE_DEFAULTS, deck: deckOf(model), ...contest };
  const fault = bridge.faultOfContest(rules);
  if (fault !== null) {
    throw new StepError(`the contest: ${fault}`);
  }
  const stressOf = (loads) => {
    const asked = JSON.stringify({ friction: 'held', loads });
    const { ok, safety, maxDisplacement } = told(command, ['stress', file, '--options', asked]);
    return { stands: ok, safety: safety ?? 0, displacement: maxDisplacement ?? 0 };
  };
  const parts = model.parts.map(({ part }) => part);
  const score = bridge.scoreBridge(rules, parts, {
    massOf: (part) => masses.get(part) ?? 0,
    stressOf,
  });
  const buildable = isBuildable(command, file);
  return { file: basename(file), buildable, ...score, score: buildable ? score.score : null };
}

function lineOf({ file, buildable, score, price, worst }, place) {
  const verdict = score === null ? 'no score' : `${place}.`;
  const why = buildable ? '' : ', not buildable';
  return (
    `${verdict.padStart(8)} ${file.padEnd(32)} price ${price.toFixed(2).padStart(8)}  ` +
    `least safety ${worst.stands ? worst.safety.toFixed(2) : 'folds'} with the truck at ${worst.front}${why}`
  );
}

async function main() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      contest: { type: 'string' },
      json: { type: 'boolean', default: false },
      command: { type: 'string' },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help || positionals.length === 0) {
    throw new StepError(USAGE);
  }
  const command = await readyCommand(values.command);
  const { parts } = told(command, ['parts']);
  const rules = {
    command,
    bridge: await loadTypeScript('web/src/model/contest/bridge.ts'),
    contest: values.contest === undefined ? {} : JSON.parse(readFileSync(values.contest, 'utf8')),
    masses: new Map(parts.map(({ id, mass }) => [id, mass])),
  };
  const found = positionals
    .map((file) => judge(file, rules))
    .sort((a, b) => (a.score ?? Infinity) - (b.score ?? Infinity));
  for (const [i, one] of found.entries()) {
    console.log(values.json ? JSON.stringify(one) : lineOf(one, i + 1));
  }
}

main().catch(exitWith);
