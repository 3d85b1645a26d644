import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { compileAlone, flagsOf, targetOf } from './check-alone.mjs';

async function compiled(source) {
  const folder = mkdtempSync(join(tmpdir(), 'liftarm-alone-'));
  const file = join(folder, 'a.h');
  writeFileSync(file, `#pragma once\n${source}`);
  const said = await compileAlone(file, ['-std=c++20', '-Wall', '-Werror']);
  rmSync(folder, { recursive: true });
  return said;
}

test('a header that includes what it uses compiles alone', async () => {
  expect(await compiled('#include <string>\ninline std::string name() { return "a"; }\n')).toBe(
    null,
  );
});

test('a header that lives on what others include is named with what it lacks', async () => {
  expect(await compiled('inline std::string name() { return "a"; }\n')).toMatch(
    /a\.h does not compile alone:[\s\S]*string/,
  );
});

test('a file has the flags of its folder', () => {
  expect(
    [
      'core/analysis/check.cpp',
      'tests/core/analysis/check_test.cpp',
      'tests/core/helpers/models.h',
      'core/rivals/absent/rivals.cpp',
      'web/src/app/main.tsx',
    ].map(targetOf),
  ).toEqual(['liftarm_analysis', 'test_analysis', 'liftarm_test_helpers', null, null]);
});

test('what goes in and out, and what is for several files at once, is no flag of a file alone', () => {
  expect(
    flagsOf(
      '/usr/bin/c++ -DA=\\"b\\" -Icore -O3 -Wshadow -Wno-shadow -Wshadow=local -include a.hxx -o a.o -c a.cpp',
    ),
  ).toEqual(['-DA="b"', '-Icore', '-O3', '-Wshadow']);
});
