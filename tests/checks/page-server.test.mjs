import { mkdtempSync, readdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { get, request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { pageServer } from '../../scripts/lib/page-server.mjs';
import { ownAddresses } from '../../scripts/serve.mjs';

const LARGE = 8 * 2 ** 20;
const ABORTED = 60;

let folder = '';
let server = pageServer('');
let address = '';

beforeEach(async () => {
  folder = mkdtempSync(join(tmpdir(), 'liftarm-served-'));
  writeFileSync(join(folder, 'index.html'), '<!doctype html><title>page</title>');
  writeFileSync(join(folder, 'embed.html'), '<!doctype html><title>viewer</title>');
  writeFileSync(join(folder, 'a.wasm'), Buffer.alloc(4096));
  writeFileSync(join(folder, 'large.bin'), Buffer.alloc(LARGE, 7));
  server = pageServer(folder);
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  address = `http://127.0.0.1:${server.address().port}`;
});

afterEach(async () => {
  server.closeAllConnections();
  await new Promise((done) => server.close(done));
  rmSync(folder, { recursive: true });
});

/** The status of a path that no client would tidy first. */
function rawStatus(path) {
  return new Promise((done, fail) => {
    get(`${address}/`, { path }, (response) => {
      response.resume();
      done(response.statusCode);
    }).on('error', fail);
  });
}

/** Asks for the large file and goes away at its first bytes. */
function abortedDownload() {
  return new Promise((done) => {
    const asked = request(`${address}/large.bin`, (response) => {
      response.once('data', () => asked.destroy());
    });
    asked.on('close', done).on('error', () => undefined);
    asked.end();
  });
}

describe('the server of the page', () => {
  it('serves files with their types, and the page for its folder', async () => {
    expect((await fetch(`${address}/`)).headers.get('content-type')).toContain('text/html');
    const wasm = await fetch(`${address}/a.wasm`);
    expect(wasm.headers.get('content-type')).toBe('application/wasm');
    expect(wasm.headers.get('content-encoding')).toMatch(/gzip|br/);
  });

  it('answers nothing but reading', async () => {
    for (const method of ['POST', 'PUT', 'DELETE', 'OPTIONS']) {
      const reply = await fetch(`${address}/`, { method });
      expect([method, reply.status]).toEqual([method, 405]);
    }
    expect((await fetch(`${address}/`, { method: 'HEAD' })).status).toBe(200);
  });

  it('lets no link and no path lead out of its folder', async () => {
    symlinkSync('/etc/hostname', join(folder, 'out.txt'));
    symlinkSync('/etc', join(folder, 'etc'));
    for (const path of [
      '/out.txt',
      '/etc/hostname',
      '/../../etc/hostname',
      '/%2e%2e/%2e%2e/etc/hostname',
      '/%zz',
      '/missing',
      '/.git/config',
    ]) {
      expect([path, await rawStatus(path)]).toEqual([path, 404]);
    }
  });

  it('lives on when a file goes away', async () => {
    const first = fetch(`${address}/a.wasm`);
    rmSync(join(folder, 'a.wasm'));
    expect([200, 404, 500]).toContain((await first.catch(() => ({ status: 500 }))).status);
    expect((await fetch(`${address}/a.wasm`)).status).toBe(404);
    expect((await fetch(`${address}/`)).status).toBe(200);
  });

  it('keeps no file open for downloads that were broken off', async () => {
    const open = () => readdirSync('/proc/self/fd').length;
    const before = open();
    for (let i = 0; i < ABORTED; i++) {
      await abortedDownload();
    }
    await expect.poll(open, { timeout: 5000 }).toBeLessThan(before + ABORTED / 4);
  });

  it('lets other sites frame the viewer and nothing else', async () => {
    const policy = async (path) =>
      (await fetch(address + path)).headers.get('content-security-policy');
    expect(await policy('/')).toContain("frame-ancestors 'self'");
    expect(await policy('/index.html')).toContain("frame-ancestors 'self'");
    expect(await policy('/embed.html')).toBeNull();
  });
});

describe('its options', () => {
  it('the address of this machine is printed, not that of itself alone', () => {
    const interfaces = {
      lo: [{ family: 'IPv4', internal: true, address: '127.0.0.1' }],
      lan: [
        { family: 'IPv6', internal: false, address: 'fe80::1' },
        { family: 'IPv4', internal: false, address: '192.168.1.7' },
      ],
    };
    expect(ownAddresses(interfaces)).toEqual(['192.168.1.7']);
  });
});
