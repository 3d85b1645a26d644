import { expect, test } from 'vitest';
import type { Model } from '../../web/src/model/model.ts';
import type { Report } from '../../web/src/model/report.ts';
import type { SketchDocument } from '../../web/src/model/sketch.ts';
import { exampleText, loadModule } from './module.ts';

const module = await loadModule();

function solve(sketch: SketchDocument, settings: object) {
  const session = new module.SolverSession(JSON.stringify(sketch), JSON.stringify(settings));
  try {
    expect(session.opened().status).toBe('ok');
    while (!session.advance(100_000)) {}
    return {
      model: JSON.parse(session.modelJson()) as Model,
      report: JSON.parse(session.reportJson()) as Report,
      layout: JSON.parse(session.layoutJson()) as unknown,
    };
  } finally {
    session.delete();
  }
}

const placed = ({ parts }: Model) =>
  new Set(parts.map(({ part, position, rotation }) => JSON.stringify([part, position, rotation])));

/** Of the parts of an example's model: how many there are, and how many stay where a line comes to it. */
function afterOneLineMore(name: string) {
  const { symmetries: _confirmed, ...sketch } = JSON.parse(exampleText(name)) as SketchDocument;
  const first = solve(sketch, { seed: 1, preset: 'simple' });
  const [x, y, z] = sketch.lines[0]?.from ?? [0, 0, 0];
  const line = { from: [x, y, z], to: [x, y, z - 4] } as const;
  const more = { ...sketch, lines: [...sketch.lines, line] };
  const grown = solve(more, { seed: 1, preset: 'simple', earlier: first.layout });
  const afresh = solve(more, { seed: 1, preset: 'simple' });
  const before = placed(first.model);
  const kept = (model: Model) => [...placed(model)].filter((part) => before.has(part)).length;
  return {
    all: before.size,
    grown,
    afresh,
    kept: kept(grown.model),
    keptAfresh: kept(afresh.model),
  };
}

test('a line more leaves most parts where they are, and the model as good as a new one', () => {
  const names = ['house', 'table', 'cube', 'airplane', 'cart', 'windmill', 'bridge'];
  let all = 0;
  let kept = 0;
  for (const name of names) {
    const one = afterOneLineMore(name);
    expect(one.grown.report, name).toMatchObject({ grown: true, buildable: true });
    expect(one.afresh.report, name).toMatchObject({ grown: false, buildable: true });
    expect(one.kept, name).toBeGreaterThanOrEqual(one.keptAfresh);
    all += one.all;
    kept += one.kept;
  }
  expect(kept).toBeGreaterThan(0.65 * all);
});
