import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type { Plugin } from 'vite';
import { loadFirstExample, namedSketch } from '../src/app/example-list.ts';
import type { MadeModel } from '../src/solver/made-model.ts';
import type { FromWorker } from '../src/solver/protocol.ts';
import type { CreateSolverModule } from '../src/solver/solver-module.ts';
import { createWorkerCore, type WorkerCore } from '../src/solver/worker-core.ts';
import { type Language, PREFERENCE_DEFAULTS } from '../src/state/preferences.ts';
import { writeSketch } from '../src/state/read-sketch.ts';
import { settingsOf } from '../src/ui/solve-settings.ts';

const NAME = 'virtual:first-model';

export interface FirstModelFolders {
  /** Holds liftarm-core.js and liftarm-core.wasm. */
  readonly wasm: string;
  /** Holds examples/. */
  readonly public: string;
}

/**
 * Ships the first example solved: the picture of a first visit then waits neither for the WebAssembly module,
 * which is larger than all scripts, nor for the search.
 */
export function firstModel(folders: FirstModelFolders): Plugin {
  return {
    name: 'liftarm-first-model',
    resolveId: (id) => (id === NAME ? `\0${NAME}` : null),
    async load(id) {
      return id === `\0${NAME}`
        ? `export const firstModels = ${JSON.stringify(await makeFirstModels(folders))};`
        : null;
    },
  };
}

/** One for each language, since a sketch and its model have a name. */
async function makeFirstModels(folders: FirstModelFolders): Promise<Record<Language, MadeModel>> {
  return { en: await makeFirstModel(folders, 'en'), de: await makeFirstModel(folders, 'de') };
}

/** @throws Error when there is no example, or no buildable model of it. */
export async function makeFirstModel(
  folders: FirstModelFolders,
  language: Language,
): Promise<MadeModel> {
  const fetchJson = async (path: string): Promise<unknown> =>
    JSON.parse(readFileSync(join(folders.public, path), 'utf8'));
  const example = await loadFirstExample(fetchJson, language);
  if (!example) {
    throw new Error('examples/index.json names no example that can be read');
  }
  const sketch = namedSketch(example);
  const settings = settingsOf(PREFERENCE_DEFAULTS);
  const worker = solver(folders.wasm);
  const sketchJson = writeSketch(sketch);
  const solved = await worker({ kind: 'start', jobId: 1, sketchJson, settings });
  if (solved.kind !== 'solved') {
    throw new Error(`${example.file}: no model: ${solved.kind}`);
  }
  const { modelJson, reportJson, layoutJson } = solved;
  const checked = await worker({ kind: 'check', jobId: 2, modelJson });
  if (checked.kind !== 'checked' || !JSON.parse(checked.checkJson).buildable) {
    throw new Error(`${example.file}: not buildable`);
  }
  return { sketch, settings, modelJson, reportJson, checkJson: checked.checkJson, layoutJson };
}

type Asked = Parameters<WorkerCore['handle']>[0];

/** The page's worker without a worker: the answer to each message. */
function solver(folder: string): (message: Asked) => Promise<FromWorker> {
  let last: FromWorker = { kind: 'failed', jobId: 0, message: 'no answer' };
  const core = createWorkerCore(loadModule(folder), {
    post: (reply) => {
      last = reply;
    },
    now: () => performance.now(),
    pause: async () => undefined,
    lastWords: () => '',
  });
  return async (message) => {
    await core.handle(message);
    return last;
  };
}

async function loadModule(folder: string) {
  const address = pathToFileURL(join(folder, 'liftarm-core.js')).href;
  const { default: create } = (await import(address)) as { default: CreateSolverModule };
  return create({ wasmBinary: readFileSync(join(folder, 'liftarm-core.wasm')) });
}
