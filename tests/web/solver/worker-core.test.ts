import { expect, test } from 'vitest';
import type { FromWorker } from '../../../web/src/solver/protocol.ts';
import type { SolverModule, SolverSession } from '../../../web/src/solver/solver-module.ts';
import { createWorkerCore } from '../../../web/src/solver/worker-core.ts';

/** A search of so many steps that finds a better model every 100 steps; refuses the sketch 'bad'. */
function countingModule(steps: number) {
  const slices: number[] = [];
  let open = 0;
  class Session implements SolverSession {
    #at = 0;
    readonly #sketch: string;

    constructor(sketch: string) {
      this.#sketch = sketch;
      open += 1;
    }

    opened() {
      return this.#sketch === 'bad'
        ? ({ status: 'invalidInput', text: 'lines[0]: missing' } as const)
        : ({ status: 'ok', text: '' } as const);
    }

    advance(iterations: number): boolean {
      if (this.#sketch === 'crash') {
        throw new WebAssembly.RuntimeError('unreachable');
      }
      slices.push(iterations);
      this.#at = Math.min(steps, this.#at + iterations);
      return this.#at === steps;
    }

    progressJson() {
      const improvements = Math.floor(this.#at / 100);
      return JSON.stringify({ phase: 'stageTwo', iterations: this.#at, improvements });
    }

    modelJson() {
      return `model ${this.#at}`;
    }

    layoutJson() {
      return 'layout';
    }

    reportJson() {
      return `report ${this.#at}`;
    }

    delete() {
      open -= 1;
    }
  }
  const module: SolverModule = {
    SolverSession: Session,
    checkModelJson: (text) =>
      text === 'bad' ? { status: 'invalidInput', text: 'no model' } : { status: 'ok', text },
    planAssemblyJson: (text) => ({ status: 'ok', text }),
    analyseStressJson: (text, options) => ({ status: 'ok', text: `${text} under ${options}` }),
    analyseMotionJson: (text) => ({ status: 'ok', text: `motion of ${text}` }),
    jointMotionJson: (text, joint) => ({ status: 'ok', text: `joint ${joint} of ${text}` }),
    freeMotionJson: (text, motion) => ({ status: 'ok', text: `motion ${motion} of ${text}` }),
    placementsJson: (text) => ({ status: 'ok', text }),
    findSymmetriesJson: (text) => ({ status: 'ok', text }),
    partPlacesJson: (text, layout) => ({ status: 'ok', text: `places of ${text} on ${layout}` }),
    fittingPartsJson: (text, _layout, _settings, part) => ({
      status: 'ok',
      text: `fits for ${part} of ${text}`,
    }),
    exportModel: (text, format) => ({ status: 'ok', text: `${text} as ${format}` }),
    contractJson: () => '{}',
  };
  return { module, slices, openSessions: () => open };
}

/** A host whose clock runs one millisecond per look, so that tests do not depend on the machine. */
function steppedHost(lastWords = '') {
  const replies: FromWorker[] = [];
  let ms = 0;
  return {
    replies,
    host: {
      post: (reply: FromWorker) => void replies.push(reply),
      now: () => {
        ms += 1;
        return ms;
      },
      pause: () => new Promise<void>((resolve) => setImmediate(resolve)),
      lastWords: () => lastWords,
    },
  };
}

const START = { kind: 'start', jobId: 1, sketchJson: '{}', settings: {} } as const;

test('a search ends with one solved reply and frees its session', async () => {
  const { module, openSessions } = countingModule(100_000);
  const { host, replies } = steppedHost();
  await createWorkerCore(Promise.resolve(module), host).handle(START);
  expect(replies.filter(({ kind }) => kind !== 'progress')).toMatchObject([
    {
      kind: 'solved',
      jobId: 1,
      modelJson: 'model 100000',
      reportJson: 'report 100000',
      layoutJson: 'layout',
    },
  ]);
  expect(openSessions()).toBe(0);
});

test('slices grow while they are short', async () => {
  const { module, slices } = countingModule(100_000);
  const { host } = steppedHost();
  await createWorkerCore(Promise.resolve(module), host).handle(START);
  expect(slices.slice(0, 3)).toEqual([64, 256, 1024]);
});

test('a model is sent only when it is new, and never twice', async () => {
  const { module } = countingModule(1 << 30);
  const { host, replies } = steppedHost();
  await createWorkerCore(Promise.resolve(module), host).handle(START);
  const models = replies.flatMap((r) =>
    r.kind === 'progress' && r.modelJson ? [r.modelJson] : [],
  );
  expect(models.length).toBeGreaterThan(0);
  expect(new Set(models).size).toBe(models.length);
  expect(models.length).toBeLessThan(replies.length);
});

test('a cancel ends the search between two slices', async () => {
  const { module, openSessions } = countingModule(Number.MAX_SAFE_INTEGER);
  const { host, replies } = steppedHost();
  const core = createWorkerCore(Promise.resolve(module), host);
  const search = core.handle(START);
  await host.pause();
  await core.handle({ kind: 'cancel', jobId: 1 });
  await search;
  expect(replies.at(-1)).toEqual({ kind: 'cancelled', jobId: 1 });
  expect(openSessions()).toBe(0);
});

test('a cancel of a job that has ended leaves the next job of that number alone', async () => {
  const { module } = countingModule(1000);
  const { host, replies } = steppedHost();
  const core = createWorkerCore(Promise.resolve(module), host);
  await core.handle({ kind: 'cancel', jobId: 1 });
  await core.handle(START);
  expect(replies.at(-1)?.kind).toBe('solved');
});

test('questions are answered while a search runs', async () => {
  const { module } = countingModule(1 << 26);
  const { host, replies } = steppedHost();
  const core = createWorkerCore(Promise.resolve(module), host);
  const search = core.handle(START);
  await core.handle({ kind: 'export', jobId: 2, modelJson: 'm', format: 'mpd' });
  expect(replies.at(-1)).toEqual({ kind: 'exported', jobId: 2, text: 'm as mpd' });
  await search;
  expect(replies.at(-1)?.kind).toBe('solved');
});

test('bad input is refused with the message of the module', async () => {
  const { module, openSessions } = countingModule(10);
  const { host, replies } = steppedHost();
  const core = createWorkerCore(Promise.resolve(module), host);
  await core.handle({ ...START, sketchJson: 'bad' });
  await core.handle({ kind: 'check', jobId: 2, modelJson: 'bad' });
  expect(replies).toEqual([
    { kind: 'refused', jobId: 1, message: 'lines[0]: missing' },
    { kind: 'refused', jobId: 2, message: 'no model' },
  ]);
  expect(openSessions()).toBe(0);
});

test('a crash is reported with the last line of the module', async () => {
  const { module, openSessions } = countingModule(10);
  const { host, replies } = steppedHost('layout.cpp:7: check failed');
  await createWorkerCore(Promise.resolve(module), host).handle({ ...START, sketchJson: 'crash' });
  expect(replies).toEqual([
    { kind: 'failed', jobId: 1, message: 'unreachable (layout.cpp:7: check failed)' },
  ]);
  expect(openSessions()).toBe(0);
});

test('a module that does not load fails the job', async () => {
  const { host, replies } = steppedHost();
  const core = createWorkerCore(Promise.reject(new Error('404')), host);
  await core.handle(START);
  expect(replies).toEqual([{ kind: 'failed', jobId: 1, message: '404' }]);
});
