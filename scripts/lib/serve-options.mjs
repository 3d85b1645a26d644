// What `npm start` and `scripts/serve.mjs` are told on the command line. Node alone: it is read before any package
// is installed.
import { parseArgs } from 'node:util';
import { StepError } from './run.mjs';

export const DEFAULT_PORT = 4173;
const MAX_PORT = 65_535;

/** @throws {StepError} for what is no port; 0 is any that is free. */
export function portOf(text) {
  const port = /^\d{1,5}$/.test(text) ? Number(text) : Number.NaN;
  if (!(port <= MAX_PORT)) {
    throw new StepError(`--port ${text}: a whole number from 0 to ${MAX_PORT} is needed`);
  }
  return port;
}

/** Reads `--port`, `--host` and `--with-parent`. @throws {StepError} for a port that is none. */
export function serveOptions(args = process.argv.slice(2), env = process.env) {
  const { values } = parseArgs({
    args,
    options: {
      port: { type: 'string' },
      host: { type: 'boolean', default: false },
      'with-parent': { type: 'boolean', default: false },
    },
  });
  const port = portOf(values.port ?? env.PORT ?? `${DEFAULT_PORT}`);
  return { port, host: values.host ? '0.0.0.0' : '127.0.0.1', withParent: values['with-parent'] };
}
