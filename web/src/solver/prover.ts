// Glue alone, a worker of its own: HiGHS is large, and nobody needs it before the first proof.
import loadHighs from 'highs';
import highsUrl from 'highs/runtime?url';
import type { FromProver, ToProver } from './proof/messages.ts';
import { readPlacements } from './proof/placements.ts';
import { PROOF_DEFAULTS, prove } from './proof/prove.ts';

const post = (message: FromProver): void => postMessage(message);

addEventListener('message', ({ data }: MessageEvent<ToProver>) => {
  loadHighs({ locateFile: () => highsUrl })
    .then((highs) => {
      const certificate = prove(readPlacements(data.placementsJson), highs, {
        ...PROOF_DEFAULTS,
        onProgress: (progress) => post({ kind: 'progress', progress }),
      });
      post({ kind: 'proved', certificate });
    })
    .catch((error: unknown) => {
      post({ kind: 'failed', message: error instanceof Error ? error.message : String(error) });
    });
});
