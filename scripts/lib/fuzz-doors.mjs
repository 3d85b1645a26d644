// The two doors that `npm run fuzz` knocks at: the command, one process for each question, and the module that the page
// ships, in this process. Both answer with the report, or null where the input is refused; what else comes is thrown.
import { spawn } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { argumentsOf } from './fuzz-cases.mjs';
import { loadCore } from './load-core.mjs';

export const HANG_MS = 180_000;
const STEPS = 500; // of a search between two looks

function run(command, args) {
  return new Promise((done) => {
    const child = spawn(command, args, { timeout: HANG_MS, killSignal: 'SIGKILL' });
    let [out, err] = ['', ''];
    child.stdout.on('data', (text) => (out += text));
    child.stderr.on('data', (text) => (err += text));
    child.on('error', (error) => done({ code: -1, out, err: error.message }));
    child.on('close', (code, signal) => done({ code, signal, out, err }));
  });
}

function mustBeOneLine(message, what) {
  if (message.trim().split('\n').length !== 1 || message.trim() === '') {
    throw new Error(`${what}: refused with other than one line: ${message.slice(0, 500)}`);
  }
}

/** @throws {Error} where the command did not end as it must. */
function answerOf({ code, signal, out, err }, what) {
  if (signal !== null || code === null || code < 0 || code > 2) {
    throw new Error(`${what}: ended with ${signal ?? `code ${code}`}: ${err.slice(0, 500)}`);
  }
  if (code === 1) {
    mustBeOneLine(out === '' ? err : out + err, what);
  }
  return code === 1 ? null : JSON.parse(out);
}

/** @param {string} folder for files of one case at a time. */
export function commandDoor(command, folder) {
  const file = (name) => join(folder, name);
  let refusal = '';
  return {
    async solve(sketch, settings) {
      writeFileSync(file('case.sketch.json'), JSON.stringify(sketch));
      const args = ['solve', file('case.sketch.json'), '-o', folder, '--json'];
      const ended = await run(command, [...args, ...argumentsOf(settings)]);
      refusal = ended.err.trim();
      const report = answerOf(ended, 'solve');
      const text = (ending) => readFileSync(file(`case.${ending}`), 'utf8');
      return report && { report, modelText: text('model.json'), mpd: text('mpd') };
    },
    /** What the last sketch was refused with. */
    lastRefusal: () => refusal,
    async check(modelText, what) {
      writeFileSync(file('checked.json'), modelText);
      const args = ['check', file('checked.json'), '--json'];
      return answerOf(await run(command, args), `check of ${what}`);
    },
  };
}

function textOf({ status, text }, what) {
  if (status !== 'ok') {
    mustBeOneLine(text, what);
    return null;
  }
  return text;
}

/** Searches as the page does: in steps. @returns whether it ended within `steps` of them. */
function advance(session, steps = Number.POSITIVE_INFINITY) {
  for (let i = 0; i < steps; ++i) {
    if (session.advance(STEPS)) {
      return true;
    }
    JSON.parse(session.progressJson());
  }
  return false;
}

export async function moduleDoor() {
  const core = await loadCore();
  const withSession = (sketch, settings, work) => {
    const session = new core.SolverSession(JSON.stringify(sketch), JSON.stringify(settings));
    try {
      return textOf(session.opened(), 'solve') === null ? null : work(session);
    } finally {
      session.delete();
    }
  };
  return {
    solve: async (sketch, settings) =>
      withSession(sketch, settings, (session) => {
        advance(session);
        const modelText = session.modelJson();
        const mpd = textOf(core.exportModel(modelText, 'mpd'), '.mpd') ?? '';
        return { report: JSON.parse(session.reportJson()), modelText, mpd };
      }),
    async check(modelText, what) {
      const text = textOf(core.checkModelJson(modelText), `check of ${what}`);
      return text && JSON.parse(text);
    },
    /** A search given up after so many steps, with what it has by then looked at. */
    cancel: async (sketch, settings, steps) =>
      withSession(sketch, settings, (session) => {
        advance(session, steps);
        return session.modelJson();
      }),
  };
}
