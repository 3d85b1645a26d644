import { expect, test } from 'vitest';
import type { FromWorker } from '../../web/src/solver/protocol.ts';
import { createWorkerCore } from '../../web/src/solver/worker-core.ts';
import { exampleText, loadModule, solveWithModule } from './module.ts';

/** The worker's core on the real module, with the real clock. */
function realWorker() {
  const replies: FromWorker[] = [];
  const core = createWorkerCore(loadModule(), {
    post: (reply) => void replies.push(reply),
    now: () => performance.now(),
    pause: () => new Promise((resolve) => setImmediate(resolve)),
    lastWords: () => '',
  });
  return { core, replies };
}

const start = (jobId: number, name: string, seed = 1) =>
  ({ kind: 'start', jobId, sketchJson: exampleText(name), settings: { seed } }) as const;

test('a worker gives the model that the module gives in one go', async () => {
  const { core, replies } = realWorker();
  await core.handle(start(1, 'house', 4));
  const alone = solveWithModule(await loadModule(), exampleText('house'), { seed: 4 });
  expect(replies.at(-1)).toMatchObject({ kind: 'solved', modelJson: alone.modelJson });
});

test('models shown on the way are models that the checker reads', async () => {
  const { core, replies } = realWorker();
  await core.handle(start(1, 'cube'));
  const shown = replies.flatMap((r) => (r.kind === 'progress' && r.modelJson ? [r.modelJson] : []));
  expect(shown.length).toBeGreaterThan(0);
  await core.handle({ kind: 'check', jobId: 2, modelJson: shown[0] ?? '' });
  expect(replies.at(-1)?.kind).toBe('checked');
});

test('a large search stops between two slices', async () => {
  const { core, replies } = realWorker();
  const search = core.handle(start(1, 'airplane'));
  setImmediate(() => core.handle({ kind: 'cancel', jobId: 1 }));
  await search;
  expect(replies.at(-1)).toEqual({ kind: 'cancelled', jobId: 1 });
});

test('a bad sketch is refused and the worker goes on', async () => {
  const { core, replies } = realWorker();
  await core.handle({ kind: 'start', jobId: 1, sketchJson: '[]', settings: {} });
  await core.handle(start(2, 'square-frame'));
  expect(replies.filter(({ kind }) => kind !== 'progress').map(({ kind }) => kind)).toEqual([
    'refused',
    'solved',
  ]);
});

test('whether a search can begin is told without one', async () => {
  const { core, replies } = realWorker();
  const at = [0, 0, 0];
  const lines = [
    { from: [-6, 0, 0], to: at },
    { from: at, to: [6, 0, 0] },
  ];
  const sketch = (axes: readonly (readonly number[])[]) =>
    JSON.stringify({
      format: 'technic-sketch',
      version: 1,
      lines,
      joints: axes.map((axis) => ({ at, axis, between: [[0], [1]] })),
    });
  const asked = async (...axes: readonly (readonly number[])[]) => {
    const question = { about: 'opens', sketchJson: sketch(axes), settings: {} } as const;
    await core.handle({ kind: 'ask', jobId: 1, question });
    return replies.at(-1);
  };
  expect(await asked([0, 1, 0])).toMatchObject({ kind: 'answered' });
  expect(await asked([0, 1, 0], [0, 0, 1])).toMatchObject({
    kind: 'refused',
    message: expect.stringMatching(/^joints\[1\]: lines cannot turn about two axes/),
  });
});
