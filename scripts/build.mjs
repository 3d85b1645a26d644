// Builds the parts named on the command line: native, wasm, web. Each build does only what changed.
import { availableParallelism } from 'node:os';
import { resolve } from 'node:path';
import { exitWith, localBin, run, StepError, TOP, timed } from './lib/run.mjs';

async function cmakeBuild(preset, ...args) {
  await run('cmake', ['--preset', preset, '--log-level=WARNING']);
  await run('cmake', ['--build', '--preset', preset, '-j', `${availableParallelism()}`, ...args]);
}

const BUILDS = {
  native: () => cmakeBuild('native'),
  /** The command alone, without tests. */
  command: () => cmakeBuild('native', '--target', 'liftarm'),
  wasm: () => cmakeBuild('wasm'),
  web: () =>
    run(localBin('vite'), [
      'build',
      '--config',
      resolve(TOP, 'web/vite.config.ts'),
      '--logLevel',
      'warn',
    ]),
};

/** @param {'native' | 'command' | 'wasm' | 'web'} name */
export function build(name) {
  const work = BUILDS[name];
  if (work === undefined) {
    throw new StepError(`no build '${name}'; there are: ${Object.keys(BUILDS).join(', ')}`);
  }
  return work();
}

if (process.argv[1] === import.meta.filename) {
  try {
    for (const name of process.argv.slice(2)) {
      await timed(`build ${name}`, () => build(name));
    }
  } catch (error) {
    exitWith(error);
  }
}
