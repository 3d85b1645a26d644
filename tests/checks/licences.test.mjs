import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { expect, test } from 'vitest';
import { licencesText, packagesOf } from '../../web/pwa/licences-plugin.ts';

const TOP = resolve(import.meta.dirname, '../..');
const { dependencies } = JSON.parse(readFileSync(join(TOP, 'package.json'), 'utf8'));

test('every package that the page depends on has a licence with its text', () => {
  const folders = Object.keys(dependencies).map((name) => join(TOP, 'node_modules', name));
  const text = licencesText(folders, { top: TOP });
  for (const [name, version] of Object.entries(dependencies)) {
    expect(text).toContain(`${name} ${version} (`);
  }
  expect(text.split('Permission is hereby granted').length).toBeGreaterThan(8);
  expect(text).toContain('Mozilla Public License Version 2.0');
});

test('a package is known by any module of it, also one inside of another', () => {
  const modules = [
    '/a/node_modules/three/build/three.js',
    '/a/node_modules/three/src/b.js',
    '/a/node_modules/pdf-lib/node_modules/@x/y/z.js?worker',
    '/a/web/src/app/main.tsx',
  ];
  expect(packagesOf(modules)).toEqual([
    '/a/node_modules/pdf-lib/node_modules/@x/y',
    '/a/node_modules/three',
  ]);
});

test('a package without a text is named', () => {
  const folder = join(TOP, 'tests/checks/fixtures/unlicensed');
  expect(() => licencesText([folder], { top: TOP })).toThrow(/unlicensed has no licence file/);
});
