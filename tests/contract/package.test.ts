import { afterEach, expect, test } from 'vitest';
import { InputError, Liftarm } from '../../web/src/package/liftarm.ts';
import type { FromWorker } from '../../web/src/solver/protocol.ts';
import { createWorkerClient, type WorkerPort } from '../../web/src/solver/worker-client.ts';
import { createWorkerCore } from '../../web/src/solver/worker-core.ts';
import { exampleText, loadModule, solveWithModule } from './module.ts';

/** The package over the real module, its worker in this thread. */
function startHere(): WorkerPort {
  const port: WorkerPort = {
    postMessage: (message) => void core.handle(message),
    terminate: () => {
      port.onmessage = null;
    },
    onmessage: null,
    onerror: null,
    onmessageerror: null,
  };
  const core = createWorkerCore(loadModule(), {
    post: (data: FromWorker) => port.onmessage?.({ data }),
    now: () => performance.now(),
    pause: () => new Promise((resolve) => setImmediate(resolve)),
    lastWords: () => '',
  });
  return port;
}

let liftarm: Liftarm | null = null;

function open(): Liftarm {
  liftarm = new Liftarm(createWorkerClient({ startWorker: startHere, cancelPatienceMs: 60_000 }));
  return liftarm;
}

afterEach(() => liftarm?.close());

test('the package gives the model that the module gives', async () => {
  const { model } = await open().solve(exampleText('house'), { seed: 4 });
  const alone = solveWithModule(await loadModule(), exampleText('house'), { seed: 4 });
  expect(model).toEqual(JSON.parse(alone.modelJson));
});

test('a model that went through an object is judged as the file is', async () => {
  const engine = open();
  const { model, report } = await engine.solve(exampleText('square-frame'));
  const { buildable } = await engine.check(model);
  expect(buildable).toBe(report.buildable);
});

test('every question about a model is answered', async () => {
  const engine = open();
  const { model } = await engine.solve(exampleText('square-frame'));
  expect((await engine.planAssembly(model)).assemblable).toBe(true);
  expect((await engine.analyseMotion(model)).groups).toHaveLength(model.parts.length);
  expect((await engine.analyseStress(model)).ok).toBeTypeOf('boolean');
  expect(await engine.exportModel(model, 'mpd')).toContain('0 FILE');
});

test('what is refused rejects with the place', async () => {
  const sketch = {
    format: 'technic-sketch',
    version: 1,
    lines: [{ from: [0, 0, 0], to: [4.5, 0, 0] }],
  };
  const solving = open().solve(JSON.stringify(sketch));
  await expect(solving).rejects.toThrow(InputError);
  await expect(solving).rejects.toThrow('lines[0]');
});

test('an aborted search rejects with the reason of its signal', async () => {
  const stop = new AbortController();
  const solving = open().solve(exampleText('airplane'), {
    signal: stop.signal,
    onProgress: () => stop.abort(new Error('enough')),
  });
  await expect(solving).rejects.toThrow('enough');
});

test('a closed engine rejects what was open', async () => {
  const engine = open();
  const solving = engine.solve(exampleText('airplane'));
  engine.close();
  await expect(solving).rejects.toThrow('closed');
});
