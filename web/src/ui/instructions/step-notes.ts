import { timesOf } from '../../instructions/build-steps.ts';
import { isGuest } from '../../instructions/guest-steps.ts';
import { fillWords } from '../../tools/tool-words.ts';
import { type Book, isTurned } from './book.ts';
import { instructionWords as words } from './instruction-words.ts';

export interface StepNotes {
  /** That the step belongs to a subassembly, how often that is built, and how many of it mirrored. */
  readonly apart: readonly string[];
  /** What to do besides putting parts in. */
  readonly turned: string | null;
  readonly warnings: readonly string[];
}

/** What a step says in words, on screen and on paper. */
export function notesOf(book: Book, index: number): StepNotes {
  const step = book.steps[index];
  if (!step) {
    return { apart: [], turned: null, warnings: [] };
  }
  const { group } = step;
  const times = timesOf(group);
  const mirrored = group.mirrored.filter(Boolean).length;
  const apart = [
    step.groupSteps > 1
      ? fillWords(words.sub, { n: step.groupStep, all: step.groupSteps })
      : words.subOnly,
    ...(times > 1 ? [fillWords(words.timesLabel, { n: times })] : []),
    ...(mirrored > 0 ? [fillWords(words.mirrored, { n: mirrored })] : []),
  ];
  // A finished model is what it is: nobody has to hold it.
  const finished = index === book.steps.length - 1;
  return {
    apart: group.id === 0 ? [] : apart,
    turned: isTurned(book, index) ? words.turned : null,
    warnings: [
      ...(step.stable || finished ? [] : [words.unstable]),
      ...(step.adds.some((add) => add.forced) ? [words.forced] : []),
      ...(step.adds.some((add) => add.parts.some((part) => isGuest(book.model, part)))
        ? [words.guests]
        : []),
    ],
  };
}
