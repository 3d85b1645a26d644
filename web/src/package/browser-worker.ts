// The package's worker in a browser. Glue alone, as solver/worker.ts is for the page.
import { ownTurn } from '../solver/own-turn.ts';
import { beside } from './beside.ts';
import { createPackageCore } from './package-core.ts';

const core = createPackageCore({
  wasm: async () => {
    const reply = await fetch(beside('liftarm-core.wasm'));
    if (!reply.ok) {
      throw new Error(`liftarm-core.wasm: ${reply.status} ${reply.statusText}`);
    }
    return new Uint8Array(await reply.arrayBuffer());
  },
  post: (reply) => postMessage(reply),
  pause: ownTurn,
});

addEventListener('message', ({ data }) => void core.handle(data));
