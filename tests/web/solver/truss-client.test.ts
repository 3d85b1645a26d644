import { expect, it } from 'vitest';
import { BRIDGE_DEFAULTS } from '../../../web/src/model/contest/bridge.ts';
import { findTruss, type TrussPort } from '../../../web/src/solver/truss/truss-client.ts';

const CONTEST = { ...BRIDGE_DEFAULTS, deck: { from: [0, 0, 4], to: [12, 0, 4] } } as const;
const TRUSS = { members: [], volume: 3 };

function setUp() {
  const stop = new AbortController();
  let ended = 0;
  const port: TrussPort = {
    postMessage: () => undefined,
    terminate: () => {
      ended += 1;
    },
    onmessage: null,
    onerror: null,
  };
  const found = findTruss(CONTEST, stop.signal, () => port);
  return { stop, port, found, ended: () => ended };
}

it('a truss ends its worker', async () => {
  const { port, found, ended } = setUp();
  port.onmessage?.({ data: { ok: true, truss: TRUSS } });
  expect(await found).toEqual(TRUSS);
  expect(ended()).toBe(1);
});

it('what is stopped is null, and its worker ends', async () => {
  const { stop, found, ended } = setUp();
  stop.abort();
  expect(await found).toBeNull();
  expect(ended()).toBe(1);
});

it('what goes wrong is told with its reason', async () => {
  const { port, found } = setUp();
  port.onmessage?.({ data: { ok: false, message: 'no memory' } });
  await expect(found).rejects.toThrow('no memory');
  const lost = setUp();
  lost.port.onerror?.({});
  await expect(lost.found).rejects.toThrow('could not be loaded');
});
