import { describe, expect, it } from 'vitest';
import { IDENTITY, type Vec3 } from '../../../web/src/geometry/vec.ts';
import { type AssemblyPlan, readPlan } from '../../../web/src/instructions/assembly-plan.ts';
import { buildSteps, replayFaults, timesOf } from '../../../web/src/instructions/build-steps.ts';
import { filmOffsets, flightOffset } from '../../../web/src/instructions/flight.ts';

const MODEL = {
  name: '',
  parts: ['32316', '2780', '2780', '32316', '3673'].map((part) => ({
    part,
    color: 0,
    position: [0, 0, 0] as const,
    rotation: IDENTITY,
    component: -1,
    layer: 0,
    piece: 0,
  })),
};

const add = (parts: number[], travel: Vec3, subgroup: number | null = null) => ({
  parts,
  travel,
  subgroup,
});

/** Parts 0, 1 and 2 are built apart; then 3 gets that and part 4. */
const JSON_PLAN = {
  assemblable: true,
  groups: [
    { id: 0, parts: [0, 1, 2, 3, 4], copies: [], mirrored: [] },
    { id: 1, parts: [0, 1, 2], copies: [], mirrored: [] },
  ],
  steps: [
    { group: 1, adds: [add([0], [0, 0, 0])], stable: true },
    { group: 1, adds: [add([1], [0, 0, -2])], stable: true },
    { group: 1, adds: [add([2], [0, 0, -2])], stable: true },
    { group: 0, adds: [add([3], [0, 0, 0])], stable: true },
    { group: 0, adds: [add([0, 1, 2], [0, -3, 0], 1)], stable: false },
    { group: 0, adds: [add([4], [2, 0, 0])], stable: true },
  ],
  stuck: [],
};

function plan(json: unknown = JSON_PLAN): AssemblyPlan {
  const read = readPlan(JSON.stringify(json), MODEL.parts.length);
  if (!read.ok) {
    throw new Error(read.message);
  }
  return read.value;
}

describe('building steps', () => {
  it('join single parts that come from one side', () => {
    const steps = buildSteps(plan(), MODEL);
    expect(steps.map((step) => step.adds.flatMap((a) => a.parts))).toEqual([
      [0, 1, 2],
      [3],
      [0, 1, 2],
      [4],
    ]);
  });

  it.each([1, 2, 3, 6])('ask for %i parts at most, in the same order', (most) => {
    const many = plan({
      ...JSON_PLAN,
      groups: [{ id: 0, parts: [0, 1, 2, 3, 4], copies: [], mirrored: [] }],
      steps: [{ group: 0, adds: [0, 1, 2, 3, 4].map((i) => add([i], [0, 0, -2])), stable: true }],
    });
    const pages = buildSteps(many, MODEL, most).map((step) => step.adds.map((a) => a.parts[0]));
    expect(pages.flat()).toEqual([0, 1, 2, 3, 4]);
    expect(pages.length).toBe(Math.ceil(5 / most));
    expect(Math.max(...pages.map((page) => page.length))).toBeLessThanOrEqual(most);
    // No page of one beside a page of six.
    const sizes = pages.map((page) => page.length);
    expect(Math.max(...sizes) - Math.min(...sizes)).toBeLessThanOrEqual(1);
  });

  it('tell what to take, without what was built apart', () => {
    const steps = buildSteps(plan(), MODEL);
    expect(steps[0]?.loose.map(({ part, count }) => [part, count])).toEqual([
      ['2780', 2],
      ['32316', 1],
    ]);
    expect(steps[2]?.loose).toEqual([]);
    expect(steps[2]?.putIns.map(({ group, count }) => [group, count])).toEqual([[1, 1]]);
  });

  it('show in each step what the same group holds already', () => {
    expect(buildSteps(plan(), MODEL).map((step) => step.before)).toEqual([
      [],
      [],
      [3],
      [3, 0, 1, 2],
    ]);
  });

  it('count how often a group is built', () => {
    expect(timesOf({ id: 1, parts: [0], copies: [[1], [2]], mirrored: [false, true] })).toBe(3);
  });
});

describe('the replay', () => {
  it('finds nothing wrong with a complete plan', () => {
    expect(replayFaults(plan(), 5)).toEqual([]);
  });

  it('finds a part that is left out', () => {
    const steps = JSON_PLAN.steps.slice(0, -1);
    expect(replayFaults(plan({ ...JSON_PLAN, steps }), 5).join()).toContain('part 4');
  });

  it('finds a subassembly that is used too early', () => {
    const steps = [...JSON_PLAN.steps.slice(3), ...JSON_PLAN.steps.slice(0, 3)];
    expect(replayFaults(plan({ ...JSON_PLAN, steps }), 5).join()).toContain('not built yet');
  });
});

describe('reading a plan', () => {
  it.each([
    ['{', 'JSON'],
    ['{"groups":[],"steps":[{"group":0,"adds":[{"parts":[9],"travel":[0,0,0]}]}]}', 'parts[0]'],
    ['{"groups":[],"steps":[{"group":0,"adds":[{"parts":[1],"travel":[0,0]}]}]}', 'travel'],
    ['{"groups":[]}', 'steps'],
  ])('refuses %s', (json, message) => {
    const read = readPlan(json, 5);
    expect(read.ok ? '' : read.message).toContain(message);
  });
});

describe('the film', () => {
  it('begins a part away from its place by all of its moves', () => {
    const addition = { ...add([1], [0, 0, -2]), via: [[3, 0, 0] as Vec3], forced: false };
    expect(flightOffset(addition, 0)).toEqual([-3, 0, 2]);
    expect(flightOffset(addition, 1)).toEqual([0, 0, 0]);
  });

  it('lets a part built apart wait beside its place', () => {
    const adds = plan().steps.flatMap((step) => step.adds);
    expect(filmOffsets(adds, 3).get(1)).toEqual([0, 3, 0]);
    expect(filmOffsets(adds, 5).get(1)).toEqual([0, 0, 0]);
    expect(filmOffsets(adds, 5).has(4)).toBe(false);
  });
});
