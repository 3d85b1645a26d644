// Makes the pictures of docs/pictures/: `npm run screenshots [NAME...]`. Names choose some of them.
import { build } from './build.mjs';
import { exitWith, localBin, run, timed } from './lib/run.mjs';

try {
  await timed('build web', () => build('web'));
  const names = process.argv.slice(2);
  const chosen = names.length > 0 ? ['--grep', names.join('|')] : [];
  await timed('screenshots', () =>
    run(localBin('playwright'), ['test', 'e2e/screenshots.spec.ts', ...chosen], {
      env: { LIFTARM_SCREENSHOTS: '1' },
    }),
  );
} catch (error) {
  exitWith(error);
}
