// `npm test`: set-up, then every check and every test, in the order of what fails fastest. Stops at the
// first step that fails. Steps can be named: `node scripts/test.mjs lint native`. Native tests run while the WebAssembly
// module is built: its link takes minutes and one core alone.
import { existsSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { relative, resolve } from 'node:path';
import { build } from './build.mjs';
import { capture, exitWith, localBin, run, StepError, TOP, timed } from './lib/run.mjs';
import { fileOf, RESULTS, resultsOf, STEPS_FILE, stepLines } from './lib/test-results.mjs';
import { setUp } from './setup.mjs';

const VITE_CONFIG = resolve(TOP, 'web/vite.config.ts');

/** Passed, failed and skipped tests per runner, and when each step began and what it took, for the last lines. */
const counts = [];
const steps = [];
const start = performance.now();

const secondsSince = (moment) => (performance.now() - moment) / 1000;

/** Runs one named step, and keeps its time. */
async function step(title, work) {
  const began = performance.now();
  try {
    await timed(title, work);
  } finally {
    steps.push({ title, began: (began - start) / 1000, took: secondsSince(began) });
  }
}

/** Runs a test runner; whatever it ends with, its counts are read from the file that it wrote. */
async function runner(name, { command, args, env = {} }) {
  rmSync(fileOf(name), { force: true });
  try {
    await run(command, args, { env });
  } finally {
    counts.push({ name, ...(resultsOf(name) ?? { passed: 0, failed: 1, skipped: 0 }) });
  }
  if (counts.at(-1).passed === 0) {
    throw new StepError(`${name}: no test ran`);
  }
}

function checkFormat() {
  const { stdout } = capture('git', [
    'ls-files',
    '--cached',
    '--others',
    '--exclude-standard',
    'core/*.h',
    'core/*.cpp',
    'wasm/*.h',
    'wasm/*.cpp',
    'tests/*.h',
    'tests/*.cpp',
    ':!tests/checks/fixtures',
  ]);
  const files = stdout.split('\n').filter((file) => file && existsSync(resolve(TOP, file)));
  return run('clang-format', ['--dry-run', '-Werror', ...files]);
}

const LINTS = {
  'lint: layers and sizes': () => run(process.execPath, ['tests/checks/check-layers.mjs']),
  'lint: classes and functions': () => run(process.execPath, ['tests/checks/check-classes.mjs']),
  'lint: clang-format': checkFormat,
  'lint: Biome': () => run(localBin('biome'), ['check', '--error-on-warnings', '.']),
  'lint: TypeScript': async () => {
    await run(localBin('tsc'), ['-p', '.']);
    await run(localBin('tsc'), ['-p', 'web/src/solver']);
  },
};

const buildNative = () => step('native build', () => build('native'));
const buildWasm = () => step('WebAssembly build', () => build('wasm'));

const checkAlone = () =>
  step('files compiled alone', () => run(process.execPath, ['tests/checks/check-alone.mjs']));

const testNative = () =>
  step('native tests', () =>
    runner('native', {
      command: 'ctest',
      args: ['--preset', 'native', '--progress', '--output-junit', fileOf('native')],
    }),
  );

const testUnits = () =>
  step('Vitest', () =>
    runner('vitest', {
      command: localBin('vitest'),
      args: [
        'run',
        '--config',
        VITE_CONFIG,
        '--reporter=default',
        '--reporter=json',
        `--outputFile.json=${fileOf('vitest')}`,
      ],
    }),
  );

async function testPage() {
  await step('build of the page', () => build('web'));
  await step('browser tests', () =>
    runner('browser', {
      command: localBin('playwright'),
      args: ['test', '--reporter=list,json'],
      env: { PLAYWRIGHT_JSON_OUTPUT_FILE: fileOf('browser') },
    }),
  );
}

/** Waits for all, whatever becomes of them. @throws what the first of them that failed threw. */
async function together(...works) {
  const ends = await Promise.allSettled(works.map((work) => work()));
  const failed = ends.find(({ status }) => status === 'rejected');
  if (failed !== undefined) {
    throw failed.reason;
  }
}

const STEPS = {
  setup: () => step('set-up', () => setUp({ forTests: true })),
  lint: async () => {
    for (const [title, work] of Object.entries(LINTS)) {
      await step(title, work);
    }
  },
  native: async () => {
    await buildNative();
    const wasm = stepNames.includes('wasm') ? [buildWasm] : [];
    await together(testNative, checkAlone, ...wasm);
  },
  // Nothing is left to do when it went along with the native tests.
  wasm: buildWasm,
  unit: testUnits,
  page: testPage,
};

function printSummary() {
  const sum = (key) => counts.reduce((total, count) => total + count[key], 0);
  console.log('');
  for (const { name, passed, failed, skipped } of counts) {
    console.log(`${name.padEnd(8)} ${passed} passed, ${failed} failed, ${skipped} skipped`);
  }
  for (const title of counts.flatMap(({ second }) => second ?? [])) {
    console.log(`passed only the second time: ${title}`);
  }
  const all = `${sum('passed')} passed, ${sum('failed')} failed, ${sum('skipped')} skipped`;
  console.log(
    `${all} in ${secondsSince(start).toFixed(0)} s (npm run test:times: where they went)`,
  );
}

const wanted = process.argv.slice(2);
const unknown = wanted.filter((name) => !(name in STEPS));
if (unknown.length > 0) {
  exitWith(new StepError(`no step '${unknown[0]}'; there are: ${Object.keys(STEPS).join(', ')}`));
}
const stepNames = wanted.length > 0 ? wanted : Object.keys(STEPS);
mkdirSync(RESULTS, { recursive: true });
let failure = null;
for (const name of stepNames) {
  try {
    await STEPS[name]();
  } catch (error) {
    failure = error;
    console.error(`\nFAILED in step '${name}' (results in ${relative(TOP, RESULTS)}/)`);
    break;
  }
}
writeFileSync(STEPS_FILE, JSON.stringify(steps));
console.log(`\n${stepLines(steps).join('\n')}`);
printSummary();
if (failure !== null) {
  exitWith(failure);
}
