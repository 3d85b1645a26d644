import { lessonWords } from './lesson-words.ts';

/** Says that the task is done; screen readers hear it. */
export function Praise({ when, words }: { readonly when: boolean; readonly words: string }) {
  return (
    <p class="praise" role="status" data-testid="praise">
      {when ? `${words} ${lessonWords.done}` : ''}
    </p>
  );
}
