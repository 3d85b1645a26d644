import { expect, test } from 'vitest';
import type { FromWorker, ToWorker } from '../../web/src/solver/protocol.ts';
import { createSolverPool } from '../../web/src/solver/solver-pool.ts';
import {
  createWorkerClient,
  type SolverClient,
  type WorkerPort,
} from '../../web/src/solver/worker-client.ts';
import { createWorkerCore } from '../../web/src/solver/worker-core.ts';
import { random } from '../web/helpers/mutate-link.ts';
import { exampleText, loadModule } from './module.ts';

/** Killed workers of each kind of client; `LIFTARM_KILLS=200 npx vitest run ...` makes more of them. */
const KILLS = Number(process.env['LIFTARM_KILLS'] ?? 5);
/** What a slice is said to take, so that their number does not depend on the machine. */
const STEP_MS = 20;

/** The worker's logic on the real module. Killed in the midst of a search, it is never heard again. */
class MortalWorker implements WorkerPort {
  onmessage: WorkerPort['onmessage'] = null;
  onerror: WorkerPort['onerror'] = null;
  onmessageerror: WorkerPort['onmessageerror'] = null;
  readonly #afterSlice: (worker: MortalWorker) => void;
  #isDead = false;
  #now = 0;
  readonly #core = createWorkerCore(loadModule(), {
    post: (data: FromWorker) => setImmediate(() => this.onmessage?.({ data })),
    now: () => {
      this.#now += STEP_MS;
      return this.#now;
    },
    pause: () => this.#pause(),
    lastWords: () => '',
  });

  constructor(afterSlice: (worker: MortalWorker) => void) {
    this.#afterSlice = afterSlice;
  }

  postMessage(message: ToWorker): void {
    void this.#core.handle(message);
  }

  terminate(): void {
    this.#isDead = true;
  }

  kill(): void {
    this.#isDead = true;
    this.onerror?.({ message: 'killed' });
  }

  async #pause(): Promise<void> {
    this.#afterSlice(this);
    await new Promise((resolve) => setImmediate(resolve));
    if (this.#isDead) {
      await new Promise(() => undefined); // for ever
    }
  }
}

/** Workers that count their slices together; the one that makes slice `fatal` is killed by it. */
class Workers {
  slices = 0;
  started = 0;
  readonly #fatal: number;

  constructor(fatal: number) {
    this.#fatal = fatal;
  }

  readonly start = (): WorkerPort => {
    this.started += 1;
    return new MortalWorker((worker) => {
      this.slices += 1;
      if (this.slices === this.#fatal) {
        worker.kill();
      }
    });
  };
}

/** Asks the same of workers that live and of workers that are killed at random moments. */
async function compareAnswers(
  ask: (workers: Workers) => Promise<unknown>,
  look: (workers: Workers) => void,
) {
  const next = random(12);
  const calm = new Workers(0);
  const expected = await ask(calm);
  expect(calm.slices).toBeGreaterThan(KILLS);
  for (let i = 0; i < KILLS; ++i) {
    const workers = new Workers(1 + Math.floor(next() * calm.slices));
    expect(await ask(workers)).toEqual(expected);
    look(workers);
  }
}

async function solvedModel(client: SolverClient, sketchJson: string): Promise<string> {
  const result = await client.solve(sketchJson, { seed: 3 });
  return result.outcome === 'solved' ? result.modelJson : result.outcome;
}

test('a worker killed in the midst of its work costs no answer and changes none', async () => {
  const sketch = exampleText('square-frame');
  const model = await solvedModel(
    createWorkerClient({ startWorker: new Workers(0).start }),
    sketch,
  );
  await compareAnswers(
    ({ start }) => {
      const client = createWorkerClient({ startWorker: start });
      return Promise.all([
        solvedModel(client, sketch),
        client.check(model),
        client.exportModel(model, 'mpd'),
        client.ask({ about: 'symmetries', sketchJson: sketch }),
      ]);
    },
    ({ started }) => expect(started).toBe(2),
  );
});

test('a worker killed while several seeds are tried changes no result', async () => {
  await compareAnswers(
    ({ start }) => {
      const createClient = () => createWorkerClient({ startWorker: start });
      const pool = createSolverPool({ workers: 2, seeds: 2, patienceMs: 0, createClient });
      return solvedModel(pool, exampleText('square-frame'));
    },
    ({ started }) => expect(started).toBeGreaterThan(1),
  );
});
