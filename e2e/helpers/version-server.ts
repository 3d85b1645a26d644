import { createReadStream, existsSync, readFileSync, statSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, resolve } from 'node:path';

const DIST = resolve(import.meta.dirname, '../../', process.env['LIFTARM_DIST'] ?? 'dist');
const FOLDER = '/some/folder/';
const TYPES: Readonly<Record<string, string>> = {
  '.css': 'text/css',
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
};

/** The built page in a subfolder of a plain server that can bring out a new version or go away. */
export class VersionServer {
  readonly #server: Server;
  version = 1;

  private constructor(server: Server) {
    this.#server = server;
  }

  static async start(): Promise<VersionServer> {
    const server = createServer();
    const made = new VersionServer(server);
    server.on('request', (request, response) => {
      const path = new URL(request.url ?? '/', 'http://host').pathname.replace(FOLDER, '/');
      const file = join(DIST, path.endsWith('/') ? 'index.html' : path);
      if (!file.startsWith(DIST) || !existsSync(file) || !statSync(file).isFile()) {
        response.writeHead(404).end();
        return;
      }
      response.setHeader('content-type', TYPES[extname(file)] ?? 'application/octet-stream');
      if (path === '/sw.js') {
        const text = readFileSync(file, 'utf8');
        response.end(text.replace(/const VERSION = '/, `const VERSION = 'v${made.version}-`));
        return;
      }
      createReadStream(file).pipe(response);
    });
    await new Promise<void>((done) => server.listen(0, '127.0.0.1', done));
    return made;
  }

  get address(): string {
    return `http://127.0.0.1:${(this.#server.address() as AddressInfo).port}${FOLDER}`;
  }

  async stop(): Promise<void> {
    this.#server.closeAllConnections();
    await new Promise((done) => this.#server.close(done));
  }
}
