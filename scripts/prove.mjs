// `npm run prove -- [SKETCHES] [options]`: proves how few beams and axles along lines a sketch can have, and says how far
// the model that the search finds is above that. Each proof is checked by scripts/check-certificate.mjs.
import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import loadHighs from 'highs';
import { faultOf } from './check-certificate.mjs';
import { loadTypeScript } from './lib/load-typescript.mjs';
import { readyCommand } from './lib/ready-command.mjs';
import { exitWith, StepError } from './lib/run.mjs';
import { machine, sketchFiles, sketchName, solve, wholeNumber } from './lib/solve.mjs';

const USAGE = `npm run prove -- [SKETCHES] [options]
  SKETCHES            files, or names in ../shared/sketches; all of those for none
  --preset P          of the model to compare with (default simple)
  --set k=v           handed to \`liftarm solve\` and \`liftarm placements\`; can be repeated
  --seeds N           the best model of seeds 1 to N (default 1)
  --seconds N         HiGHS may take for one piece (default 60)
  --leaves N          of the proof of one piece at most (default 1000)
  --certificates DIR  writes NAME.placements.json and NAME.certificate.json there
  --command FILE      takes this command as it is`;

function readOptions() {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      preset: { type: 'string', default: 'simple' },
      set: { type: 'string', multiple: true, default: [] },
      seeds: { type: 'string', default: '1' },
      seconds: { type: 'string', default: '60' },
      leaves: { type: 'string', default: '1000' },
      certificates: { type: 'string' },
      command: { type: 'string' },
      help: { type: 'boolean', default: false },
    },
  });
  if (values.help) {
    throw new StepError(USAGE);
  }
  return {
    ...values,
    sketches: sketchFiles(positionals),
    seeds: wholeNumber('seeds', values.seeds),
    seconds: wholeNumber('seconds', values.seconds),
    leaves: wholeNumber('leaves', values.leaves),
    passed: [...['--preset', values.preset], ...values.set.flatMap((pair) => ['--set', pair])],
  };
}

/** Fewest beams and axles along lines of the buildable models of some seeds; null when there is none. */
function knownBest(command, sketch, { seeds, passed }) {
  const counts = Array.from({ length: seeds }, (_, i) =>
    solve(command, { sketch, args: ['--seed', `${i + 1}`, ...passed], timeoutMs: 600_000 }),
  )
    .filter((report) => report?.buildable)
    .map(({ beams, axles }) => beams + axles);
  return counts.length === 0 ? null : Math.min(...counts);
}

function listPlacements(command, sketch, passed) {
  return execFileSync(command, ['placements', sketch, ...passed], {
    encoding: 'utf8',
    maxBuffer: 1 << 30,
  });
}

function write(folder, name, text) {
  mkdirSync(folder, { recursive: true });
  writeFileSync(resolve(folder, name), text);
}

function verdict(bound, known) {
  if (known === null) {
    return 'no model';
  }
  if (known < bound) {
    return 'BELOW THE BOUND';
  }
  return known === bound ? 'optimal' : `+${known - bound}`;
}

async function main() {
  const options = readOptions();
  const command = await readyCommand(options.command);
  const { prove } = await loadTypeScript('web/src/solver/proof/prove.ts');
  console.log(`${machine()}; beams and axles along lines, seconds of the proof and of its check`);
  console.log('sketch               quick  bound  known  verdict    leaves  proof  check');
  let optimal = 0;
  for (const sketch of options.sketches) {
    const name = sketchName(sketch);
    const text = listPlacements(command, sketch, options.passed);
    const placements = JSON.parse(text);
    let leaves = 0;
    const begun = performance.now();
    const certificate = prove(placements, await loadHighs(), {
      seconds: options.seconds,
      leaves: options.leaves,
      onProgress: (progress) => {
        leaves = progress.leaves;
      },
    });
    const proved = performance.now();
    const fault = faultOf(placements, certificate);
    const checked = performance.now();
    if (fault !== null) {
      throw new StepError(`${name}: the certificate is wrong: ${fault}`);
    }
    if (options.certificates) {
      write(options.certificates, `${name}.placements.json`, text);
      write(options.certificates, `${name}.certificate.json`, JSON.stringify(certificate));
    }
    const known = knownBest(command, sketch, options);
    const said = verdict(certificate.bound, known);
    optimal += said === 'optimal' ? 1 : 0;
    console.log(
      [
        name.padEnd(20),
        String(placements.quickBound).padStart(5),
        String(certificate.bound).padStart(6),
        String(known ?? '-').padStart(6),
        ` ${said.padEnd(10)}`,
        String(leaves).padStart(6),
        ((proved - begun) / 1000).toFixed(2).padStart(6),
        ((checked - proved) / 1000).toFixed(2).padStart(6),
      ].join(' '),
    );
    if (said === 'BELOW THE BOUND') {
      process.exitCode = 1;
    }
  }
  console.log(`${optimal} of ${options.sketches.length} proved to be optimal`);
}

try {
  await main();
} catch (error) {
  exitWith(error);
}
