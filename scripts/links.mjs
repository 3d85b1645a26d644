// Many broken links pasted into the open page: `npm run links -- --count 3000`.
import { parseArgs } from 'node:util';
import { build } from './build.mjs';
import { exitWith, localBin, run, StepError, timed } from './lib/run.mjs';

try {
  const { values } = parseArgs({ options: { count: { type: 'string', default: '3000' } } });
  if (!/^[1-9]\d{0,4}$/.test(values.count)) {
    throw new StepError(`--count ${values.count}: should be a whole number from 1 to 99999`);
  }
  await timed('build of the page', () => build('web'));
  const args = ['test', 'e2e/links.spec.ts', '--grep', 'mutated links'];
  await timed('links', () =>
    run(localBin('playwright'), args, { env: { LIFTARM_LINKS: values.count } }),
  );
} catch (error) {
  exitWith(error);
}
