import type { ComponentType } from 'preact';
import type { lessonWords } from './lesson-words.ts';

export type LessonId = keyof typeof lessonWords.lessons;

/** One lesson: its words stand in the text files, what can be done in its own file. */
export interface Lesson {
  readonly id: LessonId;
  readonly load: () => Promise<ComponentType>;
}

export const LESSONS: readonly Lesson[] = [
  { id: 'graph', load: () => import('./graph-lesson.tsx').then((m) => m.GraphLesson) },
  { id: 'axes', load: () => import('./axes-lesson.tsx').then((m) => m.AxesLesson) },
  { id: 'annealing', load: () => import('./annealing-lesson.tsx').then((m) => m.AnnealingLesson) },
  { id: 'folding', load: () => import('./folding-lesson.tsx').then((m) => m.FoldingLesson) },
  { id: 'puzzle', load: () => import('./puzzle-lesson.tsx').then((m) => m.PuzzleLesson) },
  { id: 'apart', load: () => import('./apart-lesson.tsx').then((m) => m.ApartLesson) },
];
