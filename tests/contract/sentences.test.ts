import { beforeAll, describe, expect, it } from 'vitest';
import type { SolverModule } from '../../web/src/solver/solver-module.ts';
import { PHRASES_DE, SENTENCES_DE } from '../../web/src/ui/text/de/sentences.ts';
import { makeInterpreter } from '../../web/src/ui/text/sentences.ts';
import { exampleNames, exampleText, loadModule, solveWithModule } from './module.ts';

const german = makeInterpreter(SENTENCES_DE, PHRASES_DE);

/** English that is left over; what stands in quotes is the file's own, in brackets the name of a part. */
const ENGLISH = /\b(the|expected|found|missing|should|cannot|needed|held|nothing|are|must|with)\b/;

function stillEnglish(sentence: string): boolean {
  const said = german(sentence);
  // The place in the file is no English, though a member is called `with`.
  let bare = said.replace(/^\w+\[\d+\][\w.[\]]*: /, '').replace(/"[^"]*"/g, '');
  for (let inner = ''; inner !== bare; ) {
    inner = bare;
    bare = inner.replace(/\([^()]*\)/g, '');
  }
  return said === sentence || ENGLISH.test(bare);
}

const WRONG: readonly unknown[] = [
  undefined,
  null,
  'x',
  -1,
  1e9,
  2.5,
  [],
  [0, 0],
  {},
  true,
  [[0]],
  [0, 0, 0],
  [1, 2, 3],
];

type Json = Record<string, unknown> | unknown[];

/** Every copy of a document in which one value is missing or wrong. */
function* mutations(document: Json, root: Json = document): Generator<string> {
  for (const [key, value] of Object.entries(document)) {
    const holder = document as Record<string, unknown>;
    for (const wrong of WRONG) {
      holder[key] = wrong;
      yield JSON.stringify(root);
    }
    holder[key] = value;
    if (typeof value === 'object' && value !== null) {
      yield* mutations(value as Json, root);
    }
  }
}

const SKETCH = {
  format: 'technic-sketch',
  version: 2,
  name: 'frame',
  lines: [
    { from: [0, 0, 0], to: [4, 0, 0], exact: true },
    { from: [4, 0, 0], to: [4, 0, 4], holeAxis: 'y' },
    { from: [4, 0, 4], to: [0, 0, 4] },
  ],
  joints: [
    { at: [4, 0, 0], axis: [0, 1, 0], between: [[0], [1]], kind: 'hinge', range: [-30, 60] },
  ],
  symmetries: [
    { kind: 'reflection', normal: [1, 0, 0], offset: 2, lines: [0] },
    { kind: 'translation', vector: [0, 0, 4], pairs: [[0, 2]] },
  ],
  keepOut: [{ min: [8, 8, 8], max: [9, 9, 9] }],
  ground: 0,
  keep: [
    {
      line: 0,
      parts: [
        {
          part: '32316',
          from: 0,
          to: 4,
          layer: 1,
          holeAxis: 'y',
          with: [{ line: 1, from: 0, to: 2 }],
        },
      ],
      barred: [{ part: '32316', from: 0, to: 4 }],
      layers: [0, 1],
      splits: [2],
    },
  ],
  colours: {
    scheme: 'length',
    default: 71,
    kinds: { pin: 0 },
    lines: { 1: 4 },
    parts: [{ part: '32316', at: [2, 0, 1], colour: 4 }],
  },
};

/** Shafts that stand in two beams; where they cannot turn is said after all else is read. */
const TURNING = {
  format: 'technic-sketch',
  version: 2,
  lines: [
    { from: [0, 0, 0], to: [8, 0, 0] },
    { from: [0, 3, 0], to: [8, 3, 0] },
    { from: [0, 0, 0], to: [0, 3, 0] },
  ],
  shafts: [
    { from: [2, -1, 0], to: [2, 4, 0] },
    { from: [5, -1, 0], to: [5, 4, 0] },
  ],
  drives: [{ from: 0, to: 1, ratio: 5, tolerance: 2 }],
};

/** What no shaft can do. */
const STUCK: readonly Record<string, unknown>[] = [
  { shafts: [{ from: [0, -1, 0], to: [0, 4, 0] }] },
  { shafts: [{ from: [2, -1, 0], to: [2, 2, 0] }] },
  { shafts: [{ from: [2, 0, -1], to: [2, 0, 4] }] },
  { shafts: [TURNING.shafts[0], TURNING.shafts[0]], drives: [] },
  { drives: [...TURNING.drives, ...TURNING.drives] },
  { drives: [{ from: 0, to: 1, ratio: 4.5 }] },
  { lines: [...TURNING.lines, { from: [2, -1, 1], to: [2, -1, 6] }], drives: [] },
  { lines: [...TURNING.lines, { from: [1.5, 1, 0], to: [4.5, 1, 0] }], drives: [] },
];

const TEXTS = [
  '',
  '{',
  '[1',
  '{"a": NaN}',
  '{"a": 1e999}',
  '{"a": 1, "a": 2}',
  'lines',
  '[]',
  '{"a" 1}',
  '['.repeat(200),
];

describe('the German of the core', () => {
  let module: SolverModule;
  beforeAll(async () => {
    module = await loadModule();
  });

  function refusal(sketch: string, settings = '{}'): string | null {
    const session = new module.SolverSession(sketch, settings);
    try {
      const { status, text } = session.opened();
      return status === 'ok' ? null : text;
    } finally {
      session.delete();
    }
  }

  it('covers what is said against a sketch', () => {
    const said = new Set<string>();
    const texts = [
      ...TEXTS,
      ...mutations(structuredClone(SKETCH)),
      ...mutations(structuredClone(TURNING)),
      ...STUCK.map((change) => JSON.stringify({ ...TURNING, ...change })),
    ];
    for (const text of texts) {
      const message = refusal(text);
      if (message !== null) {
        said.add(message);
      }
    }
    expect(said.size).toBeGreaterThan(100);
    expect([...said].filter(stillEnglish)).toEqual([]);
  });

  it('covers what is said against settings', () => {
    const settings = {
      seed: 1,
      preset: 'simple',
      method: 'default',
      set: {
        starts: 1,
        connectors: '2780',
        lengths: '3',
        'search.orbits': 1,
        'owned.32525': 1,
        'weights.beams': 1,
      },
    };
    const texts = [
      ...mutations(structuredClone(settings)),
      '[]',
      '{"other": 1}',
      '{"set": {"x": 1}}',
      '{"set": {"owned.1": 1}}',
      '{"set": {"lengths": "4"}}',
      '{"set": {"connectors": "32525"}}',
    ];
    const said = texts.flatMap((text) => refusal(exampleText('airplane'), text) ?? []);
    expect(said.length).toBeGreaterThan(20);
    expect([...new Set(said)].filter(stillEnglish)).toEqual([]);
  });

  it('covers what is said about models, sound and broken ones', () => {
    const said = new Set<string>();
    const hear = (text: string) => {
      const check = JSON.parse(text) as {
        items: { title: string; detail: string }[];
        problems: { message: string }[];
        wellBuilt: { items: { title: string; detail: string; places: { message: string }[] }[] };
      };
      for (const { title, detail } of [...check.items, ...check.wellBuilt.items]) {
        said.add(title).add(detail);
      }
      const places = check.wellBuilt.items.flatMap((item) => item.places);
      for (const { message } of [...check.problems, ...places]) {
        said.add(message);
      }
    };
    for (const name of exampleNames()) {
      const { modelJson } = solveWithModule(module, exampleText(name), { set: { rounds: 0 } });
      const model = JSON.parse(modelJson) as {
        parts: { part: string; position: number[]; rotation: number[] }[];
      };
      for (const change of [
        () => undefined,
        () => model.parts.splice(1, 3),
        () => model.parts[0]?.position.splice(0, 1, 99),
        () => model.parts[1]?.position.splice(2, 1, -40),
        () => model.parts[2]?.rotation.splice(0, 1, 5),
        () => Object.assign(model.parts[3] ?? {}, { part: '99999' }),
      ]) {
        change();
        const reply = module.checkModelJson(JSON.stringify(model));
        expect(reply.status).toBe('ok');
        hear(reply.text);
      }
    }
    said.delete('');
    expect(said.size).toBeGreaterThan(30);
    expect([...said].filter(stillEnglish)).toEqual([]);
  });

  /** What is said of a model's joints, braces and stress. */
  function studied(modelJson: string): string[] {
    const motion = JSON.parse(module.analyseMotionJson(modelJson).text) as {
      joints: { message: string }[];
      braces: { message: string }[];
    };
    const stress = ['held', 'free', 'locked'].map((friction) => {
      const loads = friction === 'held' ? [{ at: [0, 0, 99], force: [9, 0, 0] }] : [];
      const { status, text } = module.analyseStressJson(
        modelJson,
        JSON.stringify({ friction, loads }),
      );
      return status === 'ok' ? (JSON.parse(text) as { message: string }).message : text;
    });
    return [...[...motion.joints, ...motion.braces].map(({ message }) => message), ...stress];
  }

  it('covers what is said of joints, free motions and stress', () => {
    const said = new Set<string>();
    for (const name of exampleNames()) {
      const { modelJson } = solveWithModule(module, exampleText(name), { set: { rounds: 0 } });
      for (const message of studied(modelJson)) {
        said.add(message);
      }
    }
    const empty = '{"format": "liftarm-model", "version": 1, "parts": []}';
    for (const options of [
      '[]',
      '{"friction": 1}',
      '{"heldStiffness": 0}',
      '{"loads": 1}',
      '{"loads": [{}]}',
      '{"loads": [{"at": [0]}]}',
    ]) {
      said.add(module.analyseStressJson(empty, options).text);
    }
    said.delete('');
    expect(said.size).toBeGreaterThan(10);
    expect([...said].filter(stillEnglish)).toEqual([]);
  });
});
