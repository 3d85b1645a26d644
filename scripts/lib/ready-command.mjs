import { existsSync } from 'node:fs';
import { relative, resolve } from 'node:path';
import { build } from '../build.mjs';
import { setUp } from '../setup.mjs';
import { StepError, TOP } from './run.mjs';

/** The native command that a script is to run: the named file, or our own, built first. */
export async function readyCommand(named) {
  if (named === undefined) {
    await setUp({ forTests: false });
    await build('command');
  }
  const command = resolve(named ?? resolve(TOP, 'build/native/liftarm'));
  if (!existsSync(command)) {
    throw new StepError(`${relative(TOP, command)} is missing: run \`npm run build:native\``);
  }
  return command;
}
