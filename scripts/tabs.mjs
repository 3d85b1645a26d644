// Two tabs of one browser on the same sketches, killed at random moments: `npm run tabs -- --rounds 200`.
import { parseArgs } from 'node:util';
import { build } from './build.mjs';
import { exitWith, localBin, run, StepError, timed } from './lib/run.mjs';

try {
  const { values } = parseArgs({ options: { rounds: { type: 'string', default: '200' } } });
  if (!/^[1-9]\d{0,4}$/.test(values.rounds)) {
    throw new StepError(`--rounds ${values.rounds}: should be a whole number from 1 to 99999`);
  }
  await timed('build of the page', () => build('web'));
  const args = ['test', 'e2e/tabs.spec.ts', '--grep', 'killed at random'];
  await timed('two tabs', () =>
    run(localBin('playwright'), args, { env: { LIFTARM_TAB_ROUNDS: values.rounds } }),
  );
} catch (error) {
  exitWith(error);
}
