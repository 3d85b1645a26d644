import { resolve } from 'node:path';
import { expect, test } from 'vitest';
import { makeFirstModel } from '../../web/pwa/first-model-plugin.ts';
import { loadModule, solveWithCommand, solveWithModule } from './module.ts';

const TOP = resolve(import.meta.dirname, '../..');
const FOLDERS = { wasm: resolve(TOP, 'build/wasm'), public: resolve(TOP, 'public') };

test('the model that the page ships is what the search gives for its sketch, settings and seed', async () => {
  const made = await makeFirstModel(FOLDERS, 'en');
  const { seed, preset } = made.settings;
  const module = await loadModule();
  const wasm = solveWithModule(module, JSON.stringify(made.sketch), made.settings);
  expect(made.modelJson).toBe(wasm.modelJson);
  expect(JSON.parse(made.reportJson)).toEqual(wasm.report);
  expect(made.checkJson).toBe(module.checkModelJson(made.modelJson).text);
  const native = solveWithCommand('chair', ['--seed', `${seed}`, '--preset', `${preset}`]);
  expect(made.modelJson.trimEnd()).toBe(native.modelJson.trimEnd());
});

test('it is made the same each time, so that a build with nothing new is no new version', async () => {
  expect(await makeFirstModel(FOLDERS, 'en')).toEqual(await makeFirstModel(FOLDERS, 'en'));
});

test('in German it differs in nothing but the name', async () => {
  const [en, de] = [await makeFirstModel(FOLDERS, 'en'), await makeFirstModel(FOLDERS, 'de')];
  expect(de.sketch.name).toBe('Stuhl');
  expect(JSON.parse(de.modelJson).parts).toEqual(JSON.parse(en.modelJson).parts);
});
