import { LESSONS_DE } from '../text/de/lessons.ts';
import { LESSONS_EN } from '../text/en/lessons.ts';
import { chooseWords } from '../text/language.ts';

export const lessonWords = chooseWords(LESSONS_EN, LESSONS_DE);
