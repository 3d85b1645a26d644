// Makes the pictures of docs/pictures/: `npm run screenshots [NAME...]`. Names choose some of them.
import { build } from './build.mjs';
import { exitWith, freePort, localBin, run, timed } from './lib/run.mjs';

try {
  await timed('build web', () => build('web'));
  const names = process.argv.slice(2);
  const chosen = names.length > 0 ? ['--grep', names.join('|')] : [];
  const port = await freePort(4320);
  await timed('screenshots', () =>
    run(localBin('playwright'), ['test', 'e2e/screenshots.spec.ts', ...chosen], {
      env: { LIFTARM_SCREENSHOTS: '1', LIFTARM_E2E_PORT: `${port}` },
    }),
  );
} catch (error) {
  exitWith(error);
}
