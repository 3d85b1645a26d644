// The seconds that each check of the model wing takes in the shipped WebAssembly module.
import { median } from './statistics.mjs';

/** What the page asks for, by name; each takes the model's text. */
const CHECKS = [
  ['buildable', (core, model) => core.checkModelJson(model)],
  ['motion', (core, model) => core.analyseMotionJson(model)],
  ['assembly', (core, model) => core.planAssemblyJson(model)],
  ['stress', (core, model) => core.analyseStressJson(model, '{}')],
];

/** @returns milliseconds on the wall and of the processor. */
function timed(action) {
  const processor = process.cpuUsage();
  const start = performance.now();
  action();
  const wall = performance.now() - start;
  const { user, system } = process.cpuUsage(processor);
  return { wall, processor: (user + system) / 1000 };
}

/**
 * Every check once, then `repeats` times more: the first call pays for the compiling of the module.
 * @returns {{check: string, first: number, wall: number, processor: number}[]} milliseconds
 */
export function timeChecks(core, model, repeats) {
  const answered = (check) => {
    const { status, text } = check(core, model);
    if (status !== 'ok') {
      throw new Error(text);
    }
  };
  const first = CHECKS.map(([, check]) => timed(() => answered(check)));
  return CHECKS.map(([name, check], i) => {
    const later = Array.from({ length: repeats }, () => timed(() => answered(check)));
    return {
      check: name,
      first: first[i].processor,
      wall: median(later.map(({ wall }) => wall)),
      processor: median(later.map(({ processor }) => processor)),
    };
  });
}
