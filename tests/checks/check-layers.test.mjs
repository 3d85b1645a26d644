import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { checkLayers, closure } from './check-layers.mjs';

const HERE = import.meta.dirname;

test('names every breach of the bad fixture with its place', () => {
  expect(checkLayers(join(HERE, 'fixtures/bad'))).toEqual([
    'core/extra/extra.h: core/extra is not in layers.json',
    'core/layout/bare.h:1: "status.h" must be included as "folder/file.h"',
    'core/layout/layout.h:1: layout/ may not include search/',
    'core/model/model.cpp:2: model/ may not include analysis/',
    'wasm/bindings.cpp:2: wasm/ may not include model/',
    'web/src/model/model.ts:1: model/ may not import state/',
    "web/src/ui/panel.tsx:1: ui/ may not import 'three'",
    'web/src/ui/panel.tsx:2: ui/ may not import app/',
  ]);
});

test('accepts the good fixture', () => {
  expect(checkLayers(join(HERE, 'fixtures/good'))).toEqual([]);
});

test('the command ends with 1 on the bad fixture', () => {
  const script = join(HERE, 'check-layers.mjs');
  expect(spawnSync(process.execPath, [script, join(HERE, 'fixtures/bad')]).status).toBe(1);
  expect(spawnSync(process.execPath, [script, join(HERE, 'fixtures/good')]).status).toBe(0);
});

test('a C++ file over the limit is named with its length', () => {
  const root = mkdtempSync(join(tmpdir(), 'liftarm-layers-'));
  mkdirSync(join(root, 'core/base'), { recursive: true });
  writeFileSync(join(root, 'core/base/long.cpp'), '\n'.repeat(401));
  writeFileSync(join(root, 'core/base/full.cpp'), '\n'.repeat(400));
  expect(checkLayers(root)).toEqual(['core/base/long.cpp: 401 lines, 400 at most']);
  rmSync(root, { recursive: true });
});

test('an elementary function of the platform is named with its place', () => {
  const root = mkdtempSync(join(tmpdir(), 'liftarm-layers-'));
  mkdirSync(join(root, 'core/base'), { recursive: true });
  writeFileSync(
    join(root, 'core/base/turn.cpp'),
    'double a = std::sqrt(2.0);\ndouble b = std::cos(a);\n',
  );
  expect(checkLayers(root)).toEqual([
    'core/base/turn.cpp:2: std::cos differs between platforms; see base/det_math.h',
  ]);
  rmSync(root, { recursive: true });
});

test('what a folder may use includes what its neighbours may use, and nothing above', () => {
  const reach = closure({ a: [], b: ['a'], c: ['b'] });
  expect([...(reach.get('c') ?? [])].sort()).toEqual(['a', 'b', 'c']);
  expect([...(reach.get('b') ?? [])].sort()).toEqual(['a', 'b']);
});
