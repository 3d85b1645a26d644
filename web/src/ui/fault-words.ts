import type { SketchFault } from '../state/sketch-faults.ts';
import { fillWords } from '../tools/tool-words.ts';
import { text } from './text.ts';

/** What is wrong, in one sentence. */
export function faultSentence(fault: SketchFault): string {
  const [a, b] = fault.lines;
  const words = fault.kind === 'twin' ? text.faults.twin : text.faults.crossing;
  return fillWords(words, { a: a + 1, b: b + 1 });
}

/** What the click that mends it says. */
export function mendWords(fault: SketchFault): string {
  return fault.kind === 'twin' ? text.faults.mendTwin : text.faults.mendCrossing;
}
