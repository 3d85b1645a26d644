// Sketches with the symmetries that the core finds in them, confirmed.
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { StepError, TOP } from './run.mjs';
import { sketchName } from './solve.mjs';

const FOLDER = resolve(TOP, 'build/symmetric');

/** Of what \`liftarm symmetries\` found, what a person would confirm. */
function confirmed(command, file, which) {
  const result = spawnSync(command, ['symmetries', '--json', file], { encoding: 'utf8' });
  if (result.status !== 0) {
    throw new StepError(`liftarm symmetries ${file}: ${result.stderr}`);
  }
  return JSON.parse(result.stdout).symmetries.filter(({ kind, normal }) => {
    const principal = kind === 'reflection' && normal.filter((x) => x !== 0).length === 1;
    return which === 'all' ? kind !== 'rotation' : principal;
  });
}

/**
 * Writes the sketch with its symmetries confirmed.
 * @param {string} command path of the native command
 * @param {string} file a sketch
 * @param {'mirrors' | 'all'} which mirrors across principal planes, or all that was found
 * @returns {{file: string, found: number}} the file written, and how many symmetries it has
 */
export function withSymmetries(command, file, which = 'mirrors') {
  const symmetries = confirmed(command, file, which);
  mkdirSync(FOLDER, { recursive: true });
  const written = resolve(FOLDER, `${sketchName(file)}.sketch.json`);
  writeFileSync(written, JSON.stringify({ ...JSON.parse(readFileSync(file, 'utf8')), symmetries }));
  return { file: written, found: symmetries.length };
}
