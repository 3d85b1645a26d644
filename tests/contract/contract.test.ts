import { beforeAll, describe, expect, test } from 'vitest';
import { brickSetSettings, SET_PARTS } from '../../web/src/model/brick-set.ts';
import { readPlacements } from '../../web/src/solver/proof/placements.ts';
import type { ExportFormat, SolveProgress } from '../../web/src/solver/protocol.ts';
import { SOLVER_STATUSES } from '../../web/src/solver/solver-module.ts';
import { PRESETS } from '../../web/src/state/search-settings.ts';
import { SOLVE_DE } from '../../web/src/ui/text/de/solve.ts';
import { SOLVE_EN } from '../../web/src/ui/text/en/solve.ts';
import { exampleNames, exampleText, loadModule, solveWithModule } from './module.ts';

const module = await loadModule();

/** One value of the type of each field: a field that is missing here does not compile. */
const PROGRESS: SolveProgress = {
  done: false,
  phase: '',
  iterations: 0,
  fraction: 0,
  objective: 0,
  temperature: 0,
  beams: 0,
  gaps: 0,
  collisions: 0,
  failedConnections: 0,
  improvements: 0,
  terms: {},
};

/** Each format of the type: one that is missing here does not compile. */
const FORMATS: Record<ExportFormat, RegExp> = {
  mpd: /^0 FILE /,
  'parts.csv': /^Part,Color,/,
  'wanted.xml': /^<INVENTORY>/,
  'spreadsheet.csv': /^Name,Number,/,
  'assembly.json': /"assemblable"/,
  inp: /^\*HEADING/,
  apdl: /\/PREP7/,
};

const typesOf = (value: object) =>
  Object.fromEntries(Object.entries(value).map(([key, field]) => [key, typeof field]));

test('the statuses of C++ and TypeScript are the same, in the same order', () => {
  expect(JSON.parse(module.contractJson())).toMatchObject({ statuses: [...SOLVER_STATUSES] });
});

test('the page shows every part that the search builds with', () => {
  const { settings } = JSON.parse(module.contractJson());
  // With all but one of a kind switched off, what is left is said in full.
  const named = [
    ...settings.bent,
    ...settings.frames,
    ...new Set([...settings.axles, ...settings.connectors]),
  ];
  const off = new Set(SET_PARTS);
  const left = [settings.bent[0], settings.frames[0], settings.axles[0], settings.connectors[1]];
  expect(brickSetSettings(new Set(SET_PARTS.filter((id) => !left.includes(id))))).toMatchObject({
    bent: settings.bent[0],
    frames: settings.frames[0],
    axles: settings.axles[0],
    connectors: `2780,${settings.connectors[1]}`,
  });
  expect(off.size).toBe(settings.lengths.length + named.length);
  expect(named.filter((id) => !off.has(id))).toEqual([]);
});

test('progress has exactly the fields that TypeScript names, with their types', () => {
  const session = new module.SolverSession(exampleText('square-frame'), '{}');
  session.advance(10);
  const progress = JSON.parse(session.progressJson());
  session.delete();
  expect(typesOf(progress)).toEqual(typesOf(PROGRESS));
});

test('the terms of the objective add up to it, and each has a name in both languages', () => {
  const session = new module.SolverSession(exampleText('square-frame'), '{}');
  while (!session.advance(1000)) {
    // The search goes on.
  }
  const { objective, terms } = JSON.parse(session.progressJson()) as SolveProgress;
  session.delete();
  const sum = Object.values(terms).reduce((all, each) => all + each, 0);
  expect(sum).toBeCloseTo(objective, 6);
  for (const solve of [SOLVE_EN.solve, SOLVE_DE.solve]) {
    expect(Object.keys(solve.term)).toEqual(expect.arrayContaining(Object.keys(terms)));
  }
});

test('the core knows every preset that links and storage may name, and the page names no other', () => {
  for (const preset of PRESETS) {
    const settings = JSON.stringify({ preset });
    const session = new module.SolverSession(exampleText('square-frame'), settings);
    expect([preset, session.opened().status]).toEqual([preset, 'ok']);
    session.delete();
  }
  expect(PRESETS).toEqual(expect.arrayContaining(Object.keys(SOLVE_EN.settings.presets)));
});

test('settings that spell out every default give the same model as no settings', () => {
  const { settings } = JSON.parse(module.contractJson());
  const { seed, preset, method } = settings;
  const sketch = exampleText('cube');
  const spelled = solveWithModule(module, sketch, { seed, preset, method, set: {} });
  expect(spelled.modelJson).toBe(solveWithModule(module, sketch, {}).modelJson);
});

describe('a solved drawing', () => {
  let modelJson = '';

  beforeAll(() => {
    modelJson = solveWithModule(module, exampleText('square-frame'), { seed: 1 }).modelJson;
  });

  test.each(Object.entries(FORMATS))('is exported as %s', (format, start) => {
    expect(module.exportModel(modelJson, format)).toMatchObject({
      status: 'ok',
      text: expect.stringMatching(start),
    });
  });

  test('is checked, with every item of DESIGN 5 that is there named', () => {
    const { status, text } = module.checkModelJson(modelJson);
    expect(status).toBe('ok');
    const check = JSON.parse(text);
    expect(check.buildable).toBe(true);
    expect(check.items.length).toBeGreaterThanOrEqual(5);
  });

  test('is not exported in a format that does not exist', () => {
    expect(module.exportModel(modelJson, 'stl').status).not.toBe('ok');
  });
});

test.each(exampleNames())('the example %s is accepted', (name) => {
  const session = new module.SolverSession(exampleText(name), '{}');
  const opened = session.opened();
  session.delete();
  expect(opened).toEqual({ status: 'ok', text: '' });
});

test.each([
  ['broken JSON', '{"format":', /./],
  ['nothing', '', /./],
  ['another format', '{"format":"x","version":1,"lines":[]}', /technic-sketch/],
  [
    'a length of 4.5',
    '{"format":"technic-sketch","version":1,"lines":[{"from":[0,0,0],"to":[4.5,0,0]}]}',
    /lines\[0\]: length 4\.5 .*4 or 5/,
  ],
])('%s is refused with a message that says why', (_, sketch, message) => {
  const session = new module.SolverSession(sketch, '{}');
  const { status, text } = session.opened();
  session.delete();
  expect(status).not.toBe('ok');
  expect(text).toMatch(message);
});

test('an unknown setting is refused by its name', () => {
  const session = new module.SolverSession(exampleText('cube'), '{"set":{"speed":3}}');
  const { status, text } = session.opened();
  session.delete();
  expect(status).toBe('invalidInput');
  expect(text).toContain('speed');
});

test('a text that is no model is refused by check and export', () => {
  expect(module.checkModelJson('{}').status).toBe('invalidInput');
  expect(module.exportModel('nonsense', 'mpd').status).toBe('invalidInput');
});

test('what may be laid for a sketch is listed for proofs, by the parts in use', () => {
  const listed = (set: object) => {
    const { status, text } = module.placementsJson(exampleText('cube'), JSON.stringify({ set }));
    expect(status).toBe('ok');
    return readPlacements(text);
  };
  const all = listed({});
  expect(new Set(all.covers.map(({ kind }) => kind))).toContain('bent');
  expect(all.covers.every(({ part, parts }) => /^\d+/.test(part) && parts > 0)).toBe(true);
  expect(all.edges[0]).toEqual({ run: 0, index: expect.any(Number) });
  expect(all.quickBound).toBeGreaterThan(0);
  expect(all.rivals.flat().every((c) => all.covers[c]?.kind === 'axle')).toBe(true);
  const few = listed({ 'search.corners': 0, 'search.axles': 0, 'owned.32524': 3 });
  expect(new Set(few.covers.map(({ kind }) => kind))).toEqual(new Set(['straight']));
  expect(few.limits).toEqual([{ part: '32524', owned: 3 }]);
});

test('a cube has symmetries to offer that it does not name, and its own file still reads with them', () => {
  const { status, text } = module.findSymmetriesJson(exampleText('cube'));
  expect(status).toBe('ok');
  const { symmetries } = JSON.parse(text) as { symmetries: { kind: string }[] };
  const named = symmetries.filter(({ kind }) => kind !== 'rotation');
  expect(named.length).toBeGreaterThan(0);
  const sketch = { ...JSON.parse(exampleText('cube')), symmetries: named };
  expect(module.findSymmetriesJson(JSON.stringify(sketch)).status).toBe('ok');
});
