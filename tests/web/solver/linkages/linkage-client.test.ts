import { expect, test } from 'vitest';
import {
  createLinkageClient,
  type LinkagePort,
} from '../../../../web/src/solver/linkages/linkage-client.ts';
import { makeTable } from '../../../../web/src/solver/linkages/linkage-core.ts';
import type {
  LinkageMessage,
  LinkageTable,
  PathRequest,
} from '../../../../web/src/solver/linkages/linkage-module.ts';

function setUp() {
  const sent: PathRequest[] = [];
  const told: string[] = [];
  let ended = false;
  let started = 0;
  const port: LinkagePort = {
    postMessage: (message) => sent.push(message),
    terminate: () => {
      ended = true;
    },
    onmessage: null,
    onerror: null,
  };
  const client = createLinkageClient(
    {
      onProgress: (fraction) => told.push(`progress ${fraction}`),
      onFound: (text) => told.push(`found ${text}`),
      onFailed: (message) => told.push(`failed ${message}`),
    },
    () => {
      started += 1;
      return port;
    },
  );
  const say = (data: LinkageMessage) => port.onmessage?.({ data });
  return { client, sent, told, say, port, isEnded: () => ended, starts: () => started };
}

test('only the answer to the last path is told', () => {
  const { client, sent, told, say } = setUp();
  client.ask('first');
  client.ask('second');
  const [first, second] = sent;
  say({ kind: 'found', id: first?.id ?? -1, text: 'old', seconds: 1 });
  say({ kind: 'found', id: second?.id ?? -1, text: 'new', seconds: 1 });
  expect(told).toEqual(['found new']);
});

test('refusals and failures are told with their reason', () => {
  const { client, sent, told, say, port } = setUp();
  client.ask('path');
  say({ kind: 'refused', id: sent[0]?.id ?? -1, message: 'too short' });
  port.onerror?.({ message: 'gone' });
  expect(told).toEqual(['failed too short', 'failed gone']);
});

test('a path is asked of another worker after one has failed', () => {
  const { client, sent, told, say, starts, isEnded } = setUp();
  client.ask('fatal');
  say({ kind: 'failed', message: 'unreachable' });
  expect(isEnded()).toBe(true);
  client.ask('next');
  expect(starts()).toBe(2);
  say({ kind: 'found', id: sent[1]?.id ?? -1, text: 'new', seconds: 1 });
  expect(told).toEqual(['failed unreachable', 'found new']);
});

test('nothing is told after the end', () => {
  const { client, told, port, isEnded } = setUp();
  client.dispose();
  expect(isEnded()).toBe(true);
  expect(port.onmessage).toBeNull();
  expect(told).toEqual([]);
});

test('the table is made whole, with progress on the way', () => {
  class ThreeSteps implements LinkageTable {
    left = 3;
    advance(): boolean {
      this.left -= 1;
      return this.left === 0;
    }
    fraction(): number {
      return 1 - this.left / 3;
    }
    find() {
      return { ok: true, text: '' };
    }
    delete(): void {}
  }
  const told: number[] = [];
  const made = makeTable({ LinkageTable: ThreeSteps }, (fraction) => told.push(fraction));
  expect(made.advance(1)).toBe(false);
  expect(told).toHaveLength(2);
});
