import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, describe, expect, test } from 'vitest';

const TOP = resolve(import.meta.dirname, '../..');
const COMMAND = join(TOP, 'build/native/liftarm');
const NAMES = ['stage-one', 'schedules'];

const folders: string[] = [];

/** Runs cheap experiments in their quick form. */
function run(): string {
  const out = mkdtempSync(join(tmpdir(), 'liftarm-experiments-'));
  folders.push(out);
  const args = ['scripts/experiments.mjs', ...NAMES, '--quick', '--command', COMMAND];
  execFileSync(process.execPath, [...args, '--out', out], { cwd: TOP });
  return out;
}

const resultsOf = (folder: string) =>
  Object.fromEntries(
    readdirSync(folder)
      .filter((name) => /\.(md|csv|svg)$/.test(name))
      .sort()
      .map((name) => [name, readFileSync(join(folder, name), 'utf8')]),
  );

describe('experiments', () => {
  afterAll(() => {
    for (const folder of folders) {
      rmSync(folder, { recursive: true });
    }
  });

  test('write the same bytes twice, with seconds apart', { timeout: 300_000 }, () => {
    const first = run();
    const results = resultsOf(first);
    for (const name of NAMES) {
      expect(Object.keys(results)).toContain(`${name}.md`);
      expect(results[`${name}.csv`]?.split('\n').length).toBeGreaterThan(3);
      expect(readdirSync(join(first, 'times'))).toContain(`${name}.md`);
    }
    expect(resultsOf(run())).toEqual(results);
  });
});

describe('the scorer', () => {
  test('agrees with the checks on models and on planted faults', { timeout: 300_000 }, () => {
    const args = ['scripts/scorer.mjs', '--count', '6', '--faults', '14', '--command', COMMAND];
    const text = execFileSync(process.execPath, args, { cwd: TOP, encoding: 'utf8' });
    expect(text).toContain('6 of 6 models judged alike');
    expect(text).toContain('14 of 14 planted faults judged alike');
  });
});
