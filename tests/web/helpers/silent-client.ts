import type { SolveSettings } from '../../../web/src/solver/protocol.ts';
import type {
  SolveResult,
  SolverClient,
  SolveWatch,
  TextResult,
} from '../../../web/src/solver/worker-client.ts';

/** A search that is under way in a test: the test says what comes of it. */
export interface PendingSolve {
  readonly sketchJson: string;
  readonly settings: SolveSettings;
  readonly watch: SolveWatch;
  readonly settle: (result: SolveResult) => void;
  readonly fail: (error: Error) => void;
}

export interface TestClient extends SolverClient {
  readonly solves: PendingSolve[];
  checkReply: TextResult;
  /** Checks wait for `checkReply` to be set and this to be called. */
  holdChecks: boolean;
  releaseChecks(): void;
}

/** A solver that answers only what the test tells it to. */
export function silentClient(): TestClient {
  const solves: PendingSolve[] = [];
  let release: () => void = () => undefined;
  const client: TestClient = {
    solves,
    holdChecks: false,
    releaseChecks: () => release(),
    checkReply: { outcome: 'ok', text: '{"buildable":true,"items":[],"problems":[]}' },
    solve: (sketchJson, settings, watch = {}) =>
      new Promise((settle, fail) => {
        watch.signal?.addEventListener('abort', () =>
          settle({ outcome: 'cancelled', modelJson: null }),
        );
        solves.push({ sketchJson, settings, watch, settle, fail });
      }),
    check: async (_, signal) => {
      if (client.holdChecks) {
        await new Promise<void>((resolve, reject) => {
          release = resolve;
          signal?.addEventListener('abort', () => reject(signal.reason));
        });
      }
      return client.checkReply;
    },
    exportModel: async () => ({ outcome: 'ok', text: '' }),
    ask: async () => ({ outcome: 'ok', text: '{"ok":false,"message":"","moving":[]}' }),
    warmUp: () => undefined,
    dispose: () => undefined,
  };
  return client;
}
