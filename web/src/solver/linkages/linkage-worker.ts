// Glue alone: makes the table once, then answers for one path after the other.
import createLiftarmLinkages from '@wasm/liftarm-linkages.js';
import wasmUrl from '@wasm/liftarm-linkages.wasm?url';
import { makeTable } from './linkage-core.ts';
import type { LinkageMessage, LinkageTable, PathRequest } from './linkage-module.ts';

const post = (message: LinkageMessage): void => postMessage(message);

const table: Promise<LinkageTable> = createLiftarmLinkages({ locateFile: () => wasmUrl }).then(
  (module) => makeTable(module, (fraction) => post({ kind: 'progress', fraction })),
);

addEventListener('message', ({ data }: MessageEvent<PathRequest>) => {
  table
    .then((made) => {
      const start = performance.now();
      const { ok, text } = made.find(data.pathJson);
      const seconds = (performance.now() - start) / 1000;
      post(
        ok
          ? { kind: 'found', id: data.id, text, seconds }
          : { kind: 'refused', id: data.id, message: text },
      );
    })
    .catch((error: unknown) => {
      post({ kind: 'failed', message: error instanceof Error ? error.message : String(error) });
    });
});
