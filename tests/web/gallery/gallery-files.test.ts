import { existsSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { DRAWINGS } from '../../../scripts/drawings/list.mjs';
import { sketchText } from '../../../scripts/drawings/pen.mjs';
import papers from '../../../scripts/experiments/papers-sketches.json';
import { readSketchValue } from '../../../web/src/state/read-sketch.ts';

const FOLDER = new URL('../../../public/gallery/', import.meta.url);
const read = (name: string): unknown => JSON.parse(readFileSync(new URL(name, FOLDER), 'utf8'));
const { models } = read('index.json') as {
  models: { id: string; file: string; moves: boolean; bricks: number; title: object }[];
};

/** The paper's twenty-four, by our names. */
const PAPER = [
  'print-box airplane long-bow cube house crossbow bird bridge flying-kite claw picker table-lamp',
  'lifter chair-front chair-side little-ferris glasses seesaw bicycle robot tower-3d space-station',
  'castle tower-2d',
].flatMap((row) => row.split(' '));

describe('the gallery', () => {
  it('has the models of the paper and two with gears', () => {
    const ids = models.map((model) => model.id);
    expect(ids).toEqual(expect.arrayContaining(PAPER));
    expect(ids).toEqual(expect.arrayContaining(['gear-box', 'winch']));
    expect(new Set(ids).size).toBe(ids.length);
  });

  it('has the drawings that programs make as these make them', () => {
    for (const [name, draw] of Object.entries(DRAWINGS)) {
      const file = new URL(`${name}.sketch.json`, FOLDER);
      expect(readFileSync(file, 'utf8'), name).toBe(sketchText(draw()));
    }
  });

  // Facts of the public data (lines, and their length in all); the drawings are ours.
  const compared = Object.entries(papers.sketches).filter(([id]) => id in DRAWINGS);
  it.each(compared)(
    'draws %s at least four fifths as rich as the paper',
    (id, { lines, length }) => {
      const drawn = DRAWINGS[id]?.().lines ?? [];
      const lengths = drawn.map(({ from, to }) =>
        Math.hypot(...from.map((x, i) => x - (to[i] ?? 0))),
      );
      expect(drawn.length).toBeGreaterThanOrEqual(0.8 * lines);
      expect(lengths.reduce((sum, x) => sum + x, 0)).toBeGreaterThanOrEqual(0.8 * length);
    },
  );

  it('has at least nine models that move', () => {
    expect(models.filter((model) => model.moves).length).toBeGreaterThanOrEqual(9);
  });

  it.each(models.map((model) => [model.id, model] as const))('has all of %s', (id, model) => {
    expect(readSketchValue(read(model.file)).ok).toBe(true);
    expect(existsSync(new URL(`thumbs/${id}.png`, FOLDER))).toBe(true);
    expect(model.bricks).toBeGreaterThan(0);
    expect(Object.keys(model.title).sort()).toEqual(['de', 'en']);
  });
});
