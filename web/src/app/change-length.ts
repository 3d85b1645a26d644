import { type LengthRefusal, setLength } from '../state/line-length.ts';
import { fillWords } from '../tools/tool-words.ts';
import { text } from '../ui/text.ts';
import type { PageState } from './page-state.ts';
import type { LengthWish } from './scene-dimensions.ts';

/** Makes a line as long as a person typed. @returns why it cannot be, or null. */
export function changeLength({ store, announcement }: PageState, wish: LengthWish): string | null {
  const done = setLength(store.sketch.peek(), wish.index, wish);
  if (!done.ok) {
    return refusalWords(done.refusal);
  }
  store.commit(text.edits.length, done.sketch);
  announcement.value = text.edits.length;
  return null;
}

function refusalWords(refusal: LengthRefusal): string {
  const { lengthWhole, lengthStep, lengthHeld } = text.draw;
  switch (refusal.why) {
    case 'whole':
      return lengthWhole;
    case 'step':
      return fillWords(lengthStep, { n: refusal.step });
    case 'held':
      return lengthHeld;
  }
}
