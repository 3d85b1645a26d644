// `npm run asan -- [--since REF | FOLDER...]`: the native tests under the address and undefined sanitizers, then `solve`
// and `check` of every shared sketch and case (scripts/cases.mjs --quick). With folders of tests/core, or with those that
// differ from a commit, these tests alone: what a change touches, for checks before it lands. Ends with 1 at any report.
import { readdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { capture, exitWith, run, StepError, TOP, timed } from './lib/run.mjs';
import { touchedFolders } from './lib/touched-folders.mjs';

const TESTS = resolve(TOP, 'tests/core');
const SECONDS_EACH = '7200'; // a test of a minute may take ten so

const { values: options, positionals } = parseArgs({
  options: { since: { type: 'string' } },
  allowPositionals: true,
});

function allFolders() {
  return readdirSync(TESTS).filter(
    (folder) =>
      folder !== 'helpers' &&
      readdirSync(resolve(TESTS, folder)).some((file) => file.endsWith('_test.cpp')),
  );
}

function foldersSince(ref) {
  const { code, stdout, stderr } = capture('git', ['diff', '--name-only', ref]);
  if (code !== 0) {
    throw new StepError(`--since ${ref}: ${stderr.trim()}`);
  }
  return touchedFolders(stdout.trim().split('\n'), allFolders());
}

function wantedFolders() {
  const all = allFolders();
  const unknown = positionals.find((folder) => !all.includes(folder));
  if (unknown !== undefined) {
    throw new StepError(`no folder '${unknown}' of tests; there are: ${all.join(', ')}`);
  }
  if (options.since !== undefined) {
    return foldersSince(options.since);
  }
  return positionals.length > 0 ? positionals : all;
}

async function testFolders(folders) {
  const targets = folders.map((folder) => `test_${folder}`);
  await timed('sanitized build', async () => {
    await run('cmake', ['--preset', 'asan', '--log-level=WARNING']);
    await run('cmake', ['--build', '--preset', 'asan', '--target', ...targets]);
  });
  const names = `^(${folders.join('|')})\\.`;
  await timed('sanitized tests', () =>
    run('ctest', ['--preset', 'asan', '-R', names, '--timeout', SECONDS_EACH, '--progress']),
  );
}

async function main() {
  const folders = wantedFolders();
  if (folders.length > 0) {
    await testFolders(folders);
  }
  if (options.since === undefined && positionals.length === 0) {
    await timed('sanitized sketches and cases', async () => {
      await run('cmake', ['--build', '--preset', 'asan', '--target', 'liftarm']);
      const command = resolve(TOP, 'build/asan/liftarm');
      await run(process.execPath, ['scripts/cases.mjs', '--quick', '--command', command]);
    });
  }
  console.log(
    `\nno report from: ${folders.join(', ') || 'nothing, since no native folder is touched'}`,
  );
}

main().catch(exitWith);
