import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { resolve } from 'node:path';
import { test } from 'vitest';
import { TOP } from '../../scripts/lib/run.mjs';
import { portOf } from '../../scripts/lib/serve-options.mjs';

test('ports are whole numbers from 0 to 65535', () => {
  assert.equal(portOf('0'), 0);
  assert.equal(portOf('65535'), 65535);
  for (const wrong of ['abc', '', '-1', '65536', '1e3', '4173x', ' 80']) {
    assert.throws(() => portOf(wrong), /a whole number from 0 to 65535/, wrong);
  }
});

test('a wrong port is one message and no trace', () => {
  for (const script of ['serve.mjs', 'start.mjs']) {
    const path = resolve(TOP, 'scripts', script);
    const { status, stderr } = spawnSync('node', [path, '--port', 'abc'], { encoding: 'utf8' });
    assert.equal(status, 1);
    assert.match(stderr.trim(), /^--port abc: a whole number from 0 to 65535 is needed$/);
  }
});
