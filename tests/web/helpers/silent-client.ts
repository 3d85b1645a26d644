import type {
  SolveResult,
  SolverClient,
  SolveWatch,
  TextResult,
} from '../../../web/src/solver/client.ts';
import type { SolveSettings } from '../../../web/src/solver/protocol.ts';

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
}

/** A solver that answers only what the test tells it to. */
export function silentClient(): TestClient {
  const solves: PendingSolve[] = [];
  const client: TestClient = {
    solves,
    checkReply: { outcome: 'ok', text: '{"buildable":true,"items":[],"problems":[]}' },
    solve: (sketchJson, settings, watch = {}) =>
      new Promise((settle, fail) => {
        watch.signal?.addEventListener('abort', () =>
          settle({ outcome: 'cancelled', modelJson: null }),
        );
        solves.push({ sketchJson, settings, watch, settle, fail });
      }),
    check: async () => client.checkReply,
    exportModel: async () => ({ outcome: 'ok', text: '' }),
    ask: async () => ({ outcome: 'ok', text: '{"ok":false,"message":"","moving":[]}' }),
    warmUp: () => undefined,
    dispose: () => undefined,
  };
  return client;
}
