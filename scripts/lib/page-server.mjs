// The server of the built page: files of one folder, and nothing else.

import { realpath } from 'node:fs/promises';
import { createServer } from 'node:http';
import { join, sep } from 'node:path';
import compression from 'compression';
import send from 'send';

/** The page may not be shown in a frame of another site; the viewer is made for that. */
const IN_FRAMES = "frame-ancestors 'self'";
const VIEWER = '/embed.html';

/**
 * @param {string} folder what is served.
 * @returns {import('node:http').Server} not listening yet.
 */
export function pageServer(folder) {
  const compress = compression();
  return createServer((request, response) => {
    compress(request, response, () => {
      answer(folder, request, response).catch(() => refuse(response, 500));
    });
  });
}

async function answer(folder, request, response) {
  if (request.method !== 'GET' && request.method !== 'HEAD') {
    response.setHeader('allow', 'GET, HEAD');
    refuse(response, 405);
    return;
  }
  const path = pathOf(request.url ?? '/');
  if (path === null || !(await isInside(folder, path))) {
    refuse(response, 404);
    return;
  }
  response.setHeader('x-content-type-options', 'nosniff');
  if (path !== VIEWER) {
    response.setHeader('content-security-policy', IN_FRAMES);
  }
  // The names of built files change with their content, but a rebuild must show at once.
  response.setHeader('cache-control', 'no-cache');
  send(request, encodeURI(path), { root: folder, dotfiles: 'ignore', cacheControl: false })
    .on('error', ({ status }) => refuse(response, status))
    .pipe(response);
}

function pathOf(url) {
  try {
    return decodeURIComponent(new URL(url, 'http://host').pathname);
  } catch {
    return null;
  }
}

/** Whether a path leads to something in the folder; a link may lead out of it. */
async function isInside(folder, path) {
  try {
    const [top, file] = await Promise.all([realpath(folder), realpath(join(folder, path))]);
    return file === top || file.startsWith(top + sep);
  } catch {
    return false;
  }
}

function refuse(response, status) {
  if (response.headersSent) {
    response.destroy();
    return;
  }
  response.writeHead(status, { 'content-type': 'text/plain' }).end(`${status}\n`);
}
