// `npm test`: set-up, then every check and every test, in the order of what fails fastest. Stops at the
// first step that fails. Steps can be named: `node scripts/test.mjs lint native`. Native tests run while the WebAssembly
// module is built: its link takes minutes and one core alone.
import { existsSync, mkdirSync, readFileSync, rmSync } from 'node:fs';
import { relative, resolve } from 'node:path';
import { build } from './build.mjs';
import { capture, exitWith, localBin, run, StepError, TOP, timed } from './lib/run.mjs';
import { setUp } from './setup.mjs';

const RESULTS = resolve(TOP, 'build/test-results');
const VITE_CONFIG = resolve(TOP, 'web/vite.config.ts');

/** Passed, failed and skipped tests per runner, for the last line. */
const counts = [];

function readJson(file) {
  return existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : null;
}

/** Runs a test runner; whatever it ends with, its counts are read from the file that it wrote. */
async function runner(name, file, { command, args, env = {}, read }) {
  rmSync(file, { force: true });
  try {
    await run(command, args, { env });
  } finally {
    const count = existsSync(file) ? read(file) : { passed: 0, failed: 1, skipped: 0 };
    counts.push({ name, ...count });
  }
  if (counts.at(-1).passed === 0) {
    throw new StepError(`${name}: no test ran`);
  }
}

function readCtest(file) {
  const head = readFileSync(file, 'utf8').slice(0, 4000);
  const field = (name) => Number(head.match(new RegExp(`\\b${name}="(\\d+)"`))?.[1] ?? 0);
  const skipped = field('skipped') + field('disabled');
  return {
    passed: field('tests') - field('failures') - skipped,
    failed: field('failures'),
    skipped,
  };
}

function readVitest(file) {
  const { numPassedTests, numFailedTests, numPendingTests, numFailedTestSuites, success } =
    readJson(file);
  // A file that does not even load has no failed test of its own.
  const failed = success ? 0 : Math.max(numFailedTests, Math.min(1, numFailedTestSuites));
  return { passed: numPassedTests, failed, skipped: numPendingTests };
}

function readPlaywright(file) {
  const { stats, suites } = readJson(file);
  const { expected, unexpected, flaky, skipped } = stats;
  const inside = (suite) => [...(suite.specs ?? []), ...(suite.suites ?? []).flatMap(inside)];
  const second = suites
    .flatMap(inside)
    .filter(({ tests }) => tests.some(({ status }) => status === 'flaky'))
    .map(({ file: spec, title }) => `${spec}: ${title}`);
  return { passed: expected + flaky, failed: unexpected, skipped, second };
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

const buildNative = () => timed('native build', () => build('native'));
const buildWasm = () => timed('WebAssembly build', () => build('wasm'));

async function testNative() {
  const junit = resolve(RESULTS, 'ctest.xml');
  await timed('native tests', () =>
    runner('native', junit, {
      command: 'ctest',
      args: ['--preset', 'native', '--progress', '--output-junit', junit],
      read: readCtest,
    }),
  );
}

async function testUnits() {
  const json = resolve(RESULTS, 'vitest.json');
  await timed('Vitest', () =>
    runner('vitest', json, {
      command: localBin('vitest'),
      args: [
        'run',
        '--config',
        VITE_CONFIG,
        '--reporter=default',
        '--reporter=json',
        `--outputFile.json=${json}`,
      ],
      read: readVitest,
    }),
  );
}

async function testPage() {
  await timed('build of the page', () => build('web'));
  const json = resolve(RESULTS, 'playwright.json');
  await timed('browser tests', () =>
    runner('browser', json, {
      command: localBin('playwright'),
      args: ['test', '--reporter=list,json'],
      env: { PLAYWRIGHT_JSON_OUTPUT_FILE: json },
      read: readPlaywright,
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
  setup: () => timed('set-up', () => setUp({ forTests: true })),
  lint: async () => {
    for (const [title, work] of Object.entries(LINTS)) {
      await timed(title, work);
    }
  },
  native: async () => {
    await buildNative();
    await (stepNames.includes('wasm') ? together(testNative, buildWasm) : testNative());
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
  console.log(`${sum('passed')} passed, ${sum('failed')} failed`);
}

const wanted = process.argv.slice(2);
const unknown = wanted.filter((name) => !(name in STEPS));
if (unknown.length > 0) {
  exitWith(new StepError(`no step '${unknown[0]}'; there are: ${Object.keys(STEPS).join(', ')}`));
}
const stepNames = wanted.length > 0 ? wanted : Object.keys(STEPS);
mkdirSync(RESULTS, { recursive: true });
const start = performance.now();
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
console.log(`\nAll in all ${((performance.now() - start) / 1000).toFixed(0)} s`);
printSummary();
if (failure !== null) {
  exitWith(failure);
}
