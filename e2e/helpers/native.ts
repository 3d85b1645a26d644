import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const COMMAND =
  process.env['LIFTARM_COMMAND'] ?? resolve(import.meta.dirname, '../../build/native/liftarm');

/** What `liftarm check` says about a model file: its exit code and its words. */
export function nativeCheck(model: string): { code: number | null; words: string } {
  if (!existsSync(COMMAND)) {
    throw new Error('build/native/liftarm is missing: npm run build:native');
  }
  const file = join(mkdtempSync(join(tmpdir(), 'liftarm-')), 'drawn.model.json');
  writeFileSync(file, model);
  const run = spawnSync(COMMAND, ['check', file], { encoding: 'utf8' });
  return { code: run.status, words: run.stdout + run.stderr };
}
