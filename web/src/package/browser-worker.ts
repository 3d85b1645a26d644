// The package's worker in a browser. Glue alone, as solver/worker.ts is for the page.
import { beside } from './beside.ts';
import { createPackageCore } from './package-core.ts';

const turn = new MessageChannel();
const waiting: (() => void)[] = [];
turn.port1.onmessage = () => waiting.shift()?.();

const core = createPackageCore({
  wasm: async () => {
    const reply = await fetch(beside('liftarm-core.wasm'));
    if (!reply.ok) {
      throw new Error(`liftarm-core.wasm: ${reply.status} ${reply.statusText}`);
    }
    return new Uint8Array(await reply.arrayBuffer());
  },
  post: (reply) => postMessage(reply),
  pause: () =>
    new Promise((resolve) => {
      waiting.push(resolve);
      turn.port2.postMessage(null);
    }),
});

addEventListener('message', ({ data }) => void core.handle(data));
