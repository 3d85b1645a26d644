import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join, relative, resolve, sep } from 'node:path';
import type { Plugin } from 'vite';

/** Nothing but our own files; WebAssembly may be compiled, text may not be run as script. */
const POLICY = [
  "default-src 'self'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self'",
  "img-src 'self' blob: data:",
  "media-src 'self' blob:",
  "connect-src 'self' blob: data:",
  "worker-src 'self' blob:",
  "frame-src 'self' blob:",
  "object-src 'none'",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

/** The content security policy as a meta element: the site needs no special headers. */
export function contentPolicy(): Plugin {
  return {
    name: 'liftarm-content-policy',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler: () => [
        {
          tag: 'meta',
          attrs: { 'http-equiv': 'Content-Security-Policy', content: POLICY },
          injectTo: 'head-prepend',
        },
      ],
    },
  };
}

/** Writes sw.js: the service worker with the list of all files of the build. */
export function serviceWorker(outDir: () => string): Plugin {
  return {
    name: 'liftarm-service-worker',
    apply: 'build',
    writeBundle: {
      sequential: true,
      order: 'post',
      handler() {
        writeWorker(outDir());
      },
    },
  };
}

/** Files that are not part of the page: itself, and what hosts read instead of serving it. */
const NOT_KEPT = ['sw.js', '_headers'];

function writeWorker(folder: string): void {
  const files = listFiles(folder)
    .map((file) => relative(folder, file).split(sep).join('/'))
    .filter((file) => !file.endsWith('.map') && !NOT_KEPT.includes(file))
    .sort();
  const core = new Set(['index.html', ...reachable(folder, 'index.html')]);
  core.add('examples/index.json');
  const hash = createHash('sha256');
  const template = readFileSync(resolve(import.meta.dirname, 'service-worker.js'), 'utf8');
  hash.update(template);
  for (const file of files) {
    hash.update(file).update(readFileSync(join(folder, file)));
  }
  const quoted = (names: readonly string[]) => names.map((name) => `'./${name}'`).join(', ');
  const first = files.filter((file) => core.has(file) || file.startsWith('examples/'));
  writeFileSync(
    join(folder, 'sw.js'),
    template
      .replace('__VERSION__', hash.digest('hex').slice(0, 16))
      .replace("'__CORE_FILES__'", quoted(first))
      .replace("'__OTHER_FILES__'", quoted(files.filter((file) => !first.includes(file)))),
  );
}

function listFiles(folder: string): string[] {
  return readdirSync(folder).flatMap((name) => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? listFiles(path) : [path];
  });
}

/**
 * The built files that a page needs at its start: those that it names, the modules that they import, the
 * worker and the WebAssembly module. What is imported on demand is not among them.
 */
function reachable(folder: string, page: string): string[] {
  const all = listFiles(folder).map((file) => relative(folder, file).split(sep).join('/'));
  const text = readFileSync(join(folder, page), 'utf8');
  // Workers and the module are named inside of scripts, without their folder.
  const found = new Set(
    all.filter(
      (file) =>
        text.includes(file) || /(^|\/)(worker|liftarm-core)[-.][^/]*\.(js|wasm)$/.test(file),
    ),
  );
  for (const file of found) {
    for (const name of file.endsWith('.js') ? importsOf(join(folder, file)) : []) {
      const known = all.find((other) => other.endsWith(`/${name}`));
      if (known) {
        // A set goes on to what is added while it is walked.
        found.add(known);
      }
    }
  }
  return [...found];
}

/** File names that a module imports at once, not on demand. */
function importsOf(file: string): string[] {
  const text = readFileSync(file, 'utf8');
  return [...text.matchAll(/(?:from|import)\s*["']\.\/([\w.-]+\.js)["']/g)].flatMap(
    (match) => match[1] ?? [],
  );
}
