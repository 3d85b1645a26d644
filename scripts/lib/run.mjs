// Small helpers of the scripts: run a command, time a step. Node alone, no packages: they run first.
import { spawn, spawnSync } from 'node:child_process';
import { createServer } from 'node:net';
import { dirname, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

export const TOP = resolve(dirname(fileURLToPath(import.meta.url)), '../..');

/** A step failed in an expected way: its message is all that is to be printed. */
export class StepError extends Error {}

/**
 * Runs a command with its output on ours.
 * @throws {StepError} when it ends with another code than 0.
 */
export function run(command, args, { env = {}, cwd = TOP } = {}) {
  return new Promise((done, fail) => {
    const child = spawn(command, args, { cwd, stdio: 'inherit', env: { ...process.env, ...env } });
    child.on('error', (error) => fail(new StepError(`${command}: ${error.message}`)));
    child.on('close', (code, signal) => {
      if (code === 0) {
        done();
      } else {
        fail(new StepError(`${command} ${args[0] ?? ''} ended with ${signal ?? `code ${code}`}`));
      }
    });
  });
}

/** Runs a command silently. @returns its code (-1 when it could not start) and its output. */
export function capture(command, args) {
  const result = spawnSync(command, args, { cwd: TOP, encoding: 'utf8', maxBuffer: 64 << 20 });
  return { code: result.status ?? -1, stdout: result.stdout ?? '', stderr: result.stderr ?? '' };
}

/** A program of node_modules, without npx. */
export function localBin(name) {
  return resolve(TOP, 'node_modules/.bin', name);
}

/** Runs one named step and prints its time. */
export async function timed(title, work) {
  const start = performance.now();
  console.log(`\n== ${title}`);
  try {
    return await work();
  } finally {
    console.log(`== ${title}: ${((performance.now() - start) / 1000).toFixed(1)} s`);
  }
}

/** A TCP port that nothing listens on: the wanted one if it is free. */
export function freePort(wanted) {
  const probe = (port) =>
    new Promise((done) => {
      const server = createServer();
      server.once('error', () => done(null));
      server.listen(port, '127.0.0.1', () => {
        const { port: found } = server.address();
        server.close(() => done(found));
      });
    });
  return probe(wanted).then((port) => port ?? probe(0));
}

/** Ends a script: one line for what was expected to go wrong, a trace for what was not. */
export function exitWith(error) {
  const expected = error instanceof StepError || error?.code?.startsWith('ERR_PARSE_ARGS');
  console.error(expected ? `\n${error.message}` : error);
  process.exit(1);
}
