import assert from 'node:assert/strict';
import { test } from 'vitest';
import { touchedFolders } from '../../scripts/lib/touched-folders.mjs';

const FOLDERS = ['base', 'model', 'sketch'];

test('a change touches the folders of its code and of its tests', () => {
  const files = ['core/model/seating.cpp', 'tests/core/sketch/snap_test.cpp', 'docs/design.md'];
  assert.deepEqual(touchedFolders(files, FOLDERS), ['model', 'sketch']);
});

test('a change of what all tests are built with touches all', () => {
  assert.deepEqual(touchedFolders(['tests/core/helpers/models.cpp'], FOLDERS), FOLDERS);
});

test('a change of the page touches none', () => {
  assert.deepEqual(touchedFolders(['web/src/app/main.ts', ''], FOLDERS), []);
});
