import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import createLiftarmCore from '@wasm/liftarm-core.js';
import type { SolverModule, SolverModuleOptions } from '../../web/src/solver/solver-module.ts';

const TOP = resolve(import.meta.dirname, '../..');
const COMMAND = join(TOP, 'build/native/liftarm');
const EXAMPLES = join(TOP, 'public/examples');

let compiled: Promise<WebAssembly.Module> | undefined;

/** The module that the page ships, loaded in Node: the tested bytes are the shipped ones. Compiled once. */
export function loadModule(): Promise<SolverModule> {
  compiled ??= WebAssembly.compile(readFileSync(join(TOP, 'build/wasm/liftarm-core.wasm')));
  const loading = compiled;
  return new Promise((resolve, reject) => {
    const instantiateWasm: SolverModuleOptions['instantiateWasm'] = (imports, done) => {
      loading
        .then(async (module) => done(await WebAssembly.instantiate(module, imports), module))
        .catch(reject);
      return {};
    };
    createLiftarmCore({ instantiateWasm, printErr: () => {} }).then(resolve, reject);
  });
}

/** The text of one of our own drawings. */
export function exampleText(name: string): string {
  return readFileSync(join(EXAMPLES, `${name}.sketch.json`), 'utf8');
}

export function exampleNames(): string[] {
  return readdirSync(EXAMPLES)
    .filter((file) => file.endsWith('.sketch.json'))
    .map((file) => file.replace('.sketch.json', ''));
}

export interface SolveOutput {
  readonly modelJson: string;
  readonly report: Record<string, unknown>;
}

/** Solves with the module; how the work is sliced must not matter. */
export function solveWithModule(
  module: SolverModule,
  sketchJson: string,
  settings: object,
  slice = 1000,
): SolveOutput {
  const session = new module.SolverSession(sketchJson, JSON.stringify(settings));
  try {
    const { status, text } = session.opened();
    if (status !== 'ok') {
      throw new Error(text);
    }
    while (!session.advance(slice)) {
      // The search goes on.
    }
    return {
      modelJson: session.modelJson(),
      report: JSON.parse(session.reportJson()) as Record<string, unknown>,
    };
  } finally {
    session.delete();
  }
}

/** Runs the native command. @returns its exit code and what it printed. */
export function runCommand(args: readonly string[]): { code: number; stdout: string } {
  if (!existsSync(COMMAND)) {
    throw new Error(`${COMMAND} is missing: npm run build:native`);
  }
  try {
    return { code: 0, stdout: execFileSync(COMMAND, args, { encoding: 'utf8', stdio: 'pipe' }) };
  } catch (error) {
    const { status, stdout } = error as { status: number | null; stdout: string };
    return { code: status ?? -1, stdout };
  }
}

/** Solves one of our drawings with the native command; \p flags as on the command line. */
export function solveWithCommand(name: string, flags: readonly string[]): SolveOutput {
  const folder = mkdtempSync(join(tmpdir(), 'liftarm-contract-'));
  const sketch = join(EXAMPLES, `${name}.sketch.json`);
  const { code, stdout } = runCommand(['solve', sketch, '-o', folder, '--json', ...flags]);
  const file = readdirSync(folder).find((entry) => entry.endsWith('.model.json'));
  if (file === undefined) {
    throw new Error(`liftarm solve ${name} ended with ${code} and wrote no model`);
  }
  return {
    modelJson: readFileSync(join(folder, file), 'utf8'),
    report: JSON.parse(stdout) as Record<string, unknown>,
  };
}
