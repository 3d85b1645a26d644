// What a sketch keeps, through the module that the page ships (docs/keep.md).
import { describe, expect, it } from 'vitest';
import type { Place } from '../../web/src/model/keep.ts';
import type { Report } from '../../web/src/model/report.ts';
import type { SketchDocument } from '../../web/src/model/sketch.ts';
import { barPart, keepPart, setLayers, swapPart } from '../../web/src/state/keeps.ts';
import { loadModule } from './module.ts';

const module = await loadModule();

const PORTAL: SketchDocument = {
  format: 'technic-sketch',
  version: 1,
  lines: [
    { from: [0, 0, 0], to: [0, 0, 8] },
    { from: [8, 0, 0], to: [8, 0, 8] },
    { from: [0, 0, 8], to: [8, 0, 8] },
    { from: [0, 0, 5], to: [4, 0, 8] },
    { from: [0, 0, 0], to: [8, 0, 0] },
  ],
};

interface Solved {
  readonly model: string;
  readonly layout: string;
  readonly report: Report;
  readonly places: readonly (Place | null)[];
}

function solve(sketch: SketchDocument, settings: object): Solved {
  const session = new module.SolverSession(JSON.stringify(sketch), JSON.stringify(settings));
  try {
    expect(session.opened().text).toBe('');
    while (!session.advance(100_000)) {}
    const [model, layout] = [session.modelJson(), session.layoutJson()];
    const { places } = JSON.parse(module.partPlacesJson(model, layout, '{}').text) as Solved;
    return { model, layout, report: JSON.parse(session.reportJson()) as Report, places };
  } finally {
    session.delete();
  }
}

const first = solve(PORTAL, { seed: 1 });
const beams = first.places.filter((place) => place !== null);

function has({ places }: Solved, wanted: Place): boolean {
  return places.some((place) => JSON.stringify(place) === JSON.stringify(wanted));
}

describe('what is kept', () => {
  it.each(beams.map((place) => [place]))('stays with another seed: %j', (place) => {
    const again = solve(keepPart(PORTAL, place), { seed: 7 });
    expect(has(again, place)).toBe(true);
    expect(again.report.buildable).toBe(true);
  });

  it('stays when the rest is solved around it', () => {
    const [place, other] = beams;
    if (!place || !other) {
      throw new Error('the portal has two beams at least');
    }
    const sketch = barPart(keepPart(PORTAL, place), other);
    const again = solve(sketch, { seed: 1, earlier: JSON.parse(first.layout) as unknown });
    expect(has(again, place)).toBe(true);
    expect(has(again, other)).toBe(false);
    expect(again.report).toMatchObject({ buildable: true, grown: true });
  });
});

it('every beam that may lie in place of another is laid there when it is kept', () => {
  const index = first.places.findIndex((place) => place?.line === 2);
  const place = first.places[index];
  const answer = module.fittingPartsJson(first.model, first.layout, '{}', index);
  const { fits } = JSON.parse(answer.text) as { fits: readonly Place[] };
  expect(fits.length).toBeGreaterThan(2);
  for (const fit of place ? fits.slice(0, 6) : []) {
    const again = solve(swapPart(PORTAL, place as Place, fit), {
      seed: 1,
      set: { rounds: 2 },
      earlier: JSON.parse(first.layout) as unknown,
    });
    expect(has(again, fit), JSON.stringify(fit)).toBe(true);
  }
});

it('beams lie on the side that is wanted', () => {
  const again = solve(setLayers(PORTAL, 2, [1, 2]), { seed: 1 });
  const layers = again.places.flatMap((place) => (place?.line === 2 ? [place.part.layer] : []));
  expect(Math.min(...layers)).toBeGreaterThan(0);
  expect(again.report.buildable).toBe(true);
});

it('what cannot be kept is named with its line and its place', () => {
  const place: Place = {
    line: 2,
    part: { part: '32524', from: 0, to: 8, layer: 0, holeAxis: 'y' },
  };
  const { report } = solve(keepPart(PORTAL, place), { seed: 1 });
  expect(report.buildable).toBe(false);
  expect(report.problems?.[0]).toMatchObject({ kind: 'keep', line: 2, at: [4, 0, 8] });
});
