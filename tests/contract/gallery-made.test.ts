import { existsSync, readdirSync, statSync } from 'node:fs';
import { resolve } from 'node:path';
import { beforeAll, describe, expect, it } from 'vitest';
import type { SolverModule } from '../../web/src/solver/solver-module.ts';
import { PREFERENCE_DEFAULTS } from '../../web/src/state/preferences.ts';
import { readSketchValue } from '../../web/src/state/read-sketch.ts';
import { settingsOf } from '../../web/src/ui/solve-settings.ts';
import { GALLERY, galleryRows, galleryText, madeOf } from './gallery-rows.ts';
import { loadModule } from './module.ts';

// Large models come with the page. `npm run gallery` makes them anew; until then they may be those of an earlier
// search, but never models that cannot be built, or models of another drawing.

const ROWS = galleryRows.filter(({ made }) => made);
/** What a person can wait for at 4 Mbit a second, beside the rest of two seconds. */
const MOST_BYTES = 400_000;

/** Lines to a thousandth of a module: the search works on what has been snapped. */
function linesOf(sketch: unknown): unknown {
  const read = readSketchValue(sketch);
  const rounded = ([x, y, z]: readonly number[]) =>
    [x, y, z].map((c = Number.NaN) => Math.round(c * 1000) / 1000 + 0);
  return read.ok ? read.value.lines.map(({ from, to }) => [rounded(from), rounded(to)]) : read;
}

let module: SolverModule;

beforeAll(async () => {
  module = await loadModule();
});

describe.each(ROWS)('the model that comes with the page of $id', (row) => {
  it('is buildable', () => {
    const reply = module.checkModelJson(madeOf(row).modelJson);
    expect(JSON.parse(reply.text)).toMatchObject({ buildable: true, problems: [] });
  }, 180_000);

  it('is one of its drawing', () => {
    const { sketch } = JSON.parse(madeOf(row).modelJson) as { sketch: unknown };
    expect(linesOf(sketch)).toEqual(linesOf(JSON.parse(galleryText(row.file))));
  });

  it('is small enough to be opened at once', () => {
    expect(statSync(resolve(GALLERY, `made/${row.id}.made`)).size).toBeLessThan(MOST_BYTES);
  });
});

it('is made with what the page asks for at first', () => {
  for (const row of ROWS) {
    expect(madeOf(row).settings, row.id).toEqual(settingsOf(PREFERENCE_DEFAULTS));
  }
});

it('has no model left over', () => {
  const files = existsSync(resolve(GALLERY, 'made')) ? readdirSync(resolve(GALLERY, 'made')) : [];
  expect(files.sort()).toEqual(ROWS.map(({ id }) => `${id}.made`).sort());
});
