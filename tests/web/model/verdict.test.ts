import { describe, expect, it } from 'vitest';
import { type VerdictInput, verdictOf } from '../../../web/src/model/verdict.ts';

const GOOD: VerdictInput = {
  faults: 0,
  buildable: true,
  items: [{ id: 'joints', title: 'Every joint turns', ok: true, detail: '' }],
  problems: [],
  pieces: 1,
  missing: 0,
  stands: true,
  joints: 1,
};

const BAD_WORK = {
  id: 'clean',
  title: 'Clean',
  ok: false,
  applies: true,
  detail: '3 heads hold nothing',
  figures: {},
  places: [],
};

function lamp(input: VerdictInput, id: string) {
  return verdictOf(input).lamps.find((each) => each.id === id)?.state;
}

describe('the verdict', () => {
  it('is good when nothing is known to be wrong', () => {
    expect(verdictOf(GOOD)).toMatchObject({ tone: 'ok', first: null });
  });

  it.each([
    ['lines that look joined and are not', { faults: 1 }, 'warn', 'fault'],
    ['those in a model that fails', { faults: 1, buildable: false }, 'bad', 'fault'],
    ['a model that fails a check', { buildable: false }, 'bad', 'item'],
    ['parts that are missing', { missing: 2 }, 'warn', 'missing'],
    ['two pieces', { pieces: 2 }, 'warn', 'pieces'],
    ['a model that falls over', { stands: false }, 'warn', 'falls'],
    ['poor building', { wellBuilt: [BAD_WORK] }, 'warn', 'wellBuilt'],
  ] as const)('is not good for %s, and says that first', (_, change, tone, kind) => {
    expect(verdictOf({ ...GOOD, ...change })).toMatchObject({ tone, first: { kind } });
  });

  it('names what must be mended before the rest', () => {
    const input = { ...GOOD, pieces: 2, stands: false, wellBuilt: [BAD_WORK] };
    expect(verdictOf(input).first?.kind).toBe('pieces');
    expect(verdictOf({ ...input, faults: 1 }).first?.kind).toBe('fault');
  });

  it('has nothing green over a model that fails', () => {
    const { lamps } = verdictOf({
      ...GOOD,
      buildable: false,
      wellBuilt: [{ ...BAD_WORK, ok: true }],
    });
    expect(lamps[0]?.state).toBe('bad');
    expect(lamps.filter(({ state }) => state === 'ok')).toEqual([]);
  });

  it('has no lamp for what is not judged, and an unlit one for what does not apply', () => {
    expect(lamp(GOOD, 'wellBuilt')).toBeUndefined();
    expect(lamp({ ...GOOD, joints: 0 }, 'moves')).toBe('none');
    expect(lamp({ ...GOOD, stands: undefined }, 'stands')).toBe('none');
  });

  it('does not count against a model what its drawing does not ask for', () => {
    const wellBuilt = [{ ...BAD_WORK, applies: false }];
    expect(verdictOf({ ...GOOD, wellBuilt })).toMatchObject({ tone: 'ok', first: null });
  });
});
