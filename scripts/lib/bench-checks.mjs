// The seconds that each check of the model wing takes in the shipped WebAssembly module.
import { readFileSync } from 'node:fs';
import { median } from './statistics.mjs';

/** What the page asks for, by name: a function of the module, and what follows the model's text. */
export const CHECKS = [
  ['buildable', 'checkModelJson', []],
  ['motion', 'analyseMotionJson', []],
  ['assembly', 'planAssemblyJson', []],
  ['stress', 'analyseStressJson', ['{}']],
];

/**
 * Milliseconds that the processor spent on this thread. What all threads take includes the compiler, which
 * makes faster code beside the first calls: nobody waits for it where a core is free.
 */
function threadMs() {
  try {
    const stat = readFileSync(`/proc/self/task/${process.pid}/schedstat`, 'utf8');
    return Number(stat.split(' ')[0]) / 1e6;
  } catch {
    return performance.now(); // no Linux: the clock on the wall
  }
}

/** @returns milliseconds of this thread, of all threads and on the wall. */
function timed(action) {
  const processor = process.cpuUsage();
  const start = performance.now();
  const thread = threadMs();
  action();
  const own = threadMs() - thread;
  const wall = performance.now() - start;
  const { user, system } = process.cpuUsage(processor);
  return { own, all: (user + system) / 1000, wall };
}

/**
 * Every check once, then `repeats` times more.
 * @returns {{check: string, first: {own: number, all: number, wall: number}, later: {own: number, all:
 *     number, wall: number}}[]} milliseconds; `later` are medians
 */
export function timeChecks(core, model, repeats) {
  const answered = (name, more) => {
    const { status, text } = core[name](model, ...more);
    if (status !== 'ok') {
      throw new Error(text);
    }
  };
  const first = CHECKS.map(([, name, more]) => timed(() => answered(name, more)));
  return CHECKS.map(([check, name, more], i) => {
    const times = Array.from({ length: repeats }, () => timed(() => answered(name, more)));
    const middle = (key) => median(times.map((time) => time[key]));
    return {
      check,
      first: first[i],
      later: { own: middle('own'), all: middle('all'), wall: middle('wall') },
    };
  });
}
