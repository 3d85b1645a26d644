// One table of odd inputs for both readers: tests/core/design/odd_inputs_test.cpp asks the core.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import Ajv2020 from 'ajv/dist/2020.js';
import { describe, expect, it } from 'vitest';
import { readModel } from '../../web/src/app/read-model.ts';
import { readSketch } from '../../web/src/state/read-sketch.ts';

interface Row {
  readonly name: string;
  readonly ok: boolean;
  /** What the schema says, where it cannot see what is wrong. */
  readonly schema?: boolean;
  readonly sketch?: unknown;
  readonly model?: unknown;
  readonly settings?: unknown;
}

const TOP = join(import.meta.dirname, '../..');
const fromFile = (path: string) => JSON.parse(readFileSync(join(TOP, path), 'utf8'));
const TABLE: Readonly<Record<'sketches' | 'models' | 'settings', readonly Row[]>> = fromFile(
  'tests/contract/odd-inputs.json',
);

const ajv = new Ajv2020({ strict: true, strictTypes: false, strictRequired: false });
const schema = (name: string) => ajv.compile(fromFile(`docs/schemas/${name}.schema.json`));
const VERSIONS = [schema('sketch-v1'), schema('sketch-v2')];
const MODEL = schema('model');
const SETTINGS = schema('settings');

describe.each(TABLE.sketches)('a sketch with $name', ({ ok, schema: seen = ok, sketch }) => {
  it(`is ${ok ? 'read' : 'refused'} by the page`, () => {
    const read = readSketch(JSON.stringify(sketch));
    expect(read.ok, read.ok ? '' : read.message).toBe(ok);
  });
  it(`is ${seen ? 'valid' : 'invalid'} by the schema`, () => {
    expect(VERSIONS.some((validate) => validate(sketch))).toBe(seen);
  });
});

describe.each(TABLE.models)('a model with $name', ({ ok, schema: seen = ok, model }) => {
  it(`is ${ok ? 'read' : 'refused'} by the page`, () => {
    expect(readModel(JSON.stringify(model)).ok).toBe(ok);
  });
  it(`is ${seen ? 'valid' : 'invalid'} by the schema`, () => {
    expect(MODEL(model)).toBe(seen);
  });
});

it.each(TABLE.settings)('settings with $name are seen by their schema', (row) => {
  expect(SETTINGS(row.settings)).toBe(row.schema ?? row.ok);
});
