// `npm run example:cpp`: installs the library into build/install and builds and runs docs/examples/cpp against it.
import { rmSync } from 'node:fs';
import { join } from 'node:path';
import { exitWith, run, TOP } from './lib/run.mjs';
import { setUp } from './setup.mjs';

const PREFIX = join(TOP, 'build/install');
const BUILD = join(TOP, 'build/example-cpp');

async function main() {
  await setUp({ forTests: false });
  await run('cmake', ['--preset', 'native']);
  await run('cmake', ['--build', '--preset', 'native', '--target', 'liftarm']);
  // What an earlier version installed must not be found.
  for (const folder of [PREFIX, BUILD]) {
    rmSync(folder, { recursive: true, force: true });
  }
  await run('cmake', ['--install', 'build/native', '--prefix', PREFIX]);
  await run('cmake', [
    '-G',
    'Ninja',
    '-S',
    'docs/examples/cpp',
    '-B',
    BUILD,
    `-DCMAKE_PREFIX_PATH=${PREFIX}`,
  ]);
  await run('cmake', ['--build', BUILD]);
  await run(join(BUILD, 'example'), []);
}

main().catch(exitWith);
