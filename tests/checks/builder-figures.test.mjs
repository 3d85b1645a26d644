import { expect, test } from 'vitest';
import { figuresOf, totals, verdicts } from '../../scripts/lib/builder-figures.mjs';

const item = (id, ok, figures, applies = true) => ({ id, ok, applies, figures });

/** A model of ten beams and a hundred heads, of which `naked` are. */
const model = ({ naked = 0, falls = 0, loose = 0, symmetric = true, beams = 10 } = {}) => ({
  buildable: true,
  beams,
  bound: 10,
  seconds: 2,
  figures: figuresOf({
    passed: 6,
    of: 6,
    items: [
      item('faithful', true, { meanLayer: 0.2 }),
      item('stands', falls === 0, {
        flatBase: 1,
        couldStand: 1,
        belowBase: 0,
        liftedFeet: 0,
        fallsOver: falls,
      }),
      item('stiff', loose === 0, { freedomsBeyondJoints: loose, beamsOnOneAxis: 0 }),
      item('clean', naked === 0, { nakedHeads: naked, heads: 100, nakedPinHeads: 0, pinHeads: 90 }),
      item('symmetric', symmetric === true, { mirroredBeams: 10, beams: 10 }, symmetric !== null),
      item('few', true, { parts: 30, kinds: 5, idleParts: 0 }),
    ],
  }),
});

const failing = (runs) =>
  verdicts(totals(runs))
    .filter(({ ok }) => !ok)
    .map(({ title }) => title);

test('models that a builder would build pass everything', () => {
  expect(failing([model(), model()])).toEqual([]);
});

test('heads are counted over all models, not averaged over them', () => {
  expect(totals([model({ naked: 10 }), model()]).nakedHeads).toBe(5);
});

test('each figure that is missed is named', () => {
  expect(failing([model({ naked: 3 })])).toEqual(['heads that sit in nothing']);
  expect(failing([model({ falls: 1 })])).toEqual(['models that fall over and need not']);
  expect(failing([model({ loose: 2 })])).toEqual(['no freedom beyond the joints']);
  expect(failing([model({ symmetric: false })])).toEqual(['symmetric of symmetric drawings']);
  expect(failing([model({ beams: 11 })])).toEqual(['beams over the bound, mean']);
});

test('nothing is asked of what no drawing has', () => {
  const all = totals([model({ symmetric: null })]);
  expect(all.symmetric).toBeNull();
  expect(failing([model({ symmetric: null })])).toEqual([]);
});

test('one model in ten may keep a freedom', () => {
  const runs = Array.from({ length: 10 }, (_, i) => model({ loose: i === 0 ? 1 : 0 }));
  expect(failing(runs)).toEqual([]);
});
