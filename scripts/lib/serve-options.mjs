// What `npm start` and `scripts/serve.mjs` are told on the command line. Node alone: it is read before any package
// is installed.
import { parseArgs } from 'node:util';
import { StepError } from './run.mjs';

export const DEFAULT_PORT = 4173;
const MAX_PORT = 65_535;

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
  const text = values.port ?? env.PORT ?? `${DEFAULT_PORT}`;
  const port = Number(text);
  if (!/^\d{1,5}$/.test(text) || port > MAX_PORT) {
    throw new StepError(
      `--port ${text}: should be a whole number up to ${MAX_PORT}; 0 takes any that is free`,
    );
  }
  return { port, host: values.host ? '0.0.0.0' : '127.0.0.1', withParent: values['with-parent'] };
}
