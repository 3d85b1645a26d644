// Glue alone, a worker of its own: HiGHS is large, and works for seconds.
import loadHighs from 'highs';
import highsUrl from 'highs/runtime?url';
import type { BridgeContest } from '../../model/contest/bridge.ts';
import { ghostTruss } from './ghost-truss.ts';
import type { FromTruss } from './truss-client.ts';

const post = (message: FromTruss): void => postMessage(message);

addEventListener('message', ({ data }: MessageEvent<BridgeContest>) => {
  loadHighs({ locateFile: () => highsUrl })
    .then((highs) => post({ ok: true, truss: ghostTruss(data, highs) }))
    .catch((error: unknown) => {
      post({ ok: false, message: error instanceof Error ? error.message : String(error) });
    });
});
