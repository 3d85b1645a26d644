// Glue alone: the logic is worker-core.ts, which tests run without a worker.
import createLiftarmCore from '@wasm/liftarm-core.js';
import wasmUrl from '@wasm/liftarm-core.wasm?url';
import type { FromWorker, ToWorker } from './protocol.ts';
import { createWorkerCore } from './worker-core.ts';

let lastWords = '';

const loading = createLiftarmCore({
  locateFile: () => wasmUrl,
  printErr: (line) => {
    lastWords = line;
  },
});

// A message to ourselves comes after those that wait already, without the delay of a nested timer.
const turn = new MessageChannel();
const waiting: (() => void)[] = [];
turn.port1.onmessage = () => waiting.shift()?.();

const core = createWorkerCore(loading, {
  post: (reply: FromWorker) => postMessage(reply),
  now: () => performance.now(),
  pause: () =>
    new Promise((resolve) => {
      waiting.push(resolve);
      turn.port2.postMessage(null);
    }),
  lastWords: () => lastWords,
});

addEventListener('message', ({ data }: MessageEvent<ToWorker>) => {
  void core.handle(data);
});
