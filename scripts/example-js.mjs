// `npm run example:js`: makes the package, installs it into build/example-js, and runs docs/examples/js against it:
// the program in Node, the compiler over its types, and the bare page in a browser.
import { copyFileSync, cpSync, mkdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { build } from './build.mjs';
import { pageServer } from './lib/page-server.mjs';
import { launchBrowser } from './lib/picture-sheet.mjs';
import { exitWith, localBin, run, StepError, TOP, timed } from './lib/run.mjs';
import { makePackage, PACKAGE } from './package.mjs';
import { setUp } from './setup.mjs';

const EXAMPLES = join(TOP, 'docs/examples/js');
const PLACE = join(TOP, 'build/example-js');

/** Where another project would have it: in node_modules, and beside a page. */
function install() {
  rmSync(PLACE, { recursive: true, force: true });
  for (const folder of ['node_modules/liftarm', 'liftarm']) {
    mkdirSync(join(PLACE, folder), { recursive: true });
    cpSync(PACKAGE, join(PLACE, folder), { recursive: true });
  }
  for (const file of ['node.mjs', 'page.html', 'types.ts']) {
    copyFileSync(join(EXAMPLES, file), join(PLACE, file));
  }
}

async function openPage() {
  const server = pageServer(PLACE);
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  const browser = await launchBrowser();
  try {
    const page = await browser.newPage();
    await page.goto(`http://127.0.0.1:${server.address().port}/page.html`);
    await page.waitForFunction(() => document.querySelector('#parts').children.length > 0);
    const state = await page.textContent('#state');
    console.log(state);
    if (!state.endsWith('buildable: true')) {
      throw new StepError('the bare page shows no buildable model');
    }
  } finally {
    await browser.close();
    server.close();
  }
}

async function main() {
  await setUp({ forTests: true });
  await timed('build wasm', () => build('wasm'));
  await timed('package', makePackage);
  install();
  await timed('in Node', () => run(process.execPath, ['node.mjs'], { cwd: PLACE }));
  const strict = [
    '--strict',
    '--module',
    'nodenext',
    '--target',
    'es2022',
    '--noEmit',
    '--ignoreConfig',
  ];
  await timed('types', () => run(localBin('tsc'), [...strict, 'types.ts'], { cwd: PLACE }));
  await timed('in a browser', openPage);
}

main().catch(exitWith);
