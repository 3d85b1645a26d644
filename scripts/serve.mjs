// Serves the built page from dist/. `--port N` is taken when it is free, else another one; `--host`
// makes it reachable from other machines; `--with-parent` ends it with the process that started it.
import { existsSync } from 'node:fs';
import { networkInterfaces } from 'node:os';
import { join, resolve } from 'node:path';
import { exitWith, StepError, TOP } from './lib/run.mjs';
import { serveOptions } from './lib/serve-options.mjs';

const DIST = resolve(TOP, process.env.LIFTARM_DIST ?? 'dist');
const PARENT_EVERY_MS = 500;

/** Addresses of this machine in the networks that it is part of. */
export function ownAddresses(interfaces = networkInterfaces()) {
  return Object.values(interfaces)
    .flat()
    .filter(({ family, internal }) => family === 'IPv4' && !internal)
    .map(({ address }) => address);
}

/** @returns every address under which the page can be opened, that for other machines first. */
export async function serve({ port, host }) {
  if (!existsSync(join(DIST, 'index.html'))) {
    throw new StepError('dist/ is empty: run `npm run build` first');
  }
  const { pageServer } = await import('./lib/page-server.mjs');
  const server = pageServer(DIST);
  const listen = (wanted) =>
    new Promise((done, fail) => {
      server.once('error', fail);
      server.listen(wanted, host, () => done(server.address().port));
    });
  const taken = await listen(port).catch((error) => {
    if (error.code !== 'EADDRINUSE' && error.code !== 'EACCES') {
      throw error;
    }
    return listen(0);
  });
  const names = host === '0.0.0.0' ? [...ownAddresses(), 'localhost'] : [host];
  return names.map((name) => `http://${name}:${taken}/`);
}

/** Whoever is killed does not end what he has started. */
function endWithParent() {
  const parent = process.ppid;
  setInterval(() => {
    if (process.ppid !== parent) {
      process.exit(0);
    }
  }, PARENT_EVERY_MS).unref();
}

if (process.argv[1] === import.meta.filename) {
  try {
    const options = serveOptions();
    if (options.withParent) {
      endWithParent();
    }
    console.log(`Liftarm is served at ${(await serve(options)).join(' and ')}`);
  } catch (error) {
    exitWith(error);
  }
}
