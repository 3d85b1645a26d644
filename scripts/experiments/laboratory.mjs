// What every experiment is given: the command, sketches as files, runs, and the times that they took.
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { StepError, TOP } from '../lib/run.mjs';
import { inPapersCount } from '../lib/statistics.mjs';

const WORK = resolve(TOP, 'build/experiments');
const BUFFER = 1 << 30;

/** The paper's brick set: straight beams and the L beam of 3 by 5, no frames, no axles along lines. */
export const PAPERS_BRICKS = ['bent=32526', 'search.frames=0', 'search.axles=0'].flatMap((pair) => [
  '--set',
  pair,
]);

/** `--set key=value` for each pair. */
export function settings(pairs) {
  return pairs.flatMap((pair) => ['--set', pair]);
}

export class Laboratory {
  /** @param {{command: string, quick: boolean, seed: number}} options */
  constructor({ command, quick, seed }) {
    this.command = command;
    this.quick = quick;
    this.seed = seed;
    /** @type {{run: string, seconds: number}[]} */
    this.times = [];
    mkdirSync(resolve(WORK, 'sketches'), { recursive: true });
  }

  /** The first ones of a list where all would take too long. */
  some(items, count) {
    return this.quick ? items.slice(0, count) : items;
  }

  /** The file of a sketch that is not one yet. */
  fileOf(sketch) {
    const name = sketch.name.replaceAll(/[^\w]+/g, '-').toLowerCase();
    const file = resolve(WORK, 'sketches', `${name}.sketch.json`);
    writeFileSync(file, JSON.stringify(sketch));
    return file;
  }

  read(file) {
    return JSON.parse(readFileSync(file, 'utf8'));
  }

  /**
   * One run of `liftarm solve`.
   * @param {string} run what the times are to call it
   * @param {string} sketch file
   * @param {string[]} args
   * @returns {Record<string, any>} its report, gaps counted as the paper does
   * @throws {StepError} where the sketch or a setting is refused
   */
  solve(run, sketch, args) {
    return this.#solve(run, sketch, [...args, '--no-files']);
  }

  /** The same, and the model with it. */
  solveModel(run, sketch, args) {
    const folder = resolve(WORK, 'models');
    const report = this.#solve(run, sketch, [...args, '-o', folder]);
    const name = sketch.split('/').at(-1).replace('.sketch.json', '.model.json');
    return { report, model: this.read(resolve(folder, name)) };
  }

  #solve(run, sketch, args) {
    const all = ['solve', sketch, '--json', '--seed', `${this.seed}`, ...args];
    const result = spawnSync(this.command, all, { encoding: 'utf8', maxBuffer: BUFFER });
    if (result.status !== 0 && result.status !== 2) {
      throw new StepError(`${run}: ${result.stderr || result.error?.message}`);
    }
    const report = JSON.parse(result.stdout);
    this.times.push({ run, seconds: report.seconds.processor });
    return inPapersCount(report);
  }

  /** What `liftarm VERB SKETCH` tells. */
  tell(verb, sketch, args = []) {
    const all = [verb, sketch, ...args];
    return JSON.parse(execFileSync(this.command, all, { encoding: 'utf8', maxBuffer: BUFFER }));
  }

  /** Facts about parts, by number. */
  parts() {
    this.known ??= new Map(
      JSON.parse(
        execFileSync(this.command, ['parts'], { encoding: 'utf8', maxBuffer: BUFFER }),
      ).parts.map((part) => [part.id, part]),
    );
    return this.known;
  }

  /** Numbers of the beams of a model, each as often as it is there; a beam of one hole covers nothing. */
  beamsOf(model) {
    const isBeam = (part) => part?.class === 'beam' && part.features.length > 1;
    return model.parts.map(({ part }) => part).filter((id) => isBeam(this.parts().get(id)));
  }
}

/** "yes" or "no". */
export function yesNo(value) {
  return value ? 'yes' : 'no';
}

/** A number with at most so many digits after the point, without trailing noughts. */
export function rounded(value, digits = 2) {
  return value === null || value === undefined || !Number.isFinite(value)
    ? '-'
    : String(Number(value.toFixed(digits)));
}
