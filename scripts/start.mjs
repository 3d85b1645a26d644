// `npm start`: set-up, builds, and the page served; its address is the last line printed.
import { build } from './build.mjs';
import { exitWith, timed } from './lib/run.mjs';
import { serveOptions } from './lib/serve-options.mjs';
import { serve } from './serve.mjs';
import { setUp } from './setup.mjs';

try {
  const options = serveOptions();
  await timed('set-up', () => setUp({ forTests: false }));
  await timed('build of the WebAssembly module', () => build('wasm'));
  await timed('build of the command', () => build('command'));
  await timed('build of the page', () => build('web'));
  const addresses = await serve(options);
  console.log(`\nLiftarm is served at ${addresses.join(' and ')} (Ctrl+C ends it)`);
} catch (error) {
  exitWith(error);
}
