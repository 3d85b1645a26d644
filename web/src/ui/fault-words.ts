import type { SketchFault } from '../state/sketch-faults.ts';
import { fillWords } from '../tools/tool-words.ts';
import { inWords } from './text/sentences.ts';
import { text } from './text.ts';

/** What is wrong, in one sentence. */
export function faultSentence(fault: SketchFault): string {
  const [a = 0, b = 0] = fault.lines;
  switch (fault.kind) {
    case 'twin':
      return fillWords(text.faults.twin, { a: a + 1, b: b + 1 });
    case 'crossing':
      return fillWords(text.faults.crossing, { a: a + 1, b: b + 1 });
    default:
      return placesInWords(inWords(fault.message));
  }
}

/** What the click that mends it says. */
export function mendWords(fault: SketchFault): string {
  switch (fault.kind) {
    case 'twin':
      return text.faults.mendTwin;
    case 'crossing':
      return text.faults.mendCrossing;
    case 'moved':
    case 'open':
      return text.faults.mendMoved;
    default:
      return 'mend' in fault && fault.mend.some(({ line }) => line === undefined)
        ? text.faults.mendLine
        : text.faults.mendNear;
  }
}

/** The core counts lines from 0 and names them as the file does; people count from 1. */
export function placesInWords(sentence: string): string {
  const said = sentence.replace(/lines\[(\d+)\](?:\.(from|to))?/g, (_, index: string, end) => {
    const { line, from, to } = text.faults;
    const words = end === 'from' ? from : end === 'to' ? to : line;
    return fillWords(words, { n: Number(index) + 1 });
  });
  return said.charAt(0).toUpperCase() + said.slice(1) + (/[.!?]$/.test(said) ? '' : '.');
}
