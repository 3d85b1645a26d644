// Serves the built page from dist/. `--port N` is taken when it is free, else another one; `--host`
// makes it reachable from other machines.
import { createReadStream, existsSync, readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { gzipSync } from 'node:zlib';
import { exitWith, freePort, StepError, TOP } from './lib/run.mjs';

const DIST = resolve(TOP, 'dist');
const DEFAULT_PORT = 4173;
const PACKABLE = /text|json|svg|wasm/;
const packedFiles = new Map();
const TYPES = {
  '.css': 'text/css; charset=utf-8',
  '.html': 'text/html; charset=utf-8',
  '.ico': 'image/x-icon',
  '.js': 'text/javascript; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.map': 'application/json; charset=utf-8',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
  '.woff2': 'font/woff2',
};

/** The file of dist/ that an address names, or null. */
function fileOf(url) {
  let path;
  try {
    path = normalize(decodeURIComponent(new URL(url, 'http://host').pathname));
  } catch {
    return null;
  }
  const file = join(DIST, path.endsWith('/') ? `${path}index.html` : path);
  return file.startsWith(DIST) && existsSync(file) && statSync(file).isFile() ? file : null;
}

function answer(request, response) {
  const file = fileOf(request.url ?? '/');
  if (file === null) {
    response.writeHead(404, { 'content-type': 'text/plain' }).end('not found\n');
    return;
  }
  const type = TYPES[extname(file)] ?? 'application/octet-stream';
  const { size, mtimeMs } = statSync(file);
  const etag = `"${size.toString(36)}-${Math.round(mtimeMs).toString(36)}"`;
  // The names of built files change with their content, but a rebuild must show at once.
  const head = { 'content-type': type, 'cache-control': 'no-cache', etag };
  if (request.headers['if-none-match'] === etag) {
    response.writeHead(304, head).end();
  } else if (PACKABLE.test(type) && /\bgzip\b/.test(request.headers['accept-encoding'] ?? '')) {
    const packed = packedFile(file, etag);
    const more = { 'content-encoding': 'gzip', 'content-length': packed.length };
    response.writeHead(200, { ...head, ...more }).end(packed);
  } else {
    response.writeHead(200, { ...head, 'content-length': size });
    createReadStream(file).pipe(response);
  }
}

/** Compressed once for each state of a file. */
function packedFile(file, etag) {
  const known = packedFiles.get(file);
  if (known?.etag === etag) {
    return known.bytes;
  }
  const bytes = gzipSync(readFileSync(file));
  packedFiles.set(file, { etag, bytes });
  return bytes;
}

/** @returns the address that is served. */
export async function serve({ port = DEFAULT_PORT, host = '127.0.0.1' } = {}) {
  if (!existsSync(join(DIST, 'index.html'))) {
    throw new StepError('dist/ is empty: run `npm run build` first');
  }
  const taken = await freePort(port);
  const server = createServer(answer);
  await new Promise((done, fail) => {
    server.once('error', fail);
    server.listen(taken, host, done);
  });
  return `http://${host === '0.0.0.0' ? 'localhost' : host}:${taken}/`;
}

/** @throws {StepError} for what is no port. */
export function portOf(text) {
  const port = /^\d{1,5}$/.test(text) ? Number(text) : Number.NaN;
  if (!(port <= 65535)) {
    throw new StepError(`--port ${text}: a whole number from 0 to 65535 is needed`);
  }
  return port;
}

/** Reads `--port` and `--host`. */
export function serveOptions() {
  const { values } = parseArgs({
    options: { port: { type: 'string' }, host: { type: 'boolean', default: false } },
  });
  return {
    port: portOf(values.port ?? process.env.PORT ?? `${DEFAULT_PORT}`),
    host: values.host ? '0.0.0.0' : '127.0.0.1',
  };
}

if (process.argv[1] === import.meta.filename) {
  Promise.resolve()
    .then(() => serve(serveOptions()))
    .then((address) => console.log(`Liftarm is served at ${address}`))
    .catch(exitWith);
}
