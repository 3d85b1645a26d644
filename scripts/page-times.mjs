// How long the page takes: `npm run bench:page`. Prints, and judges nothing; machines differ.
import { build } from './build.mjs';
import { exitWith, localBin, run, timed } from './lib/run.mjs';

try {
  await timed('build of the page', () => build('web'));
  await timed('times of the page', () =>
    run(localBin('playwright'), ['test'], { env: { LIFTARM_PAGE_TIMES: '1' } }),
  );
} catch (error) {
  exitWith(error);
}
